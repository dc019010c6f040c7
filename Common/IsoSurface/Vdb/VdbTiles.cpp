// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/Vdb/VdbTiles.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Vdb/VdbError.h"
#include "IsoSurface/Vdb/VdbSamples.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>

namespace ink
{
namespace
{

/// Cells along the edge of a tile: large against what smoothing reads around it, small against a thread's
/// cache.
constexpr int tileEdge = 32;

/// The edge of VdbActiveCells' blocks.
constexpr int blockEdge = 8;

glm::ivec3 tileOf(const glm::ivec3& cell)
{
  // Right shifts round downwards.
  return { cell.x >> 5, cell.y >> 5, cell.z >> 5 };
}
static_assert(1 << 5 == tileEdge);

/// A tile's samples, those of one surface after the other.
template <class Real>
struct TileSamples
{
  std::vector<std::size_t> counts;
  std::vector<Real> points;
  std::vector<float> normals;
  std::vector<ActiveCellId> cells;
};

template <class Real>
class VdbTileSampler
{
public:
  VdbTileSampler(const VdbGrid& grid, std::span<const double> isoValues, const VdbTileOptions& options)
    : Grid(grid)
    , IsoValues(isoValues)
    , Options(options)
    , Domain(grid.domain())
    , Resampling(makeIsoSurfaceResampling(grid.geometry(grid.activeBox()), options.smoothing,
        options.subdivision, options.target, options.ofMask, options.shapeBased))
    , Parts(options.parts)
    , Reach(isoSurfaceResamplingReach(options.smoothing, options.subdivision, this->Resampling.slices) +
        (options.projectionSteps > 0 ? 1 : 0))
  {
    this->Resampling.borders = options.borders;
  }

  bool run(VdbTileSamples<Real>& samples, const Progress& progress)
  {
    const auto partOf = [&progress](double begin, double end)
    { return [&, begin, end](double done) { return !progress || progress(begin + done * (end - begin)); }; };
    if (!this->findTiles(partOf(0.0, 0.3)))
    {
      return false;
    }
    const bool parts = !this->Parts.keepsAll();
    const auto at = [&](int piece)
    {
      return this->Tiles.size() * static_cast<std::size_t>(piece) /
        static_cast<std::size_t>(this->Options.pieces);
    };
    const std::size_t first = at(this->Options.piece);
    const std::size_t last = at(this->Options.piece + 1);
    const std::size_t begin = parts ? 0 : first;
    const std::size_t count = (parts ? this->Tiles.size() : last) - begin;
    this->Samples.assign(this->Tiles.size(), {});
    const auto sample = [&](std::size_t n)
    {
      const bool isDouble = this->Grid.info().isDouble;
      isDouble ? this->sampleTile<double>(begin + n) : this->sampleTile<float>(begin + n);
    };
    if (!parallelFor(count, sample, partOf(0.3, 1.0)))
    {
      return false;
    }
    if (parts)
    {
      this->keepParts();
    }
    this->write(first, last, samples);
    return true;
  }

private:
  bool findTiles(const Progress& progress)
  {
    double cells = 0.0;
    for (std::size_t n = 0; n < this->IsoValues.size(); ++n)
    {
      const auto part = [&](double done)
      {
        return !progress ||
          progress((static_cast<double>(n) + done) / static_cast<double>(this->IsoValues.size()));
      };
      bool done = true;
      const auto watched = [&](double share) { return done = part(share); };
      const VdbActiveCells active = findActiveCells(this->Grid, this->IsoValues[n],
        this->Options.samples.rule, this->Options.negate, watched, this->Options.memory);
      if (!done)
      {
        return false;
      }
      cells += static_cast<double>(active.count);
      for (const VdbActiveCells::Block& block : active.blocks)
      {
        this->addTiles(block.first - this->Reach, block.first + blockEdge - 1 + this->Reach);
      }
    }
    if (this->Options.cut == CutSurface::Cap && this->Grid.info().domain)
    {
      this->addSides();
    }
    this->checkSize(cells);
    const auto before = [](const glm::ivec3& a, const glm::ivec3& b)
    { return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x); };
    std::sort(this->Tiles.begin(), this->Tiles.end(), before);
    this->Tiles.erase(std::unique(this->Tiles.begin(), this->Tiles.end()), this->Tiles.end());
    return true;
  }

  void addTiles(const glm::ivec3& firstCell, const glm::ivec3& lastCell)
  {
    const glm::ivec3 low = tileOf(glm::max(firstCell, this->Domain.first));
    const glm::ivec3 high = tileOf(glm::min(lastCell, this->Domain.last - 1));
    for (glm::ivec3 tile = low; tile.z <= high.z; ++tile.z)
    {
      for (tile.y = low.y; tile.y <= high.y; ++tile.y)
      {
        for (tile.x = low.x; tile.x <= high.x; ++tile.x)
        {
          // Blocks are in order, so that most of their tiles were just added.
          if (std::find(this->Tiles.end() - std::min<std::ptrdiff_t>(8, std::ssize(this->Tiles)),
                this->Tiles.end(), tile) == this->Tiles.end())
          {
            this->Tiles.push_back(tile);
          }
        }
      }
    }
  }

  /// Those along the sides of the domain, which a cap covers.
  void addSides()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::ivec3 low = this->Domain.first;
      glm::ivec3 high = this->Domain.last - 1;
      high[axis] = low[axis];
      this->addTiles(low, high);
      low[axis] = high[axis] = this->Domain.last[axis] - 1;
      this->addTiles(low, high);
    }
  }

  /// Of what is kept at a time, without rims and caps.
  void checkSize(double cells)
  {
    const glm::dvec3 divided(this->Resampling.subdivision);
    // A surface is divided along two axes.
    const double each = divided.x * divided.y * divided.z / std::min({ divided.x, divided.y, divided.z });
    // Parts are chosen from the whole surface.
    const double points = cells * each / (this->Parts.keepsAll() ? this->Options.pieces : 1);
    constexpr double bytes = 2.0 * (3 * sizeof(Real) + 3 * sizeof(float) + sizeof(ActiveCellId));
    if (points * bytes > static_cast<double>(this->Options.memory))
    {
      throw VdbTooLarge("the surface has about " + std::to_string(static_cast<std::uint64_t>(points)) +
        " points, which take " + std::to_string(static_cast<std::uint64_t>(points * bytes / 0x1p20)) +
        " MiB");
    }
    // The ids of cells, by which parts are found.
    constexpr int most = (1 << 20) - 2;
    const VoxelBox box = this->Grid.activeBox();
    const glm::dvec3 farthest =
      glm::max(glm::abs(glm::dvec3(box.first)), glm::abs(glm::dvec3(box.last))) + glm::dvec3(this->Reach + 1);
    if (this->Parts.keepsAll() || glm::all(glm::lessThanEqual(farthest * divided, glm::dvec3(most))))
    {
      return;
    }
    if (this->Parts.smallestShare >= 0.0 || this->Parts.largest > 0)
    {
      throw std::invalid_argument("parts of surfaces: expected voxels with indices up to " +
        std::to_string(most) + " after they are divided, found " +
        std::to_string(static_cast<std::int64_t>(
          std::max({ farthest.x * divided.x, farthest.y * divided.y, farthest.z * divided.z }))));
    }
    this->Parts = {};
  }

  template <class T>
  void sampleTile(std::size_t n)
  {
    const glm::ivec3 first = glm::max(tileEdge * this->Tiles[n], this->Domain.first);
    // The last cell's far corner.
    const glm::ivec3 last = glm::min(tileEdge * (this->Tiles[n] + 1), this->Domain.last);
    const VoxelBox box{ glm::max(first - this->Reach, this->Domain.first),
      glm::min(last + this->Reach, this->Domain.last) };
    const glm::ivec3 size(box.size());
    std::vector<T> values(static_cast<std::size_t>(size.x) * size.y * size.z);
    this->Grid.template copyTo<T>(box, this->Options.negate, values);
    const GridField<T> field(this->Grid.geometry(box), std::span<const T>(values));
    const CellSelection selection{ first - box.first, last - box.first, {} };

    const bool identifies = !this->Parts.keepsAll();
    TileSamples<Real> found;
    const GrowRoom grow = [&](std::size_t count)
    {
      found.points.resize(3 * count);
      found.normals.resize(this->Options.normals ? 3 * count : 0);
      found.cells.resize(identifies ? count : 0);
      SampleRoom room;
      room.capacity = count;
      if constexpr (std::is_same_v<Real, double>)
      {
        room.doublePoints = found.points.data();
      }
      else
      {
        room.points = found.points.data();
      }
      room.normals = this->Options.normals ? found.normals.data() : nullptr;
      room.cells = identifies ? found.cells.data() : nullptr;
      return room;
    };
    sampleResampledIsoSurfaces(field, this->IsoValues, this->Options.samples, selection, this->Resampling,
      this->Options.projectionSteps, nullptr, grow, found.counts);
    const std::size_t total = std::accumulate(found.counts.begin(), found.counts.end(), std::size_t(0));
    grow(total);
    if (this->Options.cut != CutSurface::Open && this->Grid.info().domain)
    {
      this->addCuts(field, selection, found);
    }
    this->Samples[n] = std::move(found);
  }

  template <class T>
  void addCuts(const GridField<T>& field, const CellSelection& selection, TileSamples<Real>& found) const
  {
    std::size_t end = 0;
    for (std::size_t n = 0; n < this->IsoValues.size(); ++n)
    {
      const CutSamples cut = sampleCut(field, this->IsoValues[n], this->Options.cut, this->Domain.first,
        this->Domain.last, selection, this->Resampling);
      end += found.counts[n];
      const auto at = [](auto& numbers, std::size_t index)
      { return numbers.begin() + static_cast<std::ptrdiff_t>(index); };
      const auto insert = [&](auto& numbers, const std::vector<glm::dvec3>& vectors)
      {
        using Number = typename std::remove_reference_t<decltype(numbers)>::value_type;
        std::vector<Number> flat;
        for (const glm::dvec3& v : vectors)
        {
          flat.insert(
            flat.end(), { static_cast<Number>(v.x), static_cast<Number>(v.y), static_cast<Number>(v.z) });
        }
        numbers.insert(at(numbers, 3 * end), flat.begin(), flat.end());
      };
      insert(found.points, cut.points);
      if (this->Options.normals)
      {
        insert(found.normals, cut.normals);
      }
      if (!this->Parts.keepsAll())
      {
        found.cells.insert(at(found.cells, end), cut.cells.begin(), cut.cells.end());
      }
      found.counts[n] += cut.points.size();
      end += cut.points.size();
    }
  }

  /// Leaves out the samples of parts that are not wanted, of each surface's cells in all tiles.
  void keepParts()
  {
    const ComponentSelection selection = this->Parts.inDividedCells(this->Options.subdivision);
    // How many of a tile's samples belong to the surfaces before, as they were and as they are.
    std::vector<std::size_t> from(this->Samples.size(), 0);
    std::vector<std::size_t> to(this->Samples.size(), 0);
    for (std::size_t n = 0; n < this->IsoValues.size(); ++n)
    {
      std::vector<ActiveCellId> cells;
      for (std::size_t tile = 0; tile < this->Samples.size(); ++tile)
      {
        const auto begin = this->Samples[tile].cells.begin() + static_cast<std::ptrdiff_t>(from[tile]);
        cells.insert(cells.end(), begin, begin + static_cast<std::ptrdiff_t>(this->Samples[tile].counts[n]));
      }
      std::sort(cells.begin(), cells.end());
      cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
      const ActiveCellComponents components = findActiveCellComponents(cells);
      const std::vector<char> kept = selectComponents(components.counts, selection);
      const auto isKept = [&](ActiveCellId cell)
      {
        const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
        return kept[components.labels[static_cast<std::size_t>(found - cells.begin())]] != 0;
      };
      parallelFor(this->Samples.size(),
        [&](std::size_t tile)
        {
          TileSamples<Real>& samples = this->Samples[tile];
          const std::size_t end = from[tile] + samples.counts[n];
          const std::size_t before = to[tile];
          for (std::size_t i = from[tile]; i < end; ++i)
          {
            if (isKept(samples.cells[i]))
            {
              moveSample(samples, i, to[tile]++);
            }
          }
          from[tile] = end;
          samples.counts[n] = to[tile] - before;
        });
    }
  }

  static void moveSample(TileSamples<Real>& samples, std::size_t from, std::size_t to)
  {
    std::copy_n(samples.points.begin() + static_cast<std::ptrdiff_t>(3 * from), 3,
      samples.points.begin() + static_cast<std::ptrdiff_t>(3 * to));
    if (!samples.normals.empty())
    {
      std::copy_n(samples.normals.begin() + static_cast<std::ptrdiff_t>(3 * from), 3,
        samples.normals.begin() + static_cast<std::ptrdiff_t>(3 * to));
    }
  }

  /// Collects the samples of a piece's tiles, surface after surface.
  void write(std::size_t first, std::size_t last, VdbTileSamples<Real>& samples)
  {
    samples = {};
    std::vector<std::size_t> from(this->Samples.size(), 0);
    for (std::size_t n = 0; n < this->IsoValues.size(); ++n)
    {
      const std::size_t before = samples.points.size();
      for (std::size_t tile = first; tile < last; ++tile)
      {
        const TileSamples<Real>& own = this->Samples[tile];
        const auto begin = static_cast<std::ptrdiff_t>(3 * from[tile]);
        from[tile] += own.counts[n];
        const auto end = static_cast<std::ptrdiff_t>(3 * from[tile]);
        samples.points.insert(samples.points.end(), own.points.begin() + begin, own.points.begin() + end);
        if (this->Options.normals)
        {
          samples.normals.insert(
            samples.normals.end(), own.normals.begin() + begin, own.normals.begin() + end);
        }
      }
      samples.counts.push_back((samples.points.size() - before) / 3);
    }
  }

  const VdbGrid& Grid;
  std::span<const double> IsoValues;
  const VdbTileOptions& Options;
  VoxelBox Domain;
  IsoSurfaceResampling Resampling;
  ComponentSelection Parts;
  glm::ivec3 Reach;
  std::vector<glm::ivec3> Tiles;
  std::vector<TileSamples<Real>> Samples; ///< of each tile
};

} // namespace

template <class Real>
bool sampleVdbTiles(const VdbGrid& grid, std::span<const double> isoValues, const VdbTileOptions& options,
  VdbTileSamples<Real>& samples, const Progress& progress)
{
  return VdbTileSampler<Real>(grid, isoValues, options).run(samples, progress);
}

template bool sampleVdbTiles(
  const VdbGrid&, std::span<const double>, const VdbTileOptions&, VdbTileSamples<float>&, const Progress&);
template bool sampleVdbTiles(
  const VdbGrid&, std::span<const double>, const VdbTileOptions&, VdbTileSamples<double>&, const Progress&);

} // namespace ink
