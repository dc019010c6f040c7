// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/SampledTile.h"

#include "Core/ParallelFor.h"
#include "IsoSurface/SampleWriter.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>

namespace ink
{

namespace
{

void copySamples(const SampledTile& tile, std::size_t from, std::size_t count, const SampleRoom& to)
{
  const auto copy = [&](const auto& numbers, auto* written, const auto& convert)
  {
    if (written)
    {
      std::transform(numbers.begin() + 3 * from, numbers.begin() + 3 * (from + count), written, convert);
    }
  };
  copy(tile.points, to.points, std::identity());
  copy(tile.doublePoints, to.doublePoints, std::identity());
  copy(tile.normals, to.normals, std::identity());
  copy(tile.normals, to.shortNormals, quantized<std::int16_t>);
  copy(tile.normals, to.byteNormals, quantized<std::int8_t>);
  if (to.cells)
  {
    std::copy_n(tile.cells.begin() + from, count, to.cells);
  }
}

} // namespace

void writeTiles(std::span<SampledTile> tiles, std::span<const std::size_t> counts, const GrowRoom& grow)
{
  const SampleRoom room = grow(std::accumulate(counts.begin(), counts.end(), std::size_t(0)));
  // Where the samples of the next tile belong.
  std::vector<std::size_t> next(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - !counts.empty(), next.begin() + !counts.empty());
  for (SampledTile& tile : tiles)
  {
    tile.starts = next;
    for (std::size_t t = 0; t < tile.counts.size(); ++t)
    {
      next[t] += tile.counts[t];
    }
  }
  parallelFor(tiles.size(),
    [&](std::size_t n)
    {
      std::size_t from = 0;
      for (std::size_t t = 0; t < tiles[n].counts.size(); ++t)
      {
        const SampleRoom to = roomAfter(room, tiles[n].starts[t]);
        copySamples(tiles[n], from, tiles[n].counts[t], to);
        from += tiles[n].counts[t];
      }
      tiles[n] = {};
    });
}

} // namespace ink
