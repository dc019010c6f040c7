// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

namespace ink::raster
{

/// The first x from `x` on with ink in a row of pixels, or the row's width.
inline int skipEmpty(const unsigned char* row, int x, int width)
{
  std::uint64_t word = 0;
  for (; x + 8 <= width; x += 8)
  {
    std::memcpy(&word, row + x, 8);
    if (word != 0)
    {
      break;
    }
  }
  while (x < width && row[x] == 0)
  {
    ++x;
  }
  return x;
}

} // namespace ink::raster
