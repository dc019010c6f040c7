// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Vdb/VdbGrid.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The active cells of an iso-surface in a sparse grid. Cell (i, j, k) has the voxels (i, j, k) to (i + 1, j
/// + 1, k + 1) as corners. Sorted by blocks of 8^3 cells, by k, then j, then i of their first cell; within a
/// block by k, then j, then i.
struct VdbActiveCells
{
  /// Bit 8 j + i of cells[k] stands for the cell first + (i, j, k).
  struct Block
  {
    glm::ivec3 first;
    /// The number of cells in all blocks before this one.
    std::size_t before;
    std::array<std::uint64_t, 8> cells;
  };

  std::vector<Block> blocks;
  std::size_t count = 0;
};

/// Finds the same cells as findActiveCells in a dense copy of the grid surrounded by its background, but
/// reads only leaves and the borders of tiles. Inactive voxels and tiles count with their values; cells with
/// a corner that is outside the grid's domain, NaN or infinite are never active. One difference: where a tile
/// or the background is exactly the iso-value, CrossingRule::Strict makes every cell of the dense copy
/// active; here, only those next to a leaf.
/// @param negate the values are multiplied by -1 first
/// @param memory limit of the search in bytes: the border of a few tiles, which take hardly any memory
///   themselves, may have millions of cells
/// @return the cells, the same for any number of threads; none when `progress` asked to stop
/// @throws VdbTooLarge
VdbActiveCells findActiveCells(const VdbGrid& grid, double isoValue, CrossingRule rule, bool negate,
  const Progress& progress = {}, std::uint64_t memory = VdbGrid::noLimit);

/// Places one sample in each of the given cells, like placeIsoSurfaceSamples for a dense grid: points and
/// normals are bitwise equal.
/// @param cells from findActiveCells with the same grid, isoValue, options.rule and negate
/// @param points 3 * cells.count numbers; Real is float or double
/// @param normals 3 * cells.count numbers, or empty for none
/// @throws std::invalid_argument when a span has the wrong length
/// @return false when `progress` asked to stop; then some samples are missing
template <class Real>
bool placeIsoSurfaceSamples(const VdbGrid& grid, double isoValue, const SampleOptions& options, bool negate,
  const VdbActiveCells& cells, std::span<Real> points, std::span<float> normals,
  const Progress& progress = {});

} // namespace ink
