// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{

/// Which points form which polyline: polyline n connects the points offsets[n] to offsets[n + 1] - 1 in
/// order, and a closed one its last point with its first, which is not repeated. Points are kept by whoever
/// has these, polyline after polyline.
struct Polylines
{
  std::vector<std::size_t> offsets = { 0 }; ///< one more than polylines
  std::vector<std::uint8_t> closed;         ///< one per polyline

  std::size_t size() const { return this->closed.size(); }
  std::size_t pointCount() const { return this->offsets.back(); }
  std::size_t segmentCount(std::size_t polyline) const
  {
    const std::size_t points = this->offsets[polyline + 1] - this->offsets[polyline];
    return this->closed[polyline] || points == 0 ? points : points - 1;
  }
};

} // namespace ink
