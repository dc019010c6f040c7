#pragma once

#include <cstdint>
#include <cstring>

namespace ink
{

/// The first x from `x` on where a row of pixels holds ink, or its width.
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

} // namespace ink
