// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Resampling/AxisResampling.h"
#include "Fields/Resampling/TileResampler.h"
#include "IsoSurface/ActiveCellFinder.h"
#include "IsoSurface/CellPlacement.h"
#include "IsoSurface/InterpolatedGradient.h"
#include "IsoSurface/LabelBorderNormals.h"
#include "IsoSurface/ProjectSamples.h"
#include "IsoSurface/ResampledSamples.h"
#include "IsoSurface/SampleWriter.h"
#include "IsoSurface/SampledTile.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

inline GridResampling resamplingOf(const IsoSurfaceResampling& resampling, const glm::dvec3& deviation,
  const glm::ivec3& samples, SmoothingKernel kernel)
{
  const glm::ivec3& subdivision = resampling.subdivision;
  return { AxisResampling(deviation.x, subdivision.x, samples.x, kernel),
    AxisResampling(deviation.y, subdivision.y, samples.y, kernel),
    AxisResampling(deviation.z, subdivision.z, samples.z, kernel) };
}

/// What makes of a grid of so many samples the values that normals belong to.
inline GridResampling resamplingOfNormals(const IsoSurfaceResampling& resampling, const glm::ivec3& samples)
{
  return resamplingOf(resampling, resampling.deviation, samples, SmoothingKernel::Gaussian);
}

/// The same of the values that the surface lies at.
inline GridResampling resamplingOfSurface(const IsoSurfaceResampling& resampling, const glm::ivec3& samples)
{
  return resampling.target == SmoothingTarget::Surface
    ? resamplingOfNormals(resampling, samples)
    : resamplingOf(
        resampling, fourthOrderShare * resampling.deviation, samples, SmoothingKernel::FourthOrder);
}

/// TileResampler::read of a grid, with samples around.
template <class Work>
using SampleReader =
  std::function<void(const SampleBox& positions, const glm::ivec3& reach, TileResampler<Work>&)>;

/// The labels that a grid of distances was made of.
template <class Work>
struct LabelSource
{
  SampleReader<Work> read;
  double isoValue;
};

/// The arguments of sampleResampledIsoSurfaces, whatever the type of the grid's values.
template <class Work>
struct ResampledRequest
{
  GridGeometry geometry;
  SampleReader<Work> read;
  /// Whether a cell of the grid lacks a corner.
  std::function<bool(const glm::ivec3& cell)> lacksCorner;
  std::span<const double> isoValues; ///< one of a mask, or of distances
  SampleOptions options;
  CellSelection selection;
  IsoSurfaceResampling resampling;
  int projectionSteps;
  std::optional<LabelSource<Work>> labels = {}; ///< whose borders normals show, of distances
};

/// Samples a grid tile by tile. Cells and positions are those of the resampled grid unless called the grid's
/// own. Values and normals of values are Work.
template <class Work>
class ResampledSampler
{
public:
  ResampledSampler(const ResampledRequest<Work>& request, TileRanges* ranges)
    : Request(request)
    , Subdivision(request.resampling.subdivision)
    , Geometry(resampledGeometry(request.geometry, this->Subdivision))
    , Begin(glm::clamp(request.selection.begin, glm::ivec3(0), this->ownCells()))
    , End(glm::clamp(request.selection.end, glm::ivec3(0), this->ownCells()))
    , OwnTile(glm::max(TileSize / this->Subdivision, glm::ivec3(4)))
    , Counts(glm::max((this->End - this->Begin + this->OwnTile - 1) / this->OwnTile, glm::ivec3(0)))
    , OfNormals(resamplingOfNormals(request.resampling, request.geometry.dimensions()))
    , OfSurface(resamplingOfSurface(request.resampling, request.geometry.dimensions()))
    , Ranges(ranges ? *ranges : this->OwnRanges)
  {
    const std::size_t count = static_cast<std::size_t>(this->Counts.x) * this->Counts.y * this->Counts.z;
    const TileRanges::Key key = { request.geometry.dimensions(), this->Begin, this->End, this->OwnTile,
      this->reach() };
    if (!(this->Ranges.Of == key))
    {
      this->Ranges.Of = key;
      this->Ranges.Low.assign(count, std::numeric_limits<double>::quiet_NaN());
      this->Ranges.High = this->Ranges.Low;
    }
    this->Tiles.resize(count);
  }

  bool run(const GrowRoom& grow, std::vector<std::size_t>& counts, const Progress& progress)
  {
    const SampleRoom wanted = grow(1);
    this->DoublePoints = wanted.doublePoints != nullptr;
    this->Normals = wanted.normals || wanted.shortNormals || wanted.byteNormals;
    this->Cells = wanted.cells != nullptr;
    tbb::enumerable_thread_specific<Workspace> workspaces;
    const auto sample = [&](std::size_t n) { this->sampleTile(n, workspaces.local()); };
    if (!parallelFor(this->Tiles.size(), sample, progress))
    {
      return false;
    }
    counts.assign(this->Request.isoValues.size(), 0);
    for (const SampledTile& tile : this->Tiles)
    {
      for (std::size_t t = 0; t < tile.counts.size(); ++t)
      {
        counts[t] += tile.counts[t];
      }
    }
    writeTiles(this->Tiles, counts, grow);
    return true;
  }

private:
  /// Cells of a tile along each axis, before it is made of whole voxels: the samples of a tile stay in the
  /// cache from one axis to the next.
  static constexpr glm::ivec3 TileSize = glm::ivec3(64, 32, 32);

  /// The state of one thread.
  struct Workspace
  {
    TileResampler<Work> resampler;
    TileResampler<Work> labels; ///< of distances
    std::vector<Work> values;
    std::vector<Work> smoothValues; ///< those that only normals are of
    std::vector<std::uint8_t> skipped;
    std::vector<double> isoValues;
  };

  glm::ivec3 ownCells() const { return glm::max(this->Request.geometry.dimensions() - 1, glm::ivec3(0)); }
  bool onlyNormals() const { return this->Request.resampling.target == SmoothingTarget::Normals; }

  glm::ivec3 reach() const
  {
    glm::ivec3 most;
    for (int axis = 0; axis < 3; ++axis)
    {
      most[axis] = std::max(this->OfNormals[axis].reach(), this->OfSurface[axis].reach());
    }
    return most;
  }

  void sampleTile(std::size_t n, Workspace& work)
  {
    const int tile = static_cast<int>(n);
    const glm::ivec3 at(
      tile % this->Counts.x, tile / this->Counts.x % this->Counts.y, tile / this->Counts.x / this->Counts.y);
    const glm::ivec3 ownBegin = this->Begin + at * this->OwnTile;
    const glm::ivec3 ownEnd = glm::min(ownBegin + this->OwnTile, this->End);
    if (this->isOutside(this->Ranges.Low[n], this->Ranges.High[n]))
    {
      return;
    }
    // Positions that normals depend on, and those that moved samples' do.
    const int around = this->Request.projectionSteps > 0 ? 2 : 1;
    const SampleBox box = { glm::max(ownBegin * this->Subdivision - around, glm::ivec3(0)),
      glm::min(ownEnd * this->Subdivision + 1 + around, this->Geometry.dimensions()) };
    this->Request.read(box, this->reach(), work.resampler);
    this->Ranges.Low[n] = work.resampler.least();
    this->Ranges.High[n] = work.resampler.greatest();
    if (this->isOutside(this->Ranges.Low[n], this->Ranges.High[n]))
    {
      return;
    }
    work.isoValues.assign(this->Request.isoValues.begin(), this->Request.isoValues.end());
    // So that no difference overflows.
    constexpr Work largest = std::numeric_limits<Work>::max() / 64;
    if (this->Request.resampling.ofMask)
    {
      work.resampler.makeMask(work.isoValues.front());
      work.isoValues.front() = maskIsoValue;
    }
    else if (std::max(std::abs(this->Ranges.Low[n]), std::abs(this->Ranges.High[n])) > largest)
    {
      constexpr Work scale = Work(1) / 256;
      work.resampler.scale(scale);
      for (double& isoValue : work.isoValues)
      {
        isoValue *= scale;
      }
    }
    work.resampler.resample(this->OfSurface, box, work.values);
    const GridField<Work> field = this->fieldOf(box, work.values);

    CellSelection selection = { ownBegin * this->Subdivision - box.begin,
      ownEnd * this->Subdivision - box.begin, {} };
    if (!this->Request.selection.skipped.empty() || work.resampler.anyMissing())
    {
      this->markSkipped(box, work.skipped);
      selection.skipped = { work.skipped, 1 };
    }
    const std::vector<ActiveCells> cells = this->findCells(field, work.isoValues, selection);
    SampledTile& samples = this->Tiles[n];
    std::size_t total = 0;
    for (const ActiveCells& all : cells)
    {
      samples.counts.push_back(all.count);
      total += all.count;
    }
    if (total == 0)
    {
      return;
    }
    this->place(field, work.isoValues, cells, total, samples);
    if (this->onlyNormals() && this->Normals)
    {
      work.resampler.resample(this->OfNormals, box, work.smoothValues);
      this->useNormalsOf(this->fieldOf(box, work.smoothValues), samples);
    }
    if (!this->Request.resampling.borders || !this->Normals)
    {
      return;
    }
    if (const auto& labels = this->Request.labels)
    {
      labels->read(box, this->reach(), work.labels);
      work.labels.makeMask(labels->isoValue);
      this->useNormalsOfLabels(work.labels, labels->isoValue, samples);
    }
    else if (this->Request.resampling.ofMask)
    {
      this->useNormalsOfLabels(work.resampler, this->Request.isoValues.front(), samples);
    }
  }

  /// The active cells for each iso-value.
  std::vector<ActiveCells> findCells(
    const GridField<Work>& field, const std::vector<double>& isoValues, const CellSelection& selection) const
  {
    const ActiveCellFinder<Work> finder(field, isoValues, this->Request.options.rule, selection);
    std::vector<ActiveCells> cells(isoValues.size());
    for (ActiveCells& all : cells)
    {
      all.slabs.resize(finder.slabCount());
    }
    for (int slab = 0; slab < finder.slabCount(); ++slab)
    {
      finder.find(slab, cells);
    }
    for (ActiveCells& all : cells)
    {
      for (const ActiveCells::Slab& slab : all.slabs)
      {
        all.count += slab.count;
      }
    }
    return cells;
  }

  /// Whether no iso-value lies between values made of those in a range.
  bool isOutside(double low, double high) const
  {
    if (!(low <= high))
    {
      // Not known, or nothing is there.
      return low > high;
    }
    double gain = 1.0;
    for (const AxisResampling& axis : this->OfSurface)
    {
      gain *= axis.gain();
    }
    // Half first: the whole range may not be a number.
    const double overshoot = (gain - 1.0) * (0.5 * high - 0.5 * low);
    return std::none_of(this->Request.isoValues.begin(), this->Request.isoValues.end(),
      [&](double v) { return v >= low - overshoot && v <= high + overshoot; });
  }

  GridField<Work> fieldOf(const SampleBox& box, const std::vector<Work>& values) const
  {
    return GridField<Work>(GridGeometry(box.size(), this->Geometry.origin(), this->Geometry.spacing(),
                             this->Geometry.direction(), this->Geometry.first() + box.begin),
      values);
  }

  /// Marks the parts of the grid's own cells that are skipped or have a missing corner.
  void markSkipped(const SampleBox& box, std::vector<std::uint8_t>& marks) const
  {
    const ElementMarks& skipped = this->Request.selection.skipped;
    const glm::ivec3 own = this->ownCells();
    const glm::ivec3 size = box.size() - 1;
    marks.assign(static_cast<std::size_t>(size.x) * size.y * size.z, 0);
    const glm::ivec3 first = box.begin / this->Subdivision;
    const glm::ivec3 last = (box.end - 2) / this->Subdivision;
    for (int k = first.z; k <= last.z; ++k)
    {
      for (int j = first.y; j <= last.y; ++j)
      {
        for (int i = first.x; i <= last.x; ++i)
        {
          const glm::ivec3 cell(i, j, k);
          const std::size_t offset =
            i + static_cast<std::size_t>(own.x) * (j + static_cast<std::size_t>(own.y) * k);
          const bool skip = (!skipped.empty() && skipped[offset]) || this->Request.lacksCorner(cell);
          if (!skip)
          {
            continue;
          }
          const glm::ivec3 begin = glm::max(cell * this->Subdivision - box.begin, glm::ivec3(0));
          const glm::ivec3 end = glm::min((cell + 1) * this->Subdivision - box.begin, size);
          for (int z = begin.z; z < end.z; ++z)
          {
            for (int y = begin.y; y < end.y; ++y)
            {
              std::uint8_t* row =
                marks.data() + static_cast<std::size_t>(size.x) * (y + static_cast<std::size_t>(size.y) * z);
              std::fill(row + begin.x, row + end.x, std::uint8_t(1));
            }
          }
        }
      }
    }
  }

  void place(const GridField<Work>& field, const std::vector<double>& isoValues,
    const std::vector<ActiveCells>& cells, std::size_t total, SampledTile& samples) const
  {
    SampleRoom room;
    room.capacity = total;
    if (this->DoublePoints)
    {
      samples.doublePoints.resize(3 * total);
      room.doublePoints = samples.doublePoints.data();
    }
    else
    {
      samples.points.resize(3 * total);
      room.points = samples.points.data();
    }
    if (this->Normals)
    {
      samples.normals.resize(3 * total);
      room.normals = samples.normals.data();
    }
    if (this->Cells)
    {
      samples.cells.resize(total);
      room.cells = samples.cells.data();
    }
    for (std::size_t t = 0; t < cells.size(); ++t)
    {
      const CellPlacement<Work, Work> placer(field, isoValues[t], this->Request.options);
      SampleRoom own = room;
      for (const ActiveCells::Slab& slab : cells[t].slabs)
      {
        placer.place(slab.runs, own);
        own = roomAfter(own, slab.count);
      }
      const auto project = [&](auto* points)
      {
        projectSamples(field, field.geometry(), isoValues[t], this->Request.projectionSteps,
          std::span(points, 3 * cells[t].count));
      };
      if (this->Request.projectionSteps > 0)
      {
        room.doublePoints ? project(room.doublePoints) : project(room.points);
      }
      room = own;
    }
  }

  glm::dvec3 pointOf(const SampledTile& samples, std::size_t n) const
  {
    const auto at = [n](const auto& points)
    { return glm::dvec3(points[3 * n], points[3 * n + 1], points[3 * n + 2]); };
    return this->DoublePoints ? at(samples.doublePoints) : at(samples.points);
  }

  /// Sets a sample's normal against a gradient per sample step, if that has a direction.
  static void setNormal(SampledTile& samples, std::size_t n, const glm::dvec3& gradient)
  {
    const double length = std::hypot(gradient.x, gradient.y, gradient.z);
    for (int axis = 0; length > 0.0 && std::isfinite(length) && axis < 3; ++axis)
    {
      samples.normals[3 * n + axis] = static_cast<float>(-gradient[axis] / length);
    }
  }

  /// Replaces the normals by those of other values.
  void useNormalsOf(const GridField<Work>& field, SampledTile& samples) const
  {
    for (std::size_t n = 0; 3 * n < samples.normals.size(); ++n)
    {
      const glm::dvec3 point = this->pointOf(samples, n);
      const glm::dvec3 gradient = this->Geometry.gradientDirection() * interpolatedGradient(field, point);
      setNormal(samples, n, std::isfinite(glm::length(gradient)) ? gradient : field.gradient(point));
    }
  }

  /// Turns the normals where several labels meet, see LabelBorderNormals.
  void useNormalsOfLabels(const TileResampler<Work>& labels, double isoValue, SampledTile& samples) const
  {
    const GridGeometry& own = this->Request.geometry;
    LabelBorderNormals<Work> normals(labels, isoValue, own.first(), this->Request.resampling.deviation);
    for (std::size_t n = 0; 3 * n < samples.normals.size(); ++n)
    {
      const auto groove = normals.grooveAt(own.toGlobalIndex(this->pointOf(samples, n)));
      const glm::dvec3 gradient = groove ? own.gradientDirection() * groove->gradient : glm::dvec3(0.0);
      const double length = glm::length(gradient);
      if (length > 0.0)
      {
        const float* normal = &samples.normals[3 * n];
        const glm::dvec3 before(normal[0], normal[1], normal[2]);
        setNormal(samples, n, glm::mix(-before, gradient / length, groove->weight));
      }
    }
  }

  ResampledRequest<Work> Request;
  glm::ivec3 Subdivision;
  GridGeometry Geometry;
  glm::ivec3 Begin; ///< the grid's own cells
  glm::ivec3 End;
  glm::ivec3 OwnTile; ///< the grid's own cells in a tile
  glm::ivec3 Counts;  ///< of tiles
  GridResampling OfNormals;
  GridResampling OfSurface;
  TileRanges OwnRanges;
  TileRanges& Ranges;
  std::vector<SampledTile> Tiles;
  bool DoublePoints = false;
  bool Normals = false;
  bool Cells = false;
};

} // namespace ink
