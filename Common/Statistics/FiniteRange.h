// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <span>

namespace ink
{

/// The finite range of a volume; ranges of its parts can be merged.
struct FiniteRange
{
  /// Of the finite values; least is greater than greatest if there are none.
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  std::uint64_t notFinite = 0; ///< values that are NaN or infinite

  void add(const FiniteRange& other);
};

/// @tparam T any of the scalar types of VTK.
template <typename T>
FiniteRange findFiniteRange(std::span<const T> values);

} // namespace ink
