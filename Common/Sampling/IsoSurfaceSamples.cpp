// Cells are listed slab by slab, and their stencils loaded and worked on a batch at a time by Kernels/. What
// those loops leave over, a handful of cells, is done one by one by CarefulSample.

#include "Sampling/IsoSurfaceSamples.h"

#include "Fields/Scalars.h"
#include "Sampling/BitCount.h"
#include "Sampling/CarefulSample.h"
#include "Sampling/Kernels/TypedKernelsOf.h"
#include "Sampling/RelativeValue.h"
#include "Sampling/SurfaceTermsOf.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

/// Whether float holds every T, and its sums and differences of a few, well enough to work in.
template <class T>
constexpr bool FitsSingle = (std::is_integral_v<T> && sizeof(T) <= 2) || std::is_same_v<T, float>;

/// The same room, `samples` further.
SampleRoom after(const SampleRoom& room, std::size_t samples)
{
  const auto move = [samples](auto* p) { return p ? p + 3 * samples : p; };
  return { move(room.points), move(room.doublePoints), move(room.normals), move(room.shortNormals),
    move(room.byteNormals), room.capacity };
}

template <class Work, class To>
void writePoints(const Work (&points)[3][BatchStride], int count, To* to)
{
  for (int i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      to[3 * i + axis] = static_cast<To>(points[axis][i]);
    }
  }
}

template <class Integer>
void writeQuantized(const float (&normals)[3][BatchStride], int count, Integer* to)
{
  constexpr float scale = std::numeric_limits<Integer>::max();
  for (int i = 0; i < count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const float v = normals[axis][i] * scale;
      to[3 * i + axis] = static_cast<Integer>(v + (v < 0.0f ? -0.5f : 0.5f));
    }
  }
}

/// Places the samples of one slab. Work is float or double.
template <class T, class Work>
class SamplePlacer
{
public:
  SamplePlacer(const GridField<T>& field, double isoValue, const SampleOptions& options)
    : Field(field)
    , Kernels(samplingKernels())
    , Options(options)
    , Relative(isoValue)
    , Axes(axesOf(field.geometry()))
    , Last(field.geometry().dimensions() - 2)
  {
    if constexpr (std::is_same_v<Work, float>)
    {
      this->Terms = singleTerms<T>(field.geometry(), isoValue);
      this->Load = typedKernelsOf<T>(this->Kernels).load[static_cast<int>(options.method)];
    }
    else
    {
      this->Terms = relativeTerms(field.geometry());
    }
    const int stride = static_cast<int>(field.stride());
    this->Steps[0] = stride;
    this->Steps[1] = this->Steps[0] * field.geometry().dimensions().x;
    this->Steps[2] = this->Steps[1] * field.geometry().dimensions().y;
    this->CanLoad = field.stride() == 1 &&
      static_cast<std::ptrdiff_t>(field.geometry().sampleCount()) >= this->Steps[1] + this->Steps[2] + 5;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Corners[axis].resize(this->Axes == GridAxes::General ? 0 : field.geometry().dimensions()[axis]);
      for (std::size_t n = 0; n < this->Corners[axis].size(); ++n)
      {
        glm::dvec3 index(0.0);
        index[axis] = static_cast<double>(n);
        this->Corners[axis][n] = static_cast<Work>(field.geometry().toWorld(index)[axis]);
      }
    }
    this->findOffsets();
    this->findContinuations();
    this->Prefetch = field.geometry().sampleCount() * field.stride() * sizeof(T) > (std::size_t(24) << 20);
  }

  void place(const CrossedCells::Slab& slab, SampleRoom to) const
  {
    if (slab.count == 0)
    {
      return;
    }
    const SlabCells cells = this->listCells(slab);
    const auto work = std::make_unique<Workspace>();
    const bool normals = to.normals || to.shortNormals || to.byteNormals;
    for (std::size_t at = 0; at < slab.count; at += BatchSize)
    {
      const int count = static_cast<int>(std::min<std::size_t>(BatchSize, slab.count - at));
      if (this->Prefetch)
      {
        this->fetchAhead(cells, at + count, std::min<std::size_t>(at + count + BatchSize, slab.count));
      }
      this->placeBatch(cells, at, count, normals, *work);
      this->write(work->batch, count, to);
      to = after(to, static_cast<std::size_t>(count));
    }
  }

private:
  void write(const CellBatch<Work>& batch, int count, const SampleRoom& to) const
  {
    if (to.doublePoints)
    {
      writePoints(batch.points, count, to.doublePoints);
    }
    else if constexpr (std::is_same_v<Work, float>)
    {
      this->Kernels.interleave(batch.points[0], batch.points[1], batch.points[2], count, to.points);
    }
    else
    {
      writePoints(batch.points, count, to.points);
    }
    if (to.normals)
    {
      this->Kernels.interleave(batch.normals[0], batch.normals[1], batch.normals[2], count, to.normals);
    }
    if (to.shortNormals)
    {
      writeQuantized(batch.normals, count, to.shortNormals);
    }
    if (to.byteNormals)
    {
      writeQuantized(batch.normals, count, to.byteNormals);
    }
  }

  /// What the cells of a run have in common.
  struct RunTerms
  {
    std::ptrdiff_t offset; ///< of the sample at x = 0
    Work y;                ///< of the first corners, in the world, unless the axes are general
    Work z;
    bool border; ///< a cell of the run lies at the grid's border
  };

  /// What one thread works on.
  struct Workspace
  {
    CellBatch<Work> batch;
    std::ptrdiff_t offsets[BatchStride];
    std::ptrdiff_t distances[4][BatchStride];
  };

  /// The cells of a slab, one by one. Both lists may be read past their end.
  struct SlabCells
  {
    const CrossedCells::Slab& slab;
    std::unique_ptr<RunTerms[]> runs;
    std::unique_ptr<std::uint32_t[]> x;
    std::unique_ptr<std::uint32_t[]> run;

    glm::ivec3 operator[](std::size_t n) const
    {
      const glm::ivec3& first = this->slab.runs[this->run[n]].first;
      return { static_cast<int>(this->x[n]), first.y, first.z };
    }
  };

  SlabCells listCells(const CrossedCells::Slab& slab) const
  {
    // Always so many of a run, because few have more, and a branch that follows their number is foretold
    // wrongly.
    constexpr int usual = 8;
    const std::size_t room = slab.count + 64;
    SlabCells cells = { slab, std::make_unique_for_overwrite<RunTerms[]>(slab.runs.size()),
      std::make_unique_for_overwrite<std::uint32_t[]>(room),
      std::make_unique_for_overwrite<std::uint32_t[]>(room) };
    std::uint32_t* x = cells.x.get();
    std::uint32_t* run = cells.run.get();
    for (std::uint32_t r = 0; r < slab.runs.size(); ++r)
    {
      const CellRun& from = slab.runs[r];
      const std::uint32_t first = static_cast<std::uint32_t>(from.first.x);
      std::uint64_t rest = from.cells;
      for (int n = 0; n < usual; ++n)
      {
        // The highest bit makes a number of cells that are not there, too.
        x[n] = first + static_cast<std::uint32_t>(std::countr_zero(rest | std::uint64_t(1) << 63));
        run[n] = r;
        rest &= rest - 1;
      }
      const int count = bitCount(from.cells);
      for (int n = usual; n < count; ++n)
      {
        x[n] = first + static_cast<std::uint32_t>(std::countr_zero(rest));
        run[n] = r;
        rest &= rest - 1;
      }
      x += count;
      run += count;
      cells.runs[r] = this->termsOf(from);
    }
    return cells;
  }

  RunTerms termsOf(const CellRun& run) const
  {
    const glm::ivec3& first = run.first;
    const int toLast = this->Last.x - first.x;
    const bool border = (first.y == 0) | (first.y == this->Last.y) | (first.z == 0) |
      (first.z == this->Last.z) | (first.x == 0 && (run.cells & 1)) |
      (toLast < 64 && (run.cells >> toLast & 1));
    const bool general = this->Axes == GridAxes::General;
    return { first.y * this->Steps[1] + first.z * this->Steps[2],
      general ? Work(0) : this->Corners[1][static_cast<std::size_t>(first.y)],
      general ? Work(0) : this->Corners[2][static_cast<std::size_t>(first.z)], border };
  }

  /// Has the memory around some cells on its way while others are worked on: no machine can guess where the
  /// surface goes next.
  void fetchAhead(const SlabCells& cells, std::size_t begin, std::size_t end) const
  {
    constexpr std::ptrdiff_t line = 64 / sizeof(T);
    const std::ptrdiff_t y = this->Steps[1];
    const std::ptrdiff_t z = this->Steps[2];
    std::ptrdiff_t last = -line;
    for (std::size_t n = begin; n < end; ++n)
    {
      const std::ptrdiff_t offset =
        cells.runs[cells.run[n]].offset + static_cast<std::ptrdiff_t>(cells.x[n]) * this->Steps[0];
      if (offset - last < line && offset >= last)
      {
        continue;
      }
      last = offset;
      const T* cell = this->Field.data() + offset;
      for (const std::ptrdiff_t row :
        { -y, std::ptrdiff_t(0), y, 2 * y, z - y, z, z + y, z + 2 * y, -z, y - z, 2 * z, 2 * z + y })
      {
        __builtin_prefetch(cell + row);
      }
    }
  }

  void placeBatch(const SlabCells& cells, std::size_t at, int count, bool normals, Workspace& work) const
  {
    CellBatch<Work>& batch = work.batch;
    const std::uint64_t all = ~std::uint64_t(0) >> (BatchSize - count);
    const bool wide = this->Options.method == NormalMethod::Regression;
    std::uint64_t careful = this->load(cells, at, count, normals, work);
    const int axes = static_cast<int>(this->Axes);
    const PlaceKernels<Work>& kernels = this->placeKernels();
    careful |=
      kernels.findPoints[this->Options.rule == CrossingRule::Strict][wide][axes](batch, this->Terms, count);
    if (normals)
    {
      careful |= kernels.findNormals[static_cast<int>(this->Options.method)][axes](batch, this->Terms, count);
    }
    for (std::uint64_t rest = careful & all; rest != 0; rest &= rest - 1)
    {
      const int lane = std::countr_zero(rest);
      this->placeCarefully(cells[at + lane], lane, normals, batch);
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

  /// Loads the cells' corners and stencils. Returns a bit for each that the loops cannot do.
  std::uint64_t load(const SlabCells& cells, std::size_t at, int count, bool normals, Workspace& work) const
  {
    CellBatch<Work>& batch = work.batch;
    const std::uint64_t border = this->findCorners(cells, at, count, work.offsets, batch);
    bool loaded = false;
    if constexpr (std::is_same_v<Work, float>)
    {
      if (this->Load && this->CanLoad)
      {
        this->loadQuickly(cells, at, count, border, work);
        loaded = true;
      }
    }
    if (!loaded)
    {
      this->loadOneByOne(cells, at, count, work.offsets, border, batch);
    }
    std::uint64_t careful = 0;
    if (normals && this->Options.method != NormalMethod::Cell)
    {
      if (border != 0)
      {
        this->extrapolate(cells, at, border, batch);
      }
      for (int i = 0; i < count && !this->Field.hidden().empty(); ++i)
      {
        careful |= static_cast<std::uint64_t>(this->hasHidden(cells[at + i])) << i;
      }
    }
    return careful;
  }

  /// Where the cells' first samples are, in memory and in the world; from global indices, so that the pieces
  /// of a grid agree to the last bit. Returns a bit for each cell at the grid's border.
  std::uint64_t findCorners(
    const SlabCells& cells, std::size_t at, int count, std::ptrdiff_t* offsets, CellBatch<Work>& batch) const
  {
    const std::uint32_t* xs = cells.x.get() + at;
    const std::uint32_t* runs = cells.run.get() + at;
    std::uint64_t maybe = 0;
    if (this->Axes == GridAxes::General)
    {
      for (int i = 0; i < count; ++i)
      {
        const glm::dvec3 corner = this->Field.geometry().toWorld(cells[at + i]);
        const RunTerms& run = cells.runs[runs[i]];
        offsets[i] = run.offset + static_cast<std::ptrdiff_t>(xs[i]) * this->Steps[0];
        batch.corners[0][i] = static_cast<Work>(corner.x);
        batch.corners[1][i] = static_cast<Work>(corner.y);
        batch.corners[2][i] = static_cast<Work>(corner.z);
        maybe |= static_cast<std::uint64_t>(run.border) << i;
      }
    }
    else
    {
      const Work* cornersX = this->Corners[0].data();
      const std::ptrdiff_t step = this->Steps[0];
      for (int i = 0; i < count; ++i)
      {
        const RunTerms& run = cells.runs[runs[i]];
        offsets[i] = run.offset + static_cast<std::ptrdiff_t>(xs[i]) * step;
        batch.corners[0][i] = cornersX[xs[i]];
        batch.corners[1][i] = run.y;
        batch.corners[2][i] = run.z;
        maybe |= static_cast<std::uint64_t>(run.border) << i;
      }
    }
    for (int i = count; i < BatchStride; ++i)
    {
      offsets[i] = offsets[count - 1];
    }
    std::uint64_t border = 0;
    for (std::uint64_t rest = maybe; rest != 0; rest &= rest - 1)
    {
      const int i = std::countr_zero(rest);
      const glm::ivec3 cell = cells[at + i];
      const bool isAtBorder = cell.x == 0 || cell.y == 0 || cell.z == 0 || cell.x == this->Last.x ||
        cell.y == this->Last.y || cell.z == this->Last.z;
      border |= static_cast<std::uint64_t>(isAtBorder) << i;
    }
    return border;
  }

  /// By vectors of neighbouring samples. Rows beyond the grid's border are replaced by those at it.
  void loadQuickly(
    const SlabCells& cells, std::size_t at, int count, std::uint64_t border, Workspace& work) const
  {
    using K = KernelScalar<T>;
    StencilSource<K> source = { reinterpret_cast<const K*>(this->Field.data()), work.offsets, this->Steps[1],
      this->Steps[2], {} };
    std::uint64_t outside = 0;
    if (border != 0)
    {
      outside = this->findDistances(cells, at, count, border, work);
      for (int n = 0; n < 4; ++n)
      {
        source.border[n] = work.distances[n];
      }
    }
    this->Load(source, count, work.batch);
    for (std::uint64_t rest = outside; rest != 0; rest &= rest - 1)
    {
      const int lane = std::countr_zero(rest);
      this->loadClamped(cells[at + lane], lane, work.batch);
    }
  }

  /// The distances to neighbours of each cell of a batch, some of which are at the border. Returns a bit for
  /// each cell whose rows would begin before or end beyond the array; in its place comes something that can
  /// be read.
  std::uint64_t findDistances(
    const SlabCells& cells, std::size_t at, int count, std::uint64_t border, Workspace& work) const
  {
    const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(this->Field.geometry().sampleCount());
    const std::ptrdiff_t y = this->Steps[1];
    const std::ptrdiff_t z = this->Steps[2];
    auto& distances = work.distances;
    for (int i = 0; i < count; ++i)
    {
      distances[0][i] = -y;
      distances[1][i] = 2 * y;
      distances[2][i] = -z;
      distances[3][i] = 2 * z;
    }
    const auto stay = [&](int i)
    {
      distances[0][i] = distances[2][i] = 0;
      distances[1][i] = y;
      distances[3][i] = z;
    };
    for (int i = count; i < BatchStride; ++i)
    {
      work.offsets[i] = 1;
      stay(i);
    }
    std::uint64_t outside = 0;
    for (std::uint64_t rest = border; rest != 0; rest &= rest - 1)
    {
      const int i = std::countr_zero(rest);
      const glm::ivec3 cell = cells[at + i];
      distances[0][i] = cell.y == 0 ? 0 : -y;
      distances[1][i] = cell.y == this->Last.y ? y : 2 * y;
      distances[2][i] = cell.z == 0 ? 0 : -z;
      distances[3][i] = cell.z == this->Last.z ? z : 2 * z;
      // Four samples are read from the one before a cell on, or from its first one.
      if (work.offsets[i] + distances[0][i] + distances[2][i] < 1 ||
        work.offsets[i] + distances[1][i] + distances[3][i] + 3 >= end)
      {
        outside |= std::uint64_t(1) << i;
        work.offsets[i] = 1;
        stay(i);
      }
    }
    return outside;
  }

  void loadOneByOne(const SlabCells& cells, std::size_t at, int count, const std::ptrdiff_t* offsets,
    std::uint64_t border, CellBatch<Work>& batch) const
  {
    const int size = this->stencilSize();
    for (int i = 0; i < count; ++i)
    {
      if (border >> i & 1)
      {
        this->loadClamped(cells[at + i], i, batch);
        continue;
      }
      const T* corner = this->Field.data() + offsets[i];
      for (int n = 0; n < size; ++n)
      {
        batch.values[n][i] = this->toWork(corner[this->Offsets[n]]);
      }
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

  int stencilSize() const
  {
    return this->Options.method == NormalMethod::Cell    ? Corners8
      : this->Options.method == NormalMethod::Regression ? WideStencilSize
                                                         : StencilSize;
  }

  /// Where each row of a batch lies around a cell's first corner.
  void findOffsets()
  {
    const auto offset = [this](const glm::ivec3& n)
    { return n.x * this->Steps[0] + n.y * this->Steps[1] + n.z * this->Steps[2]; };
    for (int n = 0; n < WideStencilSize; ++n)
    {
      this->Places[n] = this->placeOf(n);
      this->Offsets[n] = offset(this->Places[n]);
    }
  }

  glm::ivec3 placeOf(int n) const
  {
    if (this->Options.method == NormalMethod::Regression)
    {
      return { (n & 3) - 1, (n >> 2 & 3) - 1, (n >> 4) - 1 };
    }
    if (n >= StencilSize)
    {
      return glm::ivec3(0);
    }
    if (n < Corners8)
    {
      return { n & 1, n >> 1 & 1, n >> 2 };
    }
    const int axis = (n - Corners8) % Edges / 4;
    const int corner = lowCorner(axis, n % 4);
    glm::ivec3 place(corner & 1, corner >> 1 & 1, corner >> 2);
    place[axis] += n < Corners8 + Edges ? -1 : 2;
    return place;
  }

  /// Samples beyond the grid's border take the value of the one at it.
  void loadClamped(const glm::ivec3& cell, int lane, CellBatch<Work>& batch) const
  {
    for (int n = 0; n < this->stencilSize(); ++n)
    {
      const glm::ivec3 sample = glm::clamp(cell + this->Places[n], glm::ivec3(0), this->Last + 1);
      batch.values[n][lane] = this->toWork(this->Field.at(sample));
    }
  }

  /// A row of a batch beyond the grid's border, and the two that it continues.
  struct Continuation
  {
    int outer;
    int near;
    int far;
  };

  /// The continuations before the first cell along an axis, and after the last.
  void findContinuations()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Options.method == NormalMethod::Regression)
      {
        constexpr int steps[3] = { 1, 4, 16 };
        const int step = steps[axis];
        for (int n = 0; n < 16; ++n)
        {
          const int outer = axis == 0 ? 4 * n : axis == 1 ? n % 4 + 16 * (n / 4) : n;
          this->Continuations[axis][0].push_back({ outer, outer + step, outer + 2 * step });
          this->Continuations[axis][1].push_back({ outer + 3 * step, outer + 2 * step, outer + step });
        }
        continue;
      }
      for (int n = 0; n < 4; ++n)
      {
        const int low = lowCorner(axis, n);
        const int high = highCorner(axis, n);
        this->Continuations[axis][0].push_back({ neighbourBefore(axis, n), low, high });
        this->Continuations[axis][1].push_back({ neighbourAfter(axis, n), high, low });
      }
    }
  }

  /// Neighbours beyond the grid's border, from the edge that they continue: the central difference becomes
  /// one-sided.
  void extrapolate(const SlabCells& cells, std::size_t at, std::uint64_t border, CellBatch<Work>& batch) const
  {
    std::uint64_t sides[3][2] = {};
    for (std::uint64_t rest = border; rest != 0; rest &= rest - 1)
    {
      const int lane = std::countr_zero(rest);
      const glm::ivec3 cell = cells[at + lane];
      for (int axis = 0; axis < 3; ++axis)
      {
        sides[axis][0] |= static_cast<std::uint64_t>(cell[axis] == 0) << lane;
        sides[axis][1] |= static_cast<std::uint64_t>(cell[axis] == this->Last[axis]) << lane;
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        for (const Continuation& c : this->Continuations[axis][side])
        {
          for (std::uint64_t rest = sides[axis][side]; rest != 0; rest &= rest - 1)
          {
            const int lane = std::countr_zero(rest);
            batch.values[c.outer][lane] = Work(2) * batch.values[c.near][lane] - batch.values[c.far][lane];
          }
        }
      }
    }
  }

  /// Whether a neighbour of the cell is marked as hidden.
  bool hasHidden(const glm::ivec3& cell) const
  {
    bool found = false;
    for (int n = 0; n < this->stencilSize(); ++n)
    {
      const glm::ivec3 sample = glm::clamp(cell + this->Places[n], glm::ivec3(0), this->Last + 1);
      found |= this->Field.hidden()[this->Field.geometry().offset(sample)];
    }
    return found;
  }

  /// In double, with missing neighbours extrapolated.
  void placeCarefully(const glm::ivec3& cell, int lane, bool normals, CellBatch<Work>& batch) const
  {
    CellStencil stencil = {};
    for (int c = 0; c < Corners8; ++c)
    {
      stencil.values[c] = this->Relative(this->Field.at(cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2)));
    }
    const glm::dvec3 mean = meanCrossing(stencil, this->Options.rule);
    // As findCorners: not from the grid's own first sample, which other pieces do not have.
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
        const auto take = [&](int place) { stencil.values[place] = this->Relative(this->Field.at(sample)); };
        this->Field.has(sample) ? take(neighbourBefore(axis, n)) : stencil.extrapolateBefore(axis, n);
        sample[axis] += 3;
        this->Field.has(sample) ? take(neighbourAfter(axis, n)) : stencil.extrapolateAfter(axis, n);
      }
    }
    stencil.normalize();
    const glm::dvec3 normal = carefulNormal(
      stencil, mean, this->Options.rule, this->Options.method, this->Field.geometry().gradientDirection());
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.normals[axis][lane] = static_cast<float>(normal[axis]);
    }
  }

  static constexpr int Corners8 = ink::Corners;

  const GridField<T>& Field;
  const SamplingKernels& Kernels;
  SampleOptions Options;
  RelativeValue<T> Relative;
  GridAxes Axes;
  glm::ivec3 Last; ///< the last cell along each axis
  SurfaceTerms<Work> Terms;
  void (*Load)(const StencilSource<KernelScalar<T>>&, int, CellBatch<float>&) = nullptr;
  bool CanLoad = false;
  std::ptrdiff_t Steps[3];
  std::vector<Work> Corners[3]; ///< the world's x of samples by i and so on, unless the axes are general
  glm::ivec3 Places[WideStencilSize];
  std::ptrdiff_t Offsets[WideStencilSize];
  std::vector<Continuation> Continuations[3][2];
  bool Prefetch = false; ///< the field is larger than a cache
};

template <class Work, class T>
bool placeAll(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const CrossedCells& cells, const SampleRoom& to, const Progress& progress)
{
  const SamplePlacer<T, Work> placer(field, isoValue, options);
  const auto placeSlab = [&](std::size_t s)
  { placer.place(cells.slabs[s], after(to, cells.slabs[s].before)); };
  return parallelFor(cells.slabs.size(), placeSlab, progress);
}

/// Places the samples of slabs while others are still being found, each as soon as the number of those before
/// it is known: its part of the field is then still in the cache.
template <class T, class Work>
class SamplesOnTheWay
{
public:
  SamplesOnTheWay(const GridField<T>& field, double isoValue, const SampleOptions& options,
    CrossedCells& cells, const SampleRoom& room)
    : Placer(field, isoValue, options)
    , Cells(cells)
    , Room(room)
  {
  }

  /// To be called when a slab has been found.
  void add(std::size_t slab)
  {
    std::unique_lock lock(this->Guard);
    this->Found.resize(this->Cells.slabs.size());
    this->Found[slab] = true;
    while (this->Counted < this->Found.size() && this->Found[this->Counted])
    {
      CrossedCells::Slab& next = this->Cells.slabs[this->Counted++];
      next.before = this->Cells.count;
      this->Cells.count += next.count;
    }
    while (this->Taken < this->Counted && this->fits(this->Taken))
    {
      const std::size_t own = this->Taken++;
      lock.unlock();
      this->place(own);
      lock.lock();
    }
  }

  /// Places those that the room was too small for, in one that is large enough.
  bool finish(const SampleRoom& room, const Progress& progress)
  {
    this->Room = room;
    const std::size_t first = this->Taken;
    const auto placeSlab = [&](std::size_t s) { this->place(first + s); };
    return parallelFor(this->Cells.slabs.size() - first, placeSlab, progress);
  }

private:
  bool fits(std::size_t slab) const
  {
    return this->Cells.slabs[slab].before + this->Cells.slabs[slab].count <= this->Room.capacity;
  }
  void place(std::size_t slab)
  {
    CrossedCells::Slab& own = this->Cells.slabs[slab];
    this->Placer.place(own, after(this->Room, own.before));
    own.runs = {};
  }

  SamplePlacer<T, Work> Placer;
  CrossedCells& Cells;
  SampleRoom Room;
  std::mutex Guard;
  std::vector<char> Found;
  std::size_t Counted = 0; ///< slabs whose place is known
  std::size_t Taken = 0;   ///< slabs that are placed or being placed
};

template <class Work, class T>
bool sampleOne(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const CellSelection& selection, BrickRanges* ranges, const GrowRoom& grow, std::size_t expected,
  std::vector<std::size_t>& counts, const Progress& progress)
{
  CrossedCells cells;
  SamplesOnTheWay<T, Work> samples(field, isoValue, options, cells, grow(expected));
  if (!findCrossedCellsBySlab(field, isoValue, options.rule, selection, progress, ranges, cells,
        [&](std::size_t s) { samples.add(s); }))
  {
    return false;
  }
  counts.assign(1, cells.count);
  return samples.finish(grow(cells.count), progress);
}

/// Several surfaces: the second's samples follow the first's, so all are counted before any is placed.
template <class Work, class T>
bool sampleSeveral(const GridField<T>& field, std::span<const double> isoValues, const SampleOptions& options,
  const CellSelection& selection, BrickRanges* ranges, const GrowRoom& grow, std::vector<std::size_t>& counts,
  const Progress& progress)
{
  bool stopped = false;
  const Progress watch = [&](double done)
  {
    stopped = progress && !progress(0.5 * done);
    return !stopped;
  };
  const std::vector<CrossedCells> cells =
    findCrossedCells(field, isoValues, options.rule, selection, watch, ranges);
  if (stopped)
  {
    return false;
  }
  std::size_t total = 0;
  for (const CrossedCells& found : cells)
  {
    counts.push_back(found.count);
    total += found.count;
  }
  SampleRoom to = grow(total);
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    const double share = 0.5 / static_cast<double>(cells.size());
    const Progress part = [&](double done)
    { return !progress || progress(0.5 + share * (static_cast<double>(n) + done)); };
    if (!placeAll<Work>(field, isoValues[n], options, cells[n], to, part))
    {
      return false;
    }
    to = after(to, cells[n].count);
  }
  return true;
}

template <class Work, class T>
bool sampleAll(const GridField<T>& field, std::span<const double> isoValues, const SampleOptions& options,
  const CellSelection& selection, BrickRanges* ranges, const GrowRoom& grow, std::size_t expected,
  std::vector<std::size_t>& counts, const Progress& progress)
{
  counts.clear();
  return isoValues.size() == 1
    ? sampleOne<Work>(field, isoValues.front(), options, selection, ranges, grow, expected, counts, progress)
    : sampleSeveral<Work>(field, isoValues, options, selection, ranges, grow, counts, progress);
}

} // namespace

template <class T, class Real>
bool placeIsoSurfaceSamples(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const CrossedCells& cells, std::span<Real> points, std::span<float> normals, const Progress& progress)
{
  if (points.size() != 3 * cells.count || (!normals.empty() && normals.size() != 3 * cells.count))
  {
    throw std::invalid_argument("points and normals must have three numbers for each cell");
  }
  if (cells.count == 0)
  {
    return true;
  }
  SampleRoom to;
  to.normals = normals.empty() ? nullptr : normals.data();
  to.capacity = cells.count;
  if constexpr (std::is_same_v<Real, float>)
  {
    to.points = points.data();
    if constexpr (FitsSingle<T>)
    {
      if (options.arithmetic == Arithmetic::Single)
      {
        return placeAll<float>(field, isoValue, options, cells, to, progress);
      }
    }
  }
  else
  {
    to.doublePoints = points.data();
  }
  return placeAll<double>(field, isoValue, options, cells, to, progress);
}

template <class T>
bool sampleIsoSurfaces(const GridField<T>& field, std::span<const double> isoValues,
  const SampleOptions& options, const CellSelection& selection, BrickRanges* ranges, const GrowRoom& grow,
  std::size_t expected, std::vector<std::size_t>& counts, const Progress& progress)
{
  if constexpr (FitsSingle<T>)
  {
    if (options.arithmetic == Arithmetic::Single)
    {
      return sampleAll<float>(field, isoValues, options, selection, ranges, grow, expected, counts, progress);
    }
  }
  return sampleAll<double>(field, isoValues, options, selection, ranges, grow, expected, counts, progress);
}

double isoSurfaceSampleRadius(const GridGeometry& geometry)
{
  // The longest of the four diagonals, which differ where the axes are not at right angles.
  double longest = 0.0;
  for (const double y : { -1.0, 1.0 })
  {
    for (const double z : { -1.0, 1.0 })
    {
      const glm::dvec3 diagonal = geometry.stepToWorld() * glm::dvec3(1.0, y, z);
      // Does not square what is too large or too small for it.
      longest = std::max(longest, std::hypot(diagonal.x, diagonal.y, diagonal.z));
    }
  }
  return 0.5 * longest;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, const SampleOptions&,                    \
    const CrossedCells&, std::span<float>, std::span<float>, const Progress&);                               \
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, const SampleOptions&,                    \
    const CrossedCells&, std::span<double>, std::span<float>, const Progress&);                              \
  template bool sampleIsoSurfaces(const GridField<T>&, std::span<const double>, const SampleOptions&,        \
    const CellSelection&, BrickRanges*, const GrowRoom&, std::size_t, std::vector<std::size_t>&,             \
    const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)

} // namespace ink
