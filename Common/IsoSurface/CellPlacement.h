// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridField.h"
#include "IsoSurface/CellBatches.h"
#include "IsoSurface/IsoOffset.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "IsoSurface/KernelParameters.h"
#include "IsoSurface/RobustPlacement.h"
#include "IsoSurface/SampleWriter.h"
#include "IsoSurface/StencilShape.h"
#include "Simd/KernelDispatch.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// Places the samples of active cells: the kernels load and process their stencils in batches. The few cells
/// that the kernels cannot handle are processed individually, see RobustPlacement.h. Work is float or double.
template <class T, class Work>
class CellPlacement
{
public:
  CellPlacement(const GridField<T>& field, double isoValue, const SampleOptions& options)
    : Field(field)
    , Kernels(samplingKernels())
    , Options(options)
    , Relative(isoValue)
    , Axes(axesOf(field.geometry()))
    , Last(field.geometry().dimensions() - 2)
    , Steps{ static_cast<std::ptrdiff_t>(field.stride()), this->Steps[0] * field.geometry().dimensions().x,
      this->Steps[1] * field.geometry().dimensions().y }
    , Segments(field.geometry().dimensions(), this->Steps)
    , Shape(options.method)
  {
    if constexpr (std::is_same_v<Work, float>)
    {
      this->Terms = singleParameters<T>(field.geometry(), isoValue);
      const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(field.geometry().sampleCount());
      if (field.stride() == 1 && count > this->Steps[1] + this->Steps[2] + 1 + StencilReach)
      {
        this->Load = kernelsFor<T>(this->Kernels).load[static_cast<int>(options.method)];
      }
    }
    else
    {
      this->Terms = relativeParameters(field.geometry());
    }
    for (int axis = 0; this->Axes != GridAxes::General && axis < 3; ++axis)
    {
      // Read by whole vectors.
      const std::size_t count = static_cast<std::size_t>(field.geometry().dimensions()[axis]);
      this->Corners[axis].resize(count + SegmentSize);
      for (std::size_t n = 0; n < count; ++n)
      {
        glm::dvec3 index(0.0);
        index[axis] = static_cast<double>(n);
        this->Corners[axis][n] = static_cast<Work>(field.geometry().toWorld(index)[axis]);
      }
    }
    this->Narrow = field.geometry().dimensions().x <= StencilReach;
    for (int n = 0; n < WideStencilSize; ++n)
    {
      const glm::ivec3& offset = this->Shape.offsets[n];
      this->Offsets[n] = offset.x * this->Steps[0] + offset.y * this->Steps[1] + offset.z * this->Steps[2];
    }
  }

  /// Places the samples of some runs of cells in order.
  void place(const std::vector<CellRun>& runs, SampleRoom to) const
  {
    const auto work = std::make_unique<Workspace>();
    const bool normals = to.normals || to.shortNormals || to.byteNormals;
    SegmentLister lister(this->Segments, runs, this->Kernels);
    SegmentBatch* now = &work->segments[0];
    SegmentBatch* next = &work->segments[1];
    lister.next(*now);
    while (now->count != 0)
    {
      lister.next(*next);
      this->fetchAhead(*next);
      this->placeBatch(*now, normals, *work);
      writeSamples(this->Kernels, work->batch, now->count, to);
      for (int i = 0; to.cells && i < now->count; ++i)
      {
        to.cells[i] = activeCellId(this->Field.geometry().first() + now->cell(i));
      }
      to = roomAfter(to, static_cast<std::size_t>(now->count));
      std::swap(now, next);
    }
  }

private:
  /// The state of one thread.
  struct Workspace
  {
    CellBatch<Work> batch;
    SegmentBatch segments[2];
    std::ptrdiff_t distances[4][BatchStride];
  };

  /// Prefetches samples around the next cells, as no hardware prefetcher can predict where the surface goes:
  /// those of the layer that no earlier cells have read. More of them would evict each other from the cache
  /// where the distance of rows is a power of two.
  void fetchAhead(const SegmentBatch& cells) const
  {
    for (int s = 0; s < cells.segmentCount; ++s)
    {
      const T* after = this->Field.data() + cells.offsets[cells.segments[s].lane] + 2 * this->Steps[2];
      __builtin_prefetch(after);
      __builtin_prefetch(after + this->Steps[1]);
    }
  }

  void placeBatch(SegmentBatch& cells, bool normals, Workspace& work) const
  {
    CellBatch<Work>& batch = work.batch;
    const std::uint64_t all = ~std::uint64_t(0) >> (64 - cells.count);
    const bool wide = this->Options.method == NormalMethod::Regression;
    std::uint64_t robust = this->load(cells, normals, work);
    const int axes = static_cast<int>(this->Axes);
    const PlaceKernels<Work>& kernels = this->placeKernels();
    robust |= kernels.findPoints[this->Options.rule == CrossingRule::Strict][wide][axes](
      batch, this->Terms, cells.count);
    if (normals)
    {
      robust |=
        kernels.findNormals[static_cast<int>(this->Options.method)][axes](batch, this->Terms, cells.count);
    }
    for (std::uint64_t rest = robust & all; rest != 0; rest &= rest - 1)
    {
      const int lane = std::countr_zero(rest);
      this->placeRobustly(cells.cell(lane), lane, normals, batch);
    }
  }

  const PlaceKernels<Work>& placeKernels() const
  {
    if constexpr (std::is_same_v<Work, float>)
    {
      return this->Kernels.single;
    }
    else
    {
      return this->Kernels.precise;
    }
  }

  /// Loads the cells' corners and stencils. Returns a bit for each cell that the kernels cannot handle.
  std::uint64_t load(SegmentBatch& cells, bool normals, Workspace& work) const
  {
    CellBatch<Work>& batch = work.batch;
    this->findCorners(cells, batch);
    bool loaded = false;
    if constexpr (std::is_same_v<Work, float>)
    {
      if (this->Load)
      {
        this->loadQuickly(cells, work);
        loaded = true;
      }
    }
    for (int i = 0; !loaded && i < cells.count; ++i)
    {
      this->loadOne(cells, i, batch);
    }
    std::uint64_t robust = 0;
    if (normals && this->Options.method != NormalMethod::Cell)
    {
      if (cells.border)
      {
        this->extrapolate(cells, batch);
      }
      for (int i = 0; i < cells.count && !this->Field.hidden().empty(); ++i)
      {
        robust |= static_cast<std::uint64_t>(this->hasHidden(cells.cell(i))) << i;
      }
    }
    return robust;
  }

  /// Loads vectors of neighboring samples. Rows outside the grid are replaced by those at its border.
  void loadQuickly(SegmentBatch& cells, Workspace& work) const
  {
    using K = KernelScalar<T>;
    StencilSource<K> source = { reinterpret_cast<const K*>(this->Field.data()), cells.offsets, this->Steps[1],
      this->Steps[2], {}, cells.segments, cells.segmentCount };
    std::uint64_t outside = 0;
    if (cells.border || this->Narrow)
    {
      outside = this->findDistances(cells, work);
      for (int n = 0; n < 4; ++n)
      {
        source.border[n] = work.distances[n];
      }
    }
    this->Load(source, cells.count, work.batch);
    for (std::uint64_t rest = outside; rest != 0; rest &= rest - 1)
    {
      this->loadOne(cells, std::countr_zero(rest), work.batch);
    }
  }

  /// The array distances to the neighbors of each cell of a batch with cells at the border. Returns a bit for
  /// each cell whose rows would leave the array; it is replaced by one that can be read.
  std::uint64_t findDistances(SegmentBatch& cells, Workspace& work) const
  {
    const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(this->Field.geometry().sampleCount());
    const std::ptrdiff_t y = this->Steps[1];
    const std::ptrdiff_t z = this->Steps[2];
    auto& distances = work.distances;
    const auto stay = [&](int i)
    {
      cells.offsets[i] = 1;
      distances[0][i] = distances[2][i] = 0;
      distances[1][i] = y;
      distances[3][i] = z;
    };
    std::uint64_t outside = 0;
    for (int s = 0; s < cells.segmentCount; ++s)
    {
      const CellSegment& segment = cells.segments[s];
      const std::ptrdiff_t around[4] = { segment.sides & 1 ? 0 : -y, segment.sides & 2 ? y : 2 * y,
        segment.sides & 4 ? 0 : -z, segment.sides & 8 ? z : 2 * z };
      const std::ptrdiff_t first = cells.offsets[segment.lane];
      const bool leaves = first + around[0] + around[2] < 1 ||
        first + segment.cells - 1 + around[1] + around[3] + StencilReach >= end;
      for (int i = segment.lane; i < segment.lane + segment.cells; ++i)
      {
        for (int n = 0; n < 4; ++n)
        {
          distances[n][i] = around[n];
        }
        if (leaves)
        {
          outside |= std::uint64_t(1) << i;
          stay(i);
        }
      }
    }
    for (int i = cells.count; i < std::min(cells.count + SegmentSize, BatchStride); ++i)
    {
      stay(i);
    }
    return outside;
  }

  /// The world positions of the cells' first samples, from global indices, so that pieces of a grid agree
  /// bitwise.
  void findCorners(const SegmentBatch& cells, CellBatch<Work>& batch) const
  {
    if constexpr (std::is_same_v<Work, float>)
    {
      if (this->Axes != GridAxes::General)
      {
        const auto& [x, y, z] = this->Corners;
        this->Kernels.findCorners(cells, x.data(), y.data(), z.data(), batch);
        return;
      }
    }
    for (int i = 0; i < cells.count; ++i)
    {
      const glm::ivec3 cell = cells.cell(i);
      const bool general = this->Axes == GridAxes::General;
      const glm::dvec3 corner = general ? this->Field.geometry().toWorld(cell) : glm::dvec3(0.0);
      for (int axis = 0; axis < 3; ++axis)
      {
        batch.corners[axis][i] = general ? static_cast<Work>(corner[axis])
                                         : this->Corners[axis][static_cast<std::size_t>(cell[axis])];
      }
    }
  }

  /// Samples outside the grid take the value at its border.
  void loadOne(const SegmentBatch& cells, int lane, CellBatch<Work>& batch) const
  {
    const glm::ivec3 cell = cells.cell(lane);
    const bool inside =
      glm::all(glm::greaterThan(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, this->Last));
    const T* corner =
      this->Field.data() + static_cast<std::ptrdiff_t>(this->Field.geometry().offset(cell)) * this->Steps[0];
    const int size = this->Shape.size;
    for (int n = 0; n < size; ++n)
    {
      const T value = inside
        ? corner[this->Offsets[n]]
        : this->Field.at(glm::clamp(cell + this->Shape.offsets[n], glm::ivec3(0), this->Last + 1));
      batch.values[n][lane] = this->toWork(value);
    }
  }

  Work toWork(T value) const
  {
    if constexpr (std::is_same_v<Work, float>)
    {
      return static_cast<float>(value);
    }
    else
    {
      return this->Relative(value);
    }
  }

  /// Extrapolates neighbors outside the grid linearly along their edge: the central difference becomes
  /// one-sided.
  void extrapolate(const SegmentBatch& cells, CellBatch<Work>& batch) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        for (const StencilShape::Continuation& c : this->Shape.continuations[axis][side])
        {
          for (std::uint64_t rest = cells.sides[axis][side]; rest != 0; rest &= rest - 1)
          {
            const int lane = std::countr_zero(rest);
            batch.values[c.outer][lane] = Work(2) * batch.values[c.near][lane] - batch.values[c.far][lane];
          }
        }
      }
    }
  }

  /// Whether a neighbor of the cell is marked as hidden.
  bool hasHidden(const glm::ivec3& cell) const
  {
    bool found = false;
    for (int n = 0; n < this->Shape.size; ++n)
    {
      const glm::ivec3 sample = glm::clamp(cell + this->Shape.offsets[n], glm::ivec3(0), this->Last + 1);
      found |= this->Field.hidden()[this->Field.geometry().offset(sample)];
    }
    return found;
  }

  /// Robust placement in double, with missing neighbors extrapolated.
  void placeRobustly(const glm::ivec3& cell, int lane, bool normals, CellBatch<Work>& batch) const
  {
    CellStencil stencil = {};
    for (int c = 0; c < ink::Corners; ++c)
    {
      stencil.values[c] = this->Relative(this->Field.at(cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2)));
    }
    const glm::dvec3 mean = meanCrossing(stencil, this->Options.rule);
    // As in findCorners: not relative to the grid's own first sample, which differs between pieces.
    const GridGeometry& geometry = this->Field.geometry();
    const glm::dvec3 point =
      geometry.origin() + geometry.stepToWorld() * (glm::dvec3(geometry.first() + cell) + mean);
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.points[axis][lane] = static_cast<Work>(point[axis]);
    }
    if (!normals)
    {
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int n = 0; n < 4; ++n)
      {
        const int low = lowCorner(axis, n);
        glm::ivec3 sample = cell + glm::ivec3(low & 1, low >> 1 & 1, low >> 2);
        sample[axis] -= 1;
        const auto take = [&](int row) { stencil.values[row] = this->Relative(this->Field.at(sample)); };
        this->Field.has(sample) ? take(neighborBefore(axis, n)) : stencil.extrapolateBefore(axis, n);
        sample[axis] += 3;
        this->Field.has(sample) ? take(neighborAfter(axis, n)) : stencil.extrapolateAfter(axis, n);
      }
    }
    stencil.normalize();
    const glm::dvec3 normal = robustNormal(
      stencil, mean, this->Options.rule, this->Options.method, this->Field.geometry().gradientDirection());
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.normals[axis][lane] = static_cast<float>(normal[axis]);
    }
  }

  const GridField<T>& Field;
  const SamplingKernels& Kernels;
  SampleOptions Options;
  IsoOffset<T> Relative;
  GridAxes Axes;
  glm::ivec3 Last; ///< the last cell along each axis
  std::ptrdiff_t Steps[3];
  SegmentParameters Segments;
  KernelParameters<Work> Terms;
  void (*Load)(const StencilSource<KernelScalar<T>>&, int, CellBatch<float>&) = nullptr;
  std::vector<Work> Corners[3]; ///< world x of samples by i, y by j, z by k, unless the axes are general
  StencilShape Shape;
  std::ptrdiff_t Offsets[WideStencilSize]; ///< of the stencil's positions, in memory
  bool Narrow = false;                     ///< vectors may extend far beyond a row
};

} // namespace ink
