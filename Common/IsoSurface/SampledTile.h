// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/IsoSurfaceSamples.h"

#include <cstddef>
#include <span>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// The samples of one tile, sorted by iso-value.
struct SampledTile
{
  std::vector<std::size_t> counts;
  std::vector<std::size_t> starts; ///< where those of each iso-value belong in the output
  std::vector<float> points;
  std::vector<double> doublePoints; ///< instead of points
  std::vector<float> normals;
  std::vector<ActiveCellId> cells;
};

/// Writes the samples of all tiles, sorted by iso-value, and takes them from the tiles.
/// @param counts the samples of each iso-value in all tiles
void writeTiles(std::span<SampledTile> tiles, std::span<const std::size_t> counts, const GrowRoom& grow);

} // namespace ink
