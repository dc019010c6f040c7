// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Derivatives/Gradients.h"

#include "Core/ParallelFor.h"
#include "Fields/Derivatives/GradientRows.h"
#include "Fields/Derivatives/GradientSource.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

/// Slices and rows per task. The rows that a row's results depend on stay in the cache from one slice to the
/// next, so that each sample is fetched from memory about once.
constexpr int tileSlices = 16;
constexpr int mostTileRows = 64;
constexpr int leastTileRows = 8;
constexpr std::size_t tileBytes = 192 * 1024;

double largestCoefficient(const glm::dmat3& m)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 column = glm::abs(m[axis]);
    largest = std::max({ largest, column.x, column.y, column.z });
  }
  return largest;
}

/// Whether no coefficient leaves the normal range of a float.
bool suitsFloat(const glm::dmat3& m)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int component = 0; component < 3; ++component)
    {
      const double size = std::abs(m[axis][component]);
      if (!(size == 0.0 || (size > 1e-30 && size < 1e30)))
      {
        return false;
      }
    }
  }
  return true;
}

/// Derivatives per sample step to derivatives per world unit, as one matrix.
glm::dmat3 stepsToWorld(const GridGeometry& geometry)
{
  return glm::dmat3(geometry.gradientToWorld({ 1, 0, 0 }), geometry.gradientToWorld({ 0, 1, 0 }),
    geometry.gradientToWorld({ 0, 0, 1 }));
}

template <class Real>
Real bounded(double value)
{
  constexpr double largest = static_cast<double>(std::numeric_limits<Real>::max());
  return std::isnan(value) ? Real(0) : static_cast<Real>(std::clamp(value, -largest, largest));
}

/// One pass over a box, with row sums in Work.
template <class Work, class Real>
class Estimate
{
public:
  Estimate(const GradientSource<Work>& source, const SampleBox& box, const GradientOptions& options,
    const GradientArrays<Real>& arrays, const glm::dmat3& toWorld)
    : Source(source)
    , Box(box)
    , Options(options)
    , Arrays(arrays)
    , Reach(gradientReach(options))
    , Dimensions(source.geometry().dimensions())
    , ToWorld(toWorld)
    , WorkToWorld(toWorld)
    , Limit(static_cast<Work>(static_cast<double>(std::numeric_limits<Work>::max()) / 1e4 /
        std::max(1.0, largestCoefficient(toWorld))))
    , RowBegin(std::max(0, box.begin.x - Reach))
    , RowSize(static_cast<std::size_t>(std::min(Dimensions.x, box.end.x + Reach) - RowBegin))
  {
    if (source.stencils())
    {
      this->chooseRowKernel(*source.stencils());
    }
    const std::size_t rowBytes = (2 * this->Reach + 1) * this->RowSize * sizeof(Work);
    this->TileRows =
      static_cast<int>(std::clamp<std::size_t>(tileBytes / rowBytes, leastTileRows, mostTileRows));
  }

  bool run(const Progress& progress) const
  {
    const glm::ivec3 size = this->Box.size();
    const int across = (size.y + this->TileRows - 1) / this->TileRows;
    const int along = (size.z + tileSlices - 1) / tileSlices;
    const auto tile = [&](std::size_t n)
    {
      const int t = static_cast<int>(n);
      SampleBox part = this->Box;
      part.begin.y += t % across * this->TileRows;
      part.end.y = std::min(part.end.y, part.begin.y + this->TileRows);
      part.begin.z += t / across * tileSlices;
      part.end.z = std::min(part.end.z, part.begin.z + tileSlices);
      this->estimate(part);
    };
    return parallelFor(static_cast<std::size_t>(across) * along, tile, progress);
  }

private:
  /// Converted rows of the slices around the current one.
  struct RowCache
  {
    int firstRow;
    int rows;
    int slices;
    std::size_t pitch;
    std::vector<Work> samples;
    std::vector<std::uint8_t> marks;
    std::vector<std::uint8_t> marked;

    std::size_t index(int j, int k) const
    {
      return static_cast<std::size_t>(k % this->slices) * this->rows + (j - this->firstRow);
    }
  };

  void chooseRowKernel(const RegressionStencils<Work>& stencils)
  {
    this->Mirrored = this->Options.weighting == RegressionWeighting::InverseDistance;
    // The kernel inside the grid, where neighborhoods are complete.
    const std::vector<glm::ivec3>& offsets = stencils.offsets();
    const std::vector<double>& weights = stencils.weights();
    const RegressionKernel kernel(offsets, weights);
    const int width = 2 * this->Reach + 1;
    for (std::size_t n = 0; n < offsets.size(); ++n)
    {
      const glm::ivec3 corner = glm::abs(offsets[n]);
      const std::size_t mirrored =
        (corner.x + this->Reach) + width * ((corner.y + this->Reach) + width * (corner.z + this->Reach));
      // Even with orthogonal axes, distances may differ by rounding.
      this->Mirrored = this->Mirrored && std::abs(weights[n] - weights[mirrored]) <= 1e-12;
      if (corner == offsets[n])
      {
        this->MirrorKernel.x[corner.z][corner.y][corner.x] = static_cast<Work>(kernel.gradient[n].x);
        this->MirrorKernel.y[corner.z][corner.y][corner.x] = static_cast<Work>(kernel.gradient[n].y);
        this->MirrorKernel.z[corner.z][corner.y][corner.x] = static_cast<Work>(kernel.gradient[n].z);
        this->MirrorKernel.value[corner.z][corner.y][corner.x] = static_cast<Work>(kernel.value[n]);
      }
    }
  }

  void estimate(const SampleBox& tile) const
  {
    RowCache cache;
    cache.firstRow = std::max(0, tile.begin.y - this->Reach);
    cache.rows = std::min(this->Dimensions.y, tile.end.y + this->Reach) - cache.firstRow;
    cache.slices = 2 * this->Reach + 1;
    cache.pitch = this->RowSize;
    const std::size_t rows = static_cast<std::size_t>(cache.rows) * cache.slices;
    cache.samples.resize(rows * cache.pitch);
    cache.marks.resize(rows * cache.pitch);
    cache.marked.resize(rows);

    int read = std::max(0, tile.begin.z - this->Reach);
    for (int k = tile.begin.z; k < tile.end.z; ++k)
    {
      for (; read < std::min(this->Dimensions.z, k + this->Reach + 1); ++read)
      {
        for (int j = cache.firstRow; j < cache.firstRow + cache.rows; ++j)
        {
          const std::size_t row = cache.index(j, read);
          cache.marked[row] = this->Source.readRow(j, read, this->RowBegin, this->Limit,
            { cache.samples.data() + row * cache.pitch, cache.pitch },
            { cache.marks.data() + row * cache.pitch, cache.pitch });
        }
      }
      for (int j = tile.begin.y; j < tile.end.y; ++j)
      {
        this->estimateRow(cache, j, k);
      }
    }
  }

  void estimateRow(const RowCache& cache, int j, int k) const
  {
    // Samples so close to an end of the row that neighbors along it are missing are left to the slow path.
    const int from = std::max(this->Box.begin.x, this->Reach);
    const int to = std::max(from, std::min(this->Box.end.x, this->Dimensions.x - this->Reach));
    RowsAround<Work> rows{};
    std::vector<const std::uint8_t*> marks;
    bool complete = true;
    for (int c = -this->Reach; c <= this->Reach; ++c)
    {
      for (int b = -this->Reach; b <= this->Reach; ++b)
      {
        if (j + b < 0 || j + b >= this->Dimensions.y || k + c < 0 || k + c >= this->Dimensions.z)
        {
          complete = false;
          continue;
        }
        const std::size_t row = cache.index(j + b, k + c);
        rows[c + 2][b + 2] = cache.samples.data() + row * cache.pitch;
        if (cache.marked[row])
        {
          marks.push_back(cache.marks.data() + row * cache.pitch);
        }
      }
    }
    if (complete || this->Options.method == GradientMethod::Regression)
    {
      this->estimateEnds(rows, marks, this->Box.begin.x, std::min(from, this->Box.end.x), j, k);
      this->estimateInside(rows, complete, from, to, j, k);
      this->repair(marks, from, to, j, k);
      this->estimateEnds(rows, marks, std::max(to, this->Box.begin.x), this->Box.end.x, j, k);
      return;
    }
    for (int i = this->Box.begin.x; i < this->Box.end.x; ++i)
    {
      this->estimateSample({ i, j, k }, !marks.empty());
    }
  }

  /// Samples close to an end of the row.
  void estimateEnds(const RowsAround<Work>& rows, const std::vector<const std::uint8_t*>& marks, int from,
    int to, int j, int k) const
  {
    IndexGradients<Work> gradients;
    for (int i = from; i < to; ++i)
    {
      // Marks further along the row do not count: how much of it was read depends on the box.
      const int first = std::max(0, i - this->Reach) - this->RowBegin;
      const int last = std::min(this->Dimensions.x - 1, i + this->Reach) - this->RowBegin;
      const bool touched = std::any_of(marks.begin(), marks.end(),
        [&](const std::uint8_t* row)
        { return std::any_of(row + first, row + last + 1, [](auto mark) { return mark != Plain; }); });
      if (touched || this->Options.method == GradientMethod::CentralDifference)
      {
        this->estimateSample({ i, j, k }, touched);
      }
      else
      {
        convolveRows<Work>(
          this->Source.stencils()->taps({ i, j, k }), shifted(rows, i - this->RowBegin), 1, gradients);
        this->store(gradients, 1, { i, j, k });
      }
    }
  }

  void estimateInside(const RowsAround<Work>& rows, bool complete, int from, int to, int j, int k) const
  {
    const bool regression = this->Options.method == GradientMethod::Regression;
    const bool uniform = this->Options.weighting == RegressionWeighting::Uniform;
    IndexGradients<Work> gradients;
    for (int i = from; i < to; i += static_cast<int>(rowChunk))
    {
      const std::size_t count = std::min<std::size_t>(rowChunk, static_cast<std::size_t>(to - i));
      const RowsAround<Work> chunk = shifted(rows, i - this->RowBegin);
      if (!regression)
      {
        differentiateRows(chunk, count, gradients);
      }
      else if (!complete || !(uniform || this->Mirrored))
      {
        convolveRows<Work>(this->Source.stencils()->taps({ from, j, k }), chunk, count, gradients);
      }
      else if (uniform)
      {
        fitUniformRows(this->Reach, chunk, count, gradients);
      }
      else
      {
        fitMirroredRows(this->Reach, this->MirrorKernel, chunk, count, gradients);
      }
      this->store(gradients, count, { i, j, k });
    }
  }

  static RowsAround<Work> shifted(RowsAround<Work> rows, int by)
  {
    for (auto& slice : rows)
    {
      for (const Work*& row : slice)
      {
        row = row ? row + by : row;
      }
    }
    return rows;
  }

  void store(const IndexGradients<Work>& gradients, std::size_t count, const glm::ivec3& sample) const
  {
    const std::size_t first = this->outputIndex(sample);
    storeRows<Work, Real>(gradients, this->WorkToWorld, count,
      { this->Arrays.gradient.empty() ? nullptr : this->Arrays.gradient.data() + 3 * first,
        this->Arrays.magnitude.empty() ? nullptr : this->Arrays.magnitude.data() + first,
        this->Arrays.value.empty() ? nullptr : this->Arrays.value.data() + first });
  }

  /// Recomputes the estimates that depend on marked samples.
  void repair(const std::vector<const std::uint8_t*>& marks, int from, int to, int j, int k) const
  {
    if (marks.empty())
    {
      return;
    }
    std::vector<std::uint8_t> any(this->RowSize);
    for (const std::uint8_t* row : marks)
    {
      for (std::size_t i = 0; i < any.size(); ++i)
      {
        any[i] |= row[i];
      }
    }
    for (int i = from; i < to; ++i)
    {
      const auto middle = any.begin() + (i - this->RowBegin);
      if (std::any_of(middle - this->Reach, middle + this->Reach + 1, [](auto mark) { return mark != 0; }))
      {
        this->estimateSample({ i, j, k }, true);
      }
    }
  }

  /// One sample, in double precision. `mayMiss`: some neighbors on the grid may be missing.
  void estimateSample(const glm::ivec3& sample, bool mayMiss) const
  {
    auto [gradient, value] = this->Source.at(sample, mayMiss);
    // Relative to its largest component, so that intermediate sums over the axes do not overflow when the
    // result does not.
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      gradient[axis] = bounded<double>(gradient[axis]);
      size = std::max(size, std::abs(gradient[axis]));
    }
    const glm::dvec3 world = size > 0.0 ? this->ToWorld * (gradient / size) : glm::dvec3(0.0);
    const std::size_t n = this->outputIndex(sample);
    if (!this->Arrays.gradient.empty())
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Arrays.gradient[3 * n + axis] = bounded<Real>(world[axis] * size);
      }
    }
    if (!this->Arrays.magnitude.empty())
    {
      this->Arrays.magnitude[n] = bounded<Real>(std::hypot(world.x, world.y, world.z) * size);
    }
    if (!this->Arrays.value.empty())
    {
      this->Arrays.value[n] = bounded<Real>(value);
    }
  }

  std::size_t outputIndex(const glm::ivec3& sample) const
  {
    const glm::ivec3 size = this->Box.size();
    const glm::ivec3 p = sample - this->Box.begin;
    return p.x + static_cast<std::size_t>(size.x) * (p.y + static_cast<std::size_t>(size.y) * p.z);
  }

  const GradientSource<Work>& Source;
  SampleBox Box;
  GradientOptions Options;
  GradientArrays<Real> Arrays;
  int Reach;
  glm::ivec3 Dimensions;
  glm::dmat3 ToWorld;
  glm::mat<3, 3, Work> WorkToWorld;
  Work Limit;
  int RowBegin;
  std::size_t RowSize;
  int TileRows;
  bool Mirrored = false;
  MirroredKernel<Work> MirrorKernel;
};

void requireSize(std::size_t found, std::size_t expected)
{
  if (found != 0 && found != expected)
  {
    throw std::invalid_argument("an array for gradients has not the size of the box");
  }
}

} // namespace

int gradientReach(const GradientOptions& options)
{
  return options.method == GradientMethod::CentralDifference ? 1 : options.radius;
}

template <class T, class Real>
bool estimateGradients(const GridField<T>& field, const SampleBox& box, const GradientOptions& options,
  const GradientArrays<Real>& arrays, const Progress& progress)
{
  if (options.method == GradientMethod::Regression && options.radius != 1 && options.radius != 2)
  {
    throw std::invalid_argument("the radius of a regression's neighborhood must be 1 or 2");
  }
  requireSize(arrays.gradient.size(), 3 * box.count());
  requireSize(arrays.magnitude.size(), box.count());
  requireSize(arrays.value.size(), box.count());
  if (box.empty() || (arrays.gradient.empty() && arrays.magnitude.empty() && arrays.value.empty()))
  {
    return true;
  }
  if (glm::any(glm::lessThan(box.begin, glm::ivec3(0))) ||
    glm::any(glm::greaterThan(box.end, field.geometry().dimensions())))
  {
    throw std::invalid_argument("gradients are asked for outside the grid");
  }
  const glm::dmat3 toWorld = stepsToWorld(field.geometry());
  const auto run = [&]<class Work>()
  {
    const FieldGradientSource<T, Work> source(field, options);
    return Estimate<Work, Real>(source, box, options, arrays, toWorld).run(progress);
  };
  if constexpr (std::is_same_v<Real, float> && (std::is_same_v<T, float> || sizeof(T) <= 2))
  {
    if (suitsFloat(toWorld))
    {
      return run.template operator()<float>();
    }
  }
  return run.template operator()<double>();
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool estimateGradients(const GridField<T>&, const SampleBox&, const GradientOptions&,             \
    const GradientArrays<float>&, const Progress&);                                                          \
  template bool estimateGradients(const GridField<T>&, const SampleBox&, const GradientOptions&,             \
    const GradientArrays<double>&, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
