// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/CellBricks.h"
#include "Simd/BrickView.h"

#include <glm/vec3.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <functional>

namespace ink
{

/// A set of the samples at the corners of a brick's cells: bits of its layers as in BrickView.
class BrickSamples
{
public:
  static constexpr int width = BrickView::width;
  static_assert(width == CellBrick::width + 1);
  using Layers = std::array<std::uint32_t, width>;

  /// The corners of cells.
  explicit BrickSamples(std::uint64_t cells)
  {
    for (int z = 0; z < CellBrick::width; ++z)
    {
      std::uint32_t corners = 0;
      for (int y = 0; y < CellBrick::width; ++y)
      {
        const std::uint32_t row = cells >> (16 * z + 4 * y) & 15;
        corners |= (row | row << 1) << width * y | (row | row << 1) << width * (y + 1);
      }
      this->Bits[z] |= corners;
      this->Bits[z + 1] |= corners;
    }
  }

  const Layers& layers() const { return this->Bits; }

  static int indexOf(const glm::ivec3& inBrick)
  {
    return inBrick.x + BrickView::rowSize * inBrick.y + BrickView::layerSize * inBrick.z;
  }
  static glm::ivec3 sampleOf(int index)
  {
    return { index % BrickView::rowSize, index / BrickView::rowSize % width, index / BrickView::layerSize };
  }

  /// Calls visit(sample in the brick) for each, in order.
  template <class Visit>
  void forEach(const Visit& visit) const
  {
    for (int z = 0; z < width; ++z)
    {
      for (std::uint32_t left = this->Bits[z]; left != 0; left &= left - 1)
      {
        const int bit = std::countr_zero(left);
        visit(glm::ivec3(bit % width, bit / width, z));
      }
    }
  }

private:
  Layers Bits{};
};

/// The cells of a brick that have corners in a set, given by its layers, as well as outside.
inline std::uint64_t mixedCells(const std::uint32_t (&layers)[BrickView::width])
{
  constexpr int width = BrickView::width;
  std::uint64_t cells = 0;
  for (int z = 0; z < CellBrick::width; ++z)
  {
    const auto shifted = [](std::uint32_t layer, auto join)
    { return join(join(layer, layer >> 1), join(layer >> width, layer >> (width + 1))); };
    const std::uint32_t all = shifted(layers[z] & layers[z + 1], std::bit_and<>());
    const std::uint32_t any = shifted(layers[z] | layers[z + 1], std::bit_or<>());
    const std::uint64_t mixed = any & ~all;
    for (int y = 0; y < CellBrick::width; ++y)
    {
      cells |= (mixed >> width * y & 15) << (16 * z + 4 * y);
    }
  }
  return cells;
}

/// The corners of a brick's cell that are in a set: bit c for corner c = x + 2 y + 4 z.
inline unsigned cornersOf(const std::uint32_t (&layers)[BrickView::width], const glm::ivec3& cell)
{
  constexpr int width = BrickView::width;
  const int shift = cell.x + width * cell.y;
  const unsigned low = layers[cell.z] >> shift;
  const unsigned high = layers[cell.z + 1] >> shift;
  return (low & 3) | (low >> width & 3) << 2 | (high & 3) << 4 | (high >> width & 3) << 6;
}

} // namespace ink
