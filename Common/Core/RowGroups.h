// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace ink
{

/// Splits rows that are added up into groups whose size the compiler knows, so that a group's rows stay in
/// registers and the sums are loaded and stored once for all of them: calls `add.template
/// operator()<size>(first)` for each group, of four rows and last of what is left.
template <class Add>
void forEachRowGroup(std::size_t rows, const Add& add)
{
  constexpr std::size_t most = 4;
  for (std::size_t first = 0; first < rows; first += most)
  {
    switch (std::min(rows - first, most))
    {
      case 1:
        add.template operator()<1>(first);
        break;
      case 2:
        add.template operator()<2>(first);
        break;
      case 3:
        add.template operator()<3>(first);
        break;
      default:
        add.template operator()<most>(first);
    }
  }
}

} // namespace ink
