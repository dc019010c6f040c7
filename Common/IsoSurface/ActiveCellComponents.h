// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCellId.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The connected components of an iso-surface's active cells. Cells are neighbors if they share a face: a
/// continuous surface enters the next cell through one.
struct ActiveCellComponents
{
  std::vector<std::uint32_t> labels; ///< of each cell; components are numbered by their first cell
  std::vector<std::size_t> counts;   ///< the cells of each component
};

/// Union-find in parallel; the result is the same for any number of threads.
/// @param cells ascending, each once, fewer than 2^32
/// @throws std::invalid_argument if they are not ascending or too many
ActiveCellComponents findActiveCellComponents(std::span<const ActiveCellId> cells);

/// Which components of a surface to keep.
struct ComponentSelection
{
  /// As smallestShare, like any negative number: 1/1000, but at least `speck` cells as far as that is less
  /// than a tenth of the largest component.
  static constexpr double automatic = -1.0;
  static constexpr std::size_t speckCells = 27;

  double smallestShare = 0.0;     ///< those with at least this share of the largest one's cells; or automatic
  std::size_t largest = 0;        ///< so many of the largest, the first ones among equals; 0: all
  std::size_t speck = speckCells; ///< more where cells are parts of a voxel, see inDividedCells

  /// The same selection where voxels are divided into so many cells along each axis.
  ComponentSelection inDividedCells(int subdivision) const
  {
    return { this->smallestShare, this->largest, this->speck * subdivision * subdivision };
  }

  bool keepsAll() const { return this->smallestShare == 0.0 && this->largest == 0; }
};

/// Whether each component is kept, by the number of its cells.
std::vector<char> selectComponents(std::span<const std::size_t> counts, const ComponentSelection& selection);

} // namespace ink
