// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/CellBricks.h"

#include "Core/MortonOrder.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "IsoSurface/ActiveCells.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace ink
{
namespace
{

/// The bricks of one slab of cells, whose layers are in order.
std::vector<CellBrick> bricksOf(const ActiveCells::Slab& slab)
{
  std::vector<CellBrick> bricks;
  const auto brickOf = [](const glm::ivec3& cell) { return cell / CellBrick::width * CellBrick::width; };
  for (const CellRun& run : slab.runs)
  {
    for (std::uint64_t left = run.cells; left != 0; left &= left - 1)
    {
      const glm::ivec3 cell = run.first + glm::ivec3(std::countr_zero(left), 0, 0);
      const glm::ivec3 in = cell - brickOf(cell);
      const std::uint64_t bit = std::uint64_t{ 1 } << (in.x + 4 * in.y + 16 * in.z);
      if (!bricks.empty() && bricks.back().first == brickOf(cell))
      {
        bricks.back().cells |= bit;
      }
      else
      {
        bricks.push_back({ brickOf(cell), bit });
      }
    }
  }
  return bricks;
}

std::uint64_t orderOf(const CellBrick& brick)
{
  return mortonOf(glm::uvec3(brick.first / CellBrick::width));
}

} // namespace

std::vector<CellBrick> collectBricks(const ActiveCells& cells)
{
  std::vector<std::vector<CellBrick>> bySlab(cells.slabs.size());
  parallelFor(cells.slabs.size(), [&](std::size_t slab) { bySlab[slab] = bricksOf(cells.slabs[slab]); });
  std::vector<CellBrick> bricks;
  for (const std::vector<CellBrick>& some : bySlab)
  {
    bricks.insert(bricks.end(), some.begin(), some.end());
  }
  // The rows of one brick come one after the other.
  parallelSort(bricks.begin(), bricks.end(),
    [](const CellBrick& a, const CellBrick& b) { return orderOf(a) < orderOf(b); });
  std::size_t count = 0;
  for (const CellBrick& brick : bricks)
  {
    if (count > 0 && bricks[count - 1].first == brick.first)
    {
      bricks[count - 1].cells |= brick.cells;
    }
    else
    {
      bricks[count++] = brick;
    }
  }
  bricks.resize(count);
  return bricks;
}

} // namespace ink
