// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>

namespace ink::raster
{

/// The ink coverage of each pixel of a drawing, 0 (none) to 255 (full); row by row, the bottom row first.
struct CoverageImage
{
  std::span<unsigned char> pixels; ///< width x height
  int width = 0;
  int height = 0;

  unsigned char* row(int y) const
  {
    return this->pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(this->width);
  }

  /// @throws std::invalid_argument when the number of pixels is not width x height
  void check() const
  {
    if (this->width < 0 || this->height < 0 ||
      this->pixels.size() != static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height))
    {
      throw std::invalid_argument("a picture of ink must have width x height pixels");
    }
  }
};

} // namespace ink::raster
