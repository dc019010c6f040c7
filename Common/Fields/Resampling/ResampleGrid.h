// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"
#include "Fields/Resampling/TileResampler.h"

#include <tbb/enumerable_thread_specific.h>

#include <stdexcept>
#include <string>

namespace ink
{

/// The values of a grid at the positions of a box, x fastest: NaN where samples are missing, see
/// TileResampler. The same for any number of threads, and in any box.
/// @param values output: of all positions of the box
/// @return false when `progress` asked to stop
/// @throws std::invalid_argument unless there is one value for each position
template <class T, class Work>
bool resampleGrid(const GridField<T>& field, const GridResampling& resampling, const SampleBox& positions,
  std::span<Work> values, const Progress& progress = {})
{
  // What a tile depends on stays in the cache from one axis to the next.
  constexpr glm::ivec3 tile(64, 32, 32);
  if (values.size() != positions.count())
  {
    throw std::invalid_argument("a resampled grid: expected room for " + std::to_string(positions.count()) +
      " values, found " + std::to_string(values.size()));
  }
  const glm::ivec3 subdivision(
    resampling[0].subdivision(), resampling[1].subdivision(), resampling[2].subdivision());
  const glm::ivec3 reach(resampling[0].reach(), resampling[1].reach(), resampling[2].reach());
  const glm::ivec3 all = positions.size();
  const glm::ivec3 tiles = (all + tile - 1) / tile;
  struct Workspace
  {
    TileResampler<Work> resampler;
    std::vector<Work> values;
  };
  tbb::enumerable_thread_specific<Workspace> workspaces;
  const auto resample = [&](std::size_t n)
  {
    Workspace& work = workspaces.local();
    const int i = static_cast<int>(n);
    const glm::ivec3 begin = tile * glm::ivec3(i % tiles.x, i / tiles.x % tiles.y, i / tiles.x / tiles.y);
    const SampleBox box = { positions.begin + begin, positions.begin + glm::min(begin + tile, all) };
    work.resampler.read(field, box, subdivision, reach);
    work.resampler.resample(resampling, box, work.values);
    const glm::ivec3 size = box.size();
    auto from = work.values.begin();
    for (int k = 0; k < size.z; ++k)
    {
      for (int j = 0; j < size.y; ++j, from += size.x)
      {
        const std::size_t row =
          static_cast<std::size_t>(begin.z + k) * all.y + static_cast<std::size_t>(begin.y + j);
        std::copy_n(from, size.x, values.begin() + static_cast<std::ptrdiff_t>(row * all.x + begin.x));
      }
    }
  };
  return parallelFor(SampleBox{ glm::ivec3(0), tiles }.count(), resample, progress);
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
