// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace ink
{

/// Disjoint sets of the numbers below a count, each known by its least: for one thread, or for several whose
/// sets stay apart.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0u);
  }
  /// Whether the sets were distinct.
  bool join(std::uint32_t a, std::uint32_t b)
  {
    a = this->least(a);
    b = this->least(b);
    this->Parents[std::max(a, b)] = std::min(a, b);
    return a != b;
  }
  std::uint32_t least(std::uint32_t i)
  {
    while (this->Parents[i] != i)
    {
      i = this->Parents[i] = this->Parents[this->Parents[i]];
    }
    return i;
  }

private:
  std::vector<std::uint32_t> Parents;
};

} // namespace ink
