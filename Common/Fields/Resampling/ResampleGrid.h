// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Resampling/TileResampler.h"

#include <functional>
#include <span>

namespace ink
{

/// TileResampler::read of a grid, for boxes of positions.
template <class Work>
using TileReader = std::function<void(const SampleBox& positions, TileResampler<Work>& tile)>;

/// resampleGrid, whatever the type of the grid's values. Work is float or double.
template <class Work>
bool resampleTiles(const TileReader<Work>& read, const GridResampling& resampling, const SampleBox& positions,
  std::span<Work> values, const Progress& progress);

/// The values of a grid at the positions of a box, x fastest: NaN where samples are missing, see
/// TileResampler. The same for any number of threads, and in any box.
/// @param values output: of all positions of the box
/// @return false when `progress` asked to stop
/// @throws std::invalid_argument unless there is one value for each position
template <class T, class Work>
bool resampleGrid(const GridField<T>& field, const GridResampling& resampling, const SampleBox& positions,
  std::span<Work> values, const Progress& progress = {})
{
  const glm::ivec3 subdivision(
    resampling[0].subdivision(), resampling[1].subdivision(), resampling[2].subdivision());
  const glm::ivec3 reach(resampling[0].reach(), resampling[1].reach(), resampling[2].reach());
  const auto read = [&](const SampleBox& box, TileResampler<Work>& tile)
  { tile.read(field, box, subdivision, reach); };
  return resampleTiles<Work>(read, resampling, positions, values, progress);
}

/// The same of all positions.
template <class T, class Work>
bool resampleGrid(const GridField<T>& field, const GridResampling& resampling, std::span<Work> values,
  const Progress& progress = {})
{
  const glm::ivec3 positions(resampling[0].positions(), resampling[1].positions(), resampling[2].positions());
  return resampleGrid(field, resampling, SampleBox{ glm::ivec3(0), positions }, values, progress);
}

} // namespace ink
