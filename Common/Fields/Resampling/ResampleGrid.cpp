// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Resampling/ResampleGrid.h"

#include "Core/ParallelFor.h"

#include <tbb/enumerable_thread_specific.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace ink
{

template <class Work>
bool resampleTiles(const TileReader<Work>& read, const GridResampling& resampling, const SampleBox& positions,
  std::span<Work> values, const Progress& progress)
{
  // What a tile depends on stays in the cache from one axis to the next.
  constexpr glm::ivec3 tile(64, 32, 32);
  if (values.size() != positions.count())
  {
    throw std::invalid_argument("a resampled grid: expected room for " + std::to_string(positions.count()) +
      " values, found " + std::to_string(values.size()));
  }
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
    read(box, work.resampler);
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

template bool resampleTiles(
  const TileReader<float>&, const GridResampling&, const SampleBox&, std::span<float>, const Progress&);
template bool resampleTiles(
  const TileReader<double>&, const GridResampling&, const SampleBox&, std::span<double>, const Progress&);

} // namespace ink
