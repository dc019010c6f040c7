// Cells are listed slab by slab, and their stencils loaded and worked on a batch at a time by Kernels/. What those
// loops leave over, a handful of cells, is done one by one by CarefulSample.

#include "Sampling/IsoSurfaceSamples.h"

#include "Fields/Scalars.h"
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

/// Where samples go.
template <class Real>
struct SampleTargets
{
  Real* points;
  float* floats;
  std::int16_t* shorts;
  std::int8_t* bytes;

  bool normals() const { return this->floats || this->shorts || this->bytes; }
};

/// One component of a batch's cells in the world, from the float or double that it was computed in.
template <class Real, class From>
void writePoints(const SamplingKernels& kernels, const CellBatch<From>& batch, int count, Real* points)
{
  if constexpr (std::is_same_v<Real, float> && std::is_same_v<From, float>)
  {
    kernels.interleave(batch.points[0], batch.points[1], batch.points[2], count, points);
  }
  else
  {
    for (int i = 0; i < count; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        points[3 * i + axis] = static_cast<Real>(batch.points[axis][i]);
      }
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
template <class T, class Work, class Real>
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
      static_cast<std::ptrdiff_t>(field.geometry().sampleCount()) >= this->Steps[1] + this->Steps[2] + 4;
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
  }

  void place(const CrossedCells::Slab& slab, SampleTargets<Real> to) const
  {
    const std::vector<std::uint32_t> codes = listCells(slab);
    const auto batch = std::make_unique<CellBatch<Work>>();
    std::fill_n(&batch->values[0][0], sizeof(batch->values) / sizeof(Work), Work(0));
    const bool normals = to.normals();
    for (std::size_t at = 0; at < slab.count; at += BatchSize)
    {
      const int count = static_cast<int>(std::min<std::size_t>(BatchSize, slab.count - at));
      this->placeBatch(slab, codes.data() + at, count, normals, *batch);
      writePoints(this->Kernels, *batch, count, to.points);
      to.points += 3 * count;
      if (to.floats)
      {
        this->Kernels.interleave(batch->normals[0], batch->normals[1], batch->normals[2], count, to.floats);
        to.floats += 3 * count;
      }
      else if (to.shorts)
      {
        writeQuantized(batch->normals, count, to.shorts);
        to.shorts += 3 * count;
      }
      else if (to.bytes)
      {
        writeQuantized(batch->normals, count, to.bytes);
        to.bytes += 3 * count;
      }
    }
  }

private:
  /// A number for each cell: its run's, times 64, plus its bit's. Padded so that batches may be read in whole.
  static std::vector<std::uint32_t> listCells(const CrossedCells::Slab& slab)
  {
    std::vector<std::uint32_t> codes(slab.count + 64 + BatchStride);
    std::uint32_t* next = codes.data();
    std::uint32_t first = 0;
    for (const CellRun& run : slab.runs)
    {
      std::uint64_t rest = run.cells;
      const int count = std::popcount(rest);
      // Always so many, because few runs have more, and a branch that follows the count is foretold wrongly.
      constexpr int usual = 8;
      for (int n = 0; n < usual; ++n)
      {
        next[n] = first + static_cast<std::uint32_t>(std::countr_zero(rest));
        rest &= rest - 1;
      }
      for (int n = usual; n < count; ++n)
      {
        next[n] = first + static_cast<std::uint32_t>(std::countr_zero(rest));
        rest &= rest - 1;
      }
      next += count;
      first += 64;
    }
    return codes;
  }

  static glm::ivec3 cellOf(const CrossedCells::Slab& slab, std::uint32_t code)
  {
    return slab.runs[code >> 6].first + glm::ivec3(code & 63, 0, 0);
  }

  void placeBatch(const CrossedCells::Slab& slab, const std::uint32_t* codes, int count, bool normals,
    CellBatch<Work>& batch) const
  {
    const std::uint64_t all = ~std::uint64_t(0) >> (BatchSize - count);
    const bool wide = this->Options.method == NormalMethod::Regression;
    this->findCorners(slab, codes, count, batch);
    std::uint64_t careful = this->load(slab, codes, count, normals, batch);
    const int axes = static_cast<int>(this->Axes);
    const auto& place = this->place_();
    careful |= place.findPoints[this->Options.rule == CrossingRule::Strict][wide][axes](batch, this->Terms, count);
    if (normals)
    {
      careful |=
        place.findNormals[static_cast<int>(this->Options.method)][axes](batch, this->Terms, count);
    }
    for (std::uint64_t rest = careful & all; rest != 0; rest &= rest - 1)
    {
      const int lane = std::countr_zero(rest);
      this->placeCarefully(cellOf(slab, codes[lane]), lane, normals, batch);
    }
  }

  const PlaceKernels<Work>& place_() const
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

  /// From global indices, so that the pieces of a grid agree to the last bit.
  void findCorners(
    const CrossedCells::Slab& slab, const std::uint32_t* codes, int count, CellBatch<Work>& batch) const
  {
    for (int i = 0; i < count; ++i)
    {
      const glm::ivec3 cell = cellOf(slab, codes[i]);
      if (this->Axes == GridAxes::General)
      {
        const glm::dvec3 corner = this->Field.geometry().toWorld(cell);
        batch.corners[0][i] = static_cast<Work>(corner.x);
        batch.corners[1][i] = static_cast<Work>(corner.y);
        batch.corners[2][i] = static_cast<Work>(corner.z);
      }
      else
      {
        batch.corners[0][i] = this->Corners[0][cell.x];
        batch.corners[1][i] = this->Corners[1][cell.y];
        batch.corners[2][i] = this->Corners[2][cell.z];
      }
    }
  }

  /// Loads the cells' stencils. Returns a bit for each that the loops cannot do.
  std::uint64_t load(const CrossedCells::Slab& slab, const std::uint32_t* codes, int count, bool normals,
    CellBatch<Work>& batch) const
  {
    const glm::ivec3 last = this->Last;
    std::ptrdiff_t offsets[BatchStride];
    std::uint64_t border = 0;
    for (int i = 0; i < count; ++i)
    {
      const glm::ivec3 cell = cellOf(slab, codes[i]);
      offsets[i] = cell.x * this->Steps[0] + cell.y * this->Steps[1] + cell.z * this->Steps[2];
      const bool atBorder = (cell.x == 0) | (cell.y == 0) | (cell.z == 0) | (cell.x == last.x) |
        (cell.y == last.y) | (cell.z == last.z);
      border |= static_cast<std::uint64_t>(atBorder) << i;
    }
    std::fill(offsets + count, offsets + BatchStride, offsets[count - 1]);
    std::uint64_t careful = 0;
    bool loaded = false;
    if constexpr (std::is_same_v<Work, float>)
    {
      if (this->Load && this->CanLoad)
      {
        this->loadQuickly(slab, codes, count, offsets, border, batch);
        loaded = true;
      }
    }
    if (!loaded)
    {
      this->loadOneByOne(slab, codes, count, offsets, border, batch);
    }
    if (normals && this->Options.method != NormalMethod::Cell)
    {
      for (std::uint64_t rest = border; rest != 0; rest &= rest - 1)
      {
        const int lane = std::countr_zero(rest);
        this->extrapolate(cellOf(slab, codes[lane]), lane, batch);
      }
      for (int i = 0; i < count && !this->Field.hidden().empty(); ++i)
      {
        careful |= static_cast<std::uint64_t>(this->hasHidden(cellOf(slab, codes[i]))) << i;
      }
    }
    return careful;
  }

  /// By vectors of neighbouring samples. Rows beyond the grid's border are replaced by those at it.
  void loadQuickly(const CrossedCells::Slab& slab, const std::uint32_t* codes, int count, std::ptrdiff_t* offsets,
    std::uint64_t border, CellBatch<float>& batch) const
  {
    using K = KernelScalar<T>;
    StencilSource<K> source = { reinterpret_cast<const K*>(this->Field.data()), offsets, this->Steps[1],
      this->Steps[2], {} };
    std::ptrdiff_t distances[4][BatchStride];
    std::uint64_t outside = 0;
    if (border != 0)
    {
      const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(this->Field.geometry().sampleCount());
      const std::ptrdiff_t y = this->Steps[1];
      const std::ptrdiff_t z = this->Steps[2];
      for (int i = 0; i < count; ++i)
      {
        const glm::ivec3 cell = cellOf(slab, codes[i]);
        distances[0][i] = cell.y == 0 ? 0 : -y;
        distances[1][i] = cell.y == this->Last.y ? y : 2 * y;
        distances[2][i] = cell.z == 0 ? 0 : -z;
        distances[3][i] = cell.z == this->Last.z ? z : 2 * z;
        // A row of four samples begins or ends outside the array only at its first or last sample.
        const bool isOutside = offsets[i] + distances[0][i] + distances[2][i] < 1 ||
          offsets[i] + distances[1][i] + distances[3][i] + 2 >= end;
        outside |= static_cast<std::uint64_t>(isOutside) << i;
      }
      for (std::uint64_t rest = outside; rest != 0; rest &= rest - 1)
      {
        // Something that can be read; the cell itself is loaded afterwards.
        const int i = std::countr_zero(rest);
        offsets[i] = 1;
        distances[0][i] = distances[2][i] = 0;
        distances[1][i] = y;
        distances[3][i] = z;
      }
      for (int n = 0; n < 4; ++n)
      {
        std::fill(distances[n] + count, distances[n] + BatchStride, distances[n][count - 1]);
        source.border[n] = distances[n];
      }
      std::fill(offsets + count, offsets + BatchStride, offsets[count - 1]);
    }
    this->Load(source, count, batch);
    for (std::uint64_t rest = outside; rest != 0; rest &= rest - 1)
    {
      const int lane = std::countr_zero(rest);
      this->loadClamped(cellOf(slab, codes[lane]), lane, batch);
    }
  }

  void loadOneByOne(const CrossedCells::Slab& slab, const std::uint32_t* codes, int count,
    const std::ptrdiff_t* offsets, std::uint64_t border, CellBatch<Work>& batch) const
  {
    const int size = this->stencilSize();
    for (int i = 0; i < count; ++i)
    {
      if (border >> i & 1)
      {
        this->loadClamped(cellOf(slab, codes[i]), i, batch);
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
    return this->Options.method == NormalMethod::Cell ? Corners8
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

  /// Neighbours beyond the grid's border, from the edge that they continue: the central difference becomes
  /// one-sided.
  void extrapolate(const glm::ivec3& cell, int lane, CellBatch<Work>& batch) const
  {
    const auto extend = [&](int outer, int near, int far)
    { batch.values[outer][lane] = Work(2) * batch.values[near][lane] - batch.values[far][lane]; };
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool first = cell[axis] == 0;
      const bool last = cell[axis] == this->Last[axis];
      if (this->Options.method == NormalMethod::Regression)
      {
        constexpr int steps[3] = { 1, 4, 16 };
        const int step = steps[axis];
        for (int n = 0; n < 16; ++n)
        {
          const int outer = axis == 0 ? 4 * n : axis == 1 ? n % 4 + 16 * (n / 4) : n;
          if (first)
          {
            extend(outer, outer + step, outer + 2 * step);
          }
          if (last)
          {
            extend(outer + 3 * step, outer + 2 * step, outer + step);
          }
        }
        continue;
      }
      for (int n = 0; n < 4; ++n)
      {
        if (first)
        {
          extend(neighbourBefore(axis, n), lowCorner(axis, n), highCorner(axis, n));
        }
        if (last)
        {
          extend(neighbourAfter(axis, n), highCorner(axis, n), lowCorner(axis, n));
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
    const glm::dvec3 point = this->Field.geometry().toWorld(glm::dvec3(cell) + mean);
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
    const glm::dvec3 normal = carefulNormal(stencil, mean, this->Options.rule, this->Options.method,
      this->Field.geometry().gradientDirection());
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
};

template <class Work, class T, class Real>
bool placeAll(const GridField<T>& field, double isoValue, const SampleOptions& options, const CrossedCells& cells,
  std::span<Real> points, const NormalSpans& normals, const Progress& progress)
{
  const SamplePlacer<T, Work, Real> placer(field, isoValue, options);
  const auto placeSlab = [&](std::size_t s)
  {
    const CrossedCells::Slab& slab = cells.slabs[s];
    const std::size_t first = 3 * slab.before;
    const auto from = [first](auto span) { return span.empty() ? nullptr : span.data() + first; };
    placer.place(slab, { from(points), from(normals.floats), from(normals.shorts), from(normals.bytes) });
  };
  return parallelFor(cells.slabs.size(), placeSlab, progress);
}

} // namespace

template <class T, class Real>
bool placeIsoSurfaceSamples(const GridField<T>& field, double isoValue, const SampleOptions& options,
  const CrossedCells& cells, std::span<Real> points, const NormalSpans& normals, const Progress& progress)
{
  const auto fits = [&](std::size_t size) { return size == 0 || size == 3 * cells.count; };
  if (points.size() != 3 * cells.count || !fits(normals.floats.size()) || !fits(normals.shorts.size()) ||
    !fits(normals.bytes.size()))
  {
    throw std::invalid_argument("points and normals must have three numbers for each cell");
  }
  if (cells.count == 0)
  {
    return true;
  }
  if constexpr (FitsSingle<T> && std::is_same_v<Real, float>)
  {
    if (options.arithmetic == Arithmetic::Single)
    {
      return placeAll<float>(field, isoValue, options, cells, points, normals, progress);
    }
  }
  return placeAll<double>(field, isoValue, options, cells, points, normals, progress);
}

double isoSurfaceSampleRadius(const GridGeometry& geometry)
{
  // The longest of the four diagonals, which differ where the axes are not at right angles.
  double longest = 0.0;
  for (const double y : { -1.0, 1.0 })
  {
    for (const double z : { -1.0, 1.0 })
    {
      longest = std::max(longest, glm::length(geometry.stepToWorld() * glm::dvec3(1.0, y, z)));
    }
  }
  return 0.5 * longest;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, const SampleOptions&, const CrossedCells&, \
    std::span<float>, const NormalSpans&, const Progress&);                                                  \
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, const SampleOptions&, const CrossedCells&, \
    std::span<double>, const NormalSpans&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)

} // namespace ink
