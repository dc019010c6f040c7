// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace ink
{

struct ActiveCells;

/// Some of a brick of 4 x 4 x 4 cells: bit x + 4 y + 16 z stands for the cell first + (x, y, z).
struct CellBrick
{
  static constexpr int width = 4;

  glm::ivec3 first; ///< a multiple of the width
  std::uint64_t cells;

  static glm::ivec3 cell(int bit) { return { bit & 3, bit >> 2 & 3, bit >> 4 }; }
};

/// The bricks that hold active cells, in Morton order, in which neighbors in space are mostly close.
std::vector<CellBrick> collectBricks(const ActiveCells& cells);

} // namespace ink
