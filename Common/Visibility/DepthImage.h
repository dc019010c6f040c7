// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>

namespace ink
{

/// The depths of a picture as OpenGL has them: 0 at the near plane, 1 at the far one or where nothing is.
struct DepthImage
{
  std::span<const float> depths; ///< width x height, row by row, the bottom row first
  int width = 0;
  int height = 0;

  float at(int x, int y) const
  {
    return this->depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(this->width) +
      static_cast<std::size_t>(x)];
  }

  /// @throws std::invalid_argument when the number of depths is not width x height
  void check() const
  {
    if (this->width < 0 || this->height < 0 ||
      this->depths.size() != static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height))
    {
      throw std::invalid_argument("a depth image must have width x height depths");
    }
  }
};

} // namespace ink
