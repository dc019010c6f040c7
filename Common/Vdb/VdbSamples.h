#pragma once

#include "Parallel/ParallelFor.h"
#include "Sampling/IsoSurfaceSamples.h"
#include "Vdb/VdbGrid.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The cells of a sparse grid that an iso-surface crosses. Cell (i, j, k) has the voxels (i, j, k) to
/// (i + 1, j + 1, k + 1) as its corners. Their order: blocks of 8^3 cells by k, then j, then i of their first
/// cell; the cells of a block by k, then j, then i.
struct VdbCrossedCells
{
  /// Bit 8 j + i of cells[k] stands for the cell first + (i, j, k).
  struct Block
  {
    glm::ivec3 first;
    /// How many cells the blocks before this one hold.
    std::size_t before;
    std::array<std::uint64_t, 8> cells;
  };

  std::vector<Block> blocks;
  std::size_t count = 0;
};

/// Finds the cells that findCrossedCells finds in the dense copy of the same grid, its background all around,
/// but looks at leaves and at the borders of tiles only. Inactive voxels and tiles count with their values;
/// cells with a corner outside the grid's domain, or with one that is NaN or infinite, are none. One thing
/// differs: where a tile or the background is exactly the iso-value, CrossingRule::Strict takes every cell of
/// the dense copy for a flat piece of the surface; here, only those beside a leaf are looked at.
/// \param negate the values are multiplied by -1 first
/// \param memory the most bytes that finding them may take: the border of a few tiles, which take next to
///               nothing themselves, may have millions of cells
/// \returns the cells, the same for any number of threads; none when `progress` asked to stop
/// \throws VdbTooLarge
VdbCrossedCells findCrossedCells(const VdbGrid& grid, double isoValue, CrossingRule rule, bool negate,
  const Progress& progress = {}, std::uint64_t memory = VdbGrid::noLimit);

/// Places one sample in each of the given cells, as placeIsoSurfaceSamples does for a dense grid: the same
/// points and normals to the bit.
/// \param cells   from findCrossedCells with the same grid, isoValue, options.rule and negate
/// \param points  3 * cells.count numbers; Real is float or double
/// \param normals 3 * cells.count numbers, or empty for none
/// \throws std::invalid_argument when a span has another length
/// \returns false when `progress` asked to stop; then some samples were left out
template <class Real>
bool placeIsoSurfaceSamples(const VdbGrid& grid, double isoValue, const SampleOptions& options, bool negate,
  const VdbCrossedCells& cells, std::span<Real> points, std::span<float> normals,
  const Progress& progress = {});

} // namespace ink
