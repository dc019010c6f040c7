#include "Fields/LaplacianOfGaussian.h"

#include "Fields/LineKernels.h"
#include "Fields/SampleRows.h"
#include "Fields/Scalars.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

/// How the world's Laplacian is made of the second derivatives per sample step: factors of xx, yy, zz, xy,
/// xz, yz.
struct LaplacianFactors
{
  glm::dvec3 straight;
  double xy;
  double xz;
  double yz;

  explicit LaplacianFactors(const GridGeometry& geometry)
    : straight(of(geometry, 0, 0), of(geometry, 1, 1), of(geometry, 2, 2))
    , xy(of(geometry, 0, 1))
    , xz(of(geometry, 0, 2))
    , yz(of(geometry, 1, 2))
  {
    // Right angles are right but for rounding.
    constexpr double rounding = 1e-13;
    const auto drop = [](double& mixed, double a, double b)
    { mixed = std::abs(mixed) <= rounding * std::sqrt(a) * std::sqrt(b) ? 0.0 : mixed; };
    drop(this->xy, this->straight.x, this->straight.y);
    drop(this->xz, this->straight.x, this->straight.z);
    drop(this->yz, this->straight.y, this->straight.z);
  }

private:
  static double of(const GridGeometry& geometry, int a, int b)
  {
    glm::dmat3 second(0.0);
    second[a][b] = second[b][a] = 1.0;
    const glm::dmat3 world = geometry.hessianToWorld(second);
    return world[0][0] + world[1][1] + world[2][2];
  }
};

enum class Derivative
{
  None,
  First,
  Second
};

const std::vector<double>& coefficientsOf(const LineKernel& kernel, Derivative derivative)
{
  return derivative == Derivative::None ? kernel.smooth
    : derivative == Derivative::First   ? kernel.first
                                        : kernel.second;
}

/// A row of intermediate results and, where `marked`, which of them are missing.
struct Row
{
  double* values;
  std::uint8_t* missing;
  bool* marked;
};

/// Rows that lie beside each other along y or z, those beyond the grid null.
struct Line
{
  std::vector<Row> rows;

  bool anyMarked() const
  {
    return std::any_of(
      this->rows.begin(), this->rows.end(), [](const Row& row) { return row.values && *row.marked; });
  }
};

/// to += factor * derivative across the rows of a line, where nothing is missing. Derivatives are taken of
/// differences from the row in the middle, so that those of equal rows are exactly 0.
void addAcross(const Line& line, const LineKernel& kernel, Derivative derivative, double factor,
  std::size_t count, double* __restrict to)
{
  const std::vector<double>& coefficients = coefficientsOf(kernel, derivative);
  const double* const middle = line.rows[line.rows.size() / 2].values;
  for (std::size_t n = 0; n < line.rows.size(); ++n)
  {
    const double weight = factor * coefficients[n];
    const double* const row = line.rows[n].values;
    if (weight == 0.0)
    {
      continue;
    }
    if (derivative == Derivative::None)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        to[i] += weight * row[i];
      }
    }
    else if (row != middle)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        to[i] += weight * (row[i] - middle[i]);
      }
    }
  }
}

/// The derivative at sample i with the kernel of the rows that have it.
double acrossAt(const Line& line, const LineKernel& kernel, Derivative derivative, std::size_t i)
{
  const std::vector<double>& coefficients = coefficientsOf(kernel, derivative);
  // Relative to a value that is there.
  double reference = 0.0;
  double sum = 0.0;
  bool found = false;
  for (std::size_t n = 0; n < line.rows.size(); ++n)
  {
    if (coefficients[n] != 0.0)
    {
      const double value = line.rows[n].values[i];
      reference = found ? reference : value;
      found = true;
      sum += coefficients[n] * (value - reference);
    }
  }
  return derivative == Derivative::None ? reference + sum : sum;
}

bool isMissing(const Row& row, std::size_t i)
{
  return !row.values || (*row.marked && row.missing[i]);
}

template <class T, class Real>
class Laplacian
{
public:
  Laplacian(
    const GridField<T>& field, const SampleBox& box, const glm::dvec3& deviation, std::span<Real> laplacian)
    : Field(field)
    , Box(box)
    , Result(laplacian)
    , Dimensions(field.geometry().dimensions())
    , Reach(laplacianReach(deviation))
    , Factors(field.geometry())
    , X(deviation.x, Dimensions.x)
    , Y(deviation.y, Dimensions.y)
    , Z(deviation.z, Dimensions.z)
    , ReadBegin(std::max(0, box.begin.x - Reach.x))
    , ReadSize(static_cast<std::size_t>(std::min(Dimensions.x, box.end.x + Reach.x) - ReadBegin))
    , Width(static_cast<std::size_t>(box.size().x))
    , Mixed(Factors.xy != 0.0 || Factors.xz != 0.0 || Factors.yz != 0.0)
  {
    // The rows between the passes along y and z should stay in the cache.
    const std::size_t rowBytes = (2 * this->Reach.z + 1) * kinds * this->Width * sizeof(double);
    this->TileRows = static_cast<int>(std::clamp<std::size_t>(tileBytes / rowBytes, 8, 32));
    this->TileSlices = std::max(16, 4 * this->Reach.z);
  }

  bool run(const Progress& progress) const
  {
    const glm::ivec3 size = this->Box.size();
    const int across = (size.y + this->TileRows - 1) / this->TileRows;
    const int along = (size.z + this->TileSlices - 1) / this->TileSlices;
    const auto tile = [&](std::size_t n)
    {
      const int t = static_cast<int>(n);
      SampleBox part = this->Box;
      part.begin.y += t % across * this->TileRows;
      part.end.y = std::min(part.end.y, part.begin.y + this->TileRows);
      part.begin.z += t / across * this->TileSlices;
      part.end.z = std::min(part.end.z, part.begin.z + this->TileSlices);
      Passes(*this, part).run();
    };
    return parallelFor(static_cast<std::size_t>(across) * along, tile, progress);
  }

private:
  static constexpr std::size_t tileBytes = 512 * 1024;
  /// Intermediate results a row has: smoothed, second derivatives, and what mixed derivatives need.
  static constexpr int kinds = 3;

  /// Rows of intermediate results, all of one width.
  struct Rows
  {
    std::size_t width;
    std::vector<double> values;
    std::vector<std::uint8_t> missing;
    std::unique_ptr<bool[]> marked;

    Rows(std::size_t rows, std::size_t rowWidth)
      : width(rowWidth)
      , values(rows * kinds * rowWidth)
      , missing(rows * rowWidth)
      , marked(std::make_unique<bool[]>(rows))
    {
    }
    Row row(std::size_t n, int kind)
    {
      return { this->values.data() + (n * kinds + kind) * this->width, this->missing.data() + n * this->width,
        &this->marked[n] };
    }
  };

  /// The three passes over a tile, slice by slice.
  class Passes
  {
  public:
    Passes(const Laplacian& owner, const SampleBox& tile)
      : L(owner)
      , Tile(tile)
      , FirstRow(std::max(0, tile.begin.y - L.Reach.y))
      , LastRow(std::min(L.Dimensions.y, tile.end.y + L.Reach.y))
      , Ring(2 * L.Reach.z + 1)
      , TileHeight(tile.end.y - tile.begin.y)
      , Read(L.ReadSize)
      , ReadMarks(L.ReadSize)
      , AlongX(static_cast<std::size_t>(LastRow - FirstRow), L.Width)
      , AlongY(static_cast<std::size_t>(Ring) * TileHeight, L.Width)
    {
    }

    void run()
    {
      int next = std::max(0, this->Tile.begin.z - this->L.Reach.z);
      for (int k = this->Tile.begin.z; k < this->Tile.end.z; ++k)
      {
        for (; next < std::min(this->L.Dimensions.z, k + this->L.Reach.z + 1); ++next)
        {
          for (int j = this->FirstRow; j < this->LastRow; ++j)
          {
            this->passX(j, next);
          }
          for (int j = this->Tile.begin.y; j < this->Tile.end.y; ++j)
          {
            this->passY(j, next);
          }
        }
        for (int j = this->Tile.begin.y; j < this->Tile.end.y; ++j)
        {
          this->passZ(j, k);
        }
      }
    }

  private:
    void passX(int j, int k)
    {
      const bool odd = readRow<T, double>(this->L.Field, j, k, this->L.ReadBegin,
        std::numeric_limits<double>::infinity(), this->Read, this->ReadMarks);
      if constexpr (std::is_same_v<T, double>)
      {
        for (double& value : this->Read)
        {
          value *= doubleScale;
        }
      }
      const std::size_t n = static_cast<std::size_t>(j - this->FirstRow);
      Row out[kinds] = { this->AlongX.row(n, 0), this->AlongX.row(n, 1), this->AlongX.row(n, 2) };
      *out[0].marked = false;
      const int begin = this->L.Box.begin.x;
      const int end = this->L.Box.end.x;
      const int reach = this->L.Reach.x;
      const int from = std::clamp(reach, begin, end);
      const int to = std::clamp(this->L.Dimensions.x - reach, from, end);
      const auto useX = [&](const LineKernel& kernel, int i)
      {
        // As across rows: relative to the sample itself.
        const double* const samples = this->Read.data() + (i - this->L.ReadBegin);
        double smooth = 0.0;
        double first = 0.0;
        double second = 0.0;
        for (int offset = -reach; offset <= reach; ++offset)
        {
          if (kernel.smooth[offset + reach] != 0.0 || kernel.second[offset + reach] != 0.0 ||
            kernel.first[offset + reach] != 0.0)
          {
            const double d = samples[offset] - samples[0];
            smooth += kernel.smooth[offset + reach] * d;
            first += kernel.first[offset + reach] * d;
            second += kernel.second[offset + reach] * d;
          }
        }
        out[0].values[i - begin] = samples[0] + smooth;
        out[1].values[i - begin] = this->L.Factors.straight.x * second;
        out[2].values[i - begin] = first;
      };
      for (int i = begin; i < from; ++i)
      {
        useX(this->L.X[i], i);
      }
      this->insideX(from, to, out);
      for (int i = to; i < end; ++i)
      {
        useX(this->L.X[i], i);
      }
      if (odd)
      {
        this->repairX(out, useX);
      }
    }

    void insideX(int from, int to, Row (&out)[kinds])
    {
      const std::size_t count = static_cast<std::size_t>(to - from);
      if (count == 0)
      {
        return;
      }
      const LineKernel& kernel = this->L.X[from];
      const int reach = this->L.Reach.x;
      const double* const samples = this->Read.data() + (from - this->L.ReadBegin);
      const std::size_t at = static_cast<std::size_t>(from - this->L.Box.begin.x);
      double* const smooth = out[0].values + at;
      double* const second = out[1].values + at;
      double* const first = out[2].values + at;
      std::copy_n(samples, count, smooth);
      std::fill_n(second, count, 0.0);
      std::fill_n(first, count, 0.0);
      for (int offset = 1; offset <= reach; ++offset)
      {
        const double s = kernel.smooth[reach + offset];
        const double c = this->L.Factors.straight.x * kernel.second[reach + offset];
        const double f = kernel.first[reach + offset];
        const double* const before = samples - offset;
        const double* const after = samples + offset;
        for (std::size_t i = 0; i < count; ++i)
        {
          const double bend = (after[i] - samples[i]) + (before[i] - samples[i]);
          smooth[i] += s * bend;
          second[i] += c * bend;
        }
        if (this->L.Mixed)
        {
          for (std::size_t i = 0; i < count; ++i)
          {
            first[i] += f * (after[i] - before[i]);
          }
        }
      }
    }

    /// Fits what there is around missing samples. Where that is too little the result is missing.
    template <class UseX>
    void repairX(Row (&out)[kinds], const UseX& useX)
    {
      const int reach = this->L.Reach.x;
      const int begin = this->L.Box.begin.x;
      std::vector<std::uint8_t> used(2 * reach + 1);
      for (int i = begin; i < this->L.Box.end.x; ++i)
      {
        bool all = true;
        for (int offset = -reach; offset <= reach; ++offset)
        {
          const bool onGrid = i + offset >= 0 && i + offset < this->L.Dimensions.x;
          used[offset + reach] = onGrid && this->ReadMarks[i + offset - this->L.ReadBegin] != Missing;
          all = all && used[offset + reach] == onGrid;
        }
        out[0].missing[i - begin] = 0;
        if (all)
        {
          continue;
        }
        const LineKernel kernel(this->L.X.deviation(), used);
        out[0].missing[i - begin] = !kernel.exists;
        *out[0].marked = *out[0].marked || !kernel.exists;
        double& middle = this->Read[i - this->L.ReadBegin];
        const double kept = middle;
        if (kernel.exists && !used[reach])
        {
          // A missing sample is 0 in the row: differences from it would be coarse.
          const auto there = std::find(used.begin(), used.end(), 1) - used.begin();
          middle = this->Read[i - this->L.ReadBegin + there - reach];
        }
        useX(kernel, i);
        middle = kept;
      }
    }

    void passY(int j, int k)
    {
      const int reach = this->L.Reach.y;
      Line lines[kinds];
      for (int b = -reach; b <= reach; ++b)
      {
        const bool onGrid = j + b >= 0 && j + b < this->L.Dimensions.y;
        for (int kind = 0; kind < kinds; ++kind)
        {
          lines[kind].rows.push_back(
            onGrid ? this->AlongX.row(static_cast<std::size_t>(j + b - this->FirstRow), kind) : Row{});
        }
      }
      const std::size_t n = this->ringRow(j, k);
      Row out[kinds] = { this->AlongY.row(n, 0), this->AlongY.row(n, 1), this->AlongY.row(n, 2) };
      const LaplacianFactors& factors = this->L.Factors;
      const std::size_t count = this->L.Width;
      for (const Row& row : out)
      {
        std::fill_n(row.values, count, 0.0);
      }
      const LineKernel& kernel = this->L.Y[j];
      addAcross(lines[0], kernel, Derivative::None, 1.0, count, out[0].values);
      addAcross(lines[1], kernel, Derivative::None, 1.0, count, out[1].values);
      addAcross(lines[0], kernel, Derivative::Second, factors.straight.y, count, out[1].values);
      addAcross(lines[2], kernel, Derivative::First, factors.xy, count, out[1].values);
      addAcross(lines[2], kernel, Derivative::None, factors.xz, count, out[2].values);
      addAcross(lines[0], kernel, Derivative::First, factors.yz, count, out[2].values);
      *out[0].marked = false;
      this->repairAcross(lines[0], this->L.Y, out[0],
        [&](const LineKernel& part, std::size_t i)
        {
          out[0].values[i] = acrossAt(lines[0], part, Derivative::None, i);
          out[1].values[i] = acrossAt(lines[1], part, Derivative::None, i) +
            factors.straight.y * acrossAt(lines[0], part, Derivative::Second, i) +
            factors.xy * acrossAt(lines[2], part, Derivative::First, i);
          out[2].values[i] = factors.xz * acrossAt(lines[2], part, Derivative::None, i) +
            factors.yz * acrossAt(lines[0], part, Derivative::First, i);
        });
    }

    void passZ(int j, int k)
    {
      const int reach = this->L.Reach.z;
      Line lines[kinds];
      for (int c = -reach; c <= reach; ++c)
      {
        const bool onGrid = k + c >= 0 && k + c < this->L.Dimensions.z;
        for (int kind = 0; kind < kinds; ++kind)
        {
          lines[kind].rows.push_back(onGrid ? this->AlongY.row(this->ringRow(j, k + c), kind) : Row{});
        }
      }
      const std::size_t count = this->L.Width;
      const double factor = this->L.Factors.straight.z;
      const LineKernel& kernel = this->L.Z[k];
      std::vector<double> sum(count);
      addAcross(lines[1], kernel, Derivative::None, 1.0, count, sum.data());
      addAcross(lines[0], kernel, Derivative::Second, factor, count, sum.data());
      addAcross(lines[2], kernel, Derivative::First, this->L.Mixed ? 1.0 : 0.0, count, sum.data());
      bool marked = false;
      std::vector<std::uint8_t> missing(count);
      this->repairAcross(lines[0], this->L.Z, { sum.data(), missing.data(), &marked },
        [&](const LineKernel& part, std::size_t i)
        {
          sum[i] = acrossAt(lines[1], part, Derivative::None, i) +
            factor * acrossAt(lines[0], part, Derivative::Second, i) +
            acrossAt(lines[2], part, Derivative::First, i);
        });
      this->store(j, k, sum);
    }

    /// Calls fit(kernel, i) for the samples that some rows miss, with the kernel of the others.
    template <class Fit>
    void repairAcross(const Line& line, const LineKernels& kernels, const Row& out, const Fit& fit)
    {
      if (!line.anyMarked())
      {
        return;
      }
      std::vector<std::uint8_t> used(line.rows.size());
      for (std::size_t i = 0; i < this->L.Width; ++i)
      {
        bool all = true;
        for (std::size_t n = 0; n < line.rows.size(); ++n)
        {
          used[n] = !isMissing(line.rows[n], i);
          all = all && used[n] == (line.rows[n].values != nullptr);
        }
        out.missing[i] = 0;
        if (!all)
        {
          const LineKernel kernel(kernels.deviation(), used);
          out.missing[i] = !kernel.exists;
          *out.marked = *out.marked || !kernel.exists;
          fit(kernel, i);
        }
      }
    }

    void store(int j, int k, const std::vector<double>& sum)
    {
      const glm::ivec3 size = this->L.Box.size();
      const glm::ivec3 first = this->L.Box.begin;
      Real* const to = this->L.Result.data() +
        static_cast<std::size_t>(size.x) *
          ((j - first.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(k - first.z));
      constexpr double largest = static_cast<double>(std::numeric_limits<Real>::max());
      for (std::size_t i = 0; i < sum.size(); ++i)
      {
        const double value = std::is_same_v<T, double> ? sum[i] / doubleScale : sum[i];
        to[i] = std::isnan(value) ? Real(0) : static_cast<Real>(std::clamp(value, -largest, largest));
      }
      const bool mayMiss = std::is_floating_point_v<T> || !this->L.Field.hidden().empty();
      for (std::size_t i = 0; mayMiss && i < sum.size(); ++i)
      {
        if (!this->L.Field.has({ first.x + static_cast<int>(i), j, k }))
        {
          to[i] = Real(0);
        }
      }
    }

    std::size_t ringRow(int j, int k) const
    {
      return static_cast<std::size_t>(k % this->Ring) * this->TileHeight + (j - this->Tile.begin.y);
    }

    /// Keeps sums of the largest doubles doubles.
    static constexpr double doubleScale = 0x1p-60;

    const Laplacian& L;
    SampleBox Tile;
    int FirstRow;
    int LastRow;
    int Ring;
    int TileHeight;
    std::vector<double> Read;
    std::vector<std::uint8_t> ReadMarks;
    Rows AlongX;
    Rows AlongY;
  };

  const GridField<T>& Field;
  SampleBox Box;
  std::span<Real> Result;
  glm::ivec3 Dimensions;
  glm::ivec3 Reach;
  LaplacianFactors Factors;
  LineKernels X;
  LineKernels Y;
  LineKernels Z;
  int ReadBegin;
  std::size_t ReadSize;
  std::size_t Width;
  bool Mixed;
  int TileRows;
  int TileSlices;
};

} // namespace

glm::dvec3 gaussianInSamples(const GridGeometry& geometry, double scale, ScaleUnit unit)
{
  glm::dvec3 deviation(scale);
  for (int axis = 0; unit == ScaleUnit::World && axis < 3; ++axis)
  {
    const glm::dvec3& step = geometry.stepToWorld()[axis];
    deviation[axis] = scale / std::hypot(step.x, step.y, step.z);
  }
  return glm::clamp(deviation, 0.0, largestGaussian);
}

glm::ivec3 laplacianReach(const glm::dvec3& deviation)
{
  return { lineReach(deviation.x), lineReach(deviation.y), lineReach(deviation.z) };
}

template <class T, class Real>
bool laplacianOfGaussian(const GridField<T>& field, const SampleBox& box, const glm::dvec3& deviation,
  std::span<Real> laplacian, const Progress& progress)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(deviation[axis] >= 0.0 && deviation[axis] <= largestGaussian))
    {
      throw std::invalid_argument("a Gaussian's deviation must be from 0 to 16 samples");
    }
  }
  if (laplacian.size() != box.count())
  {
    throw std::invalid_argument("the array for the Laplacian has not the size of the box");
  }
  if (box.empty())
  {
    return true;
  }
  if (glm::any(glm::lessThan(box.begin, glm::ivec3(0))) ||
    glm::any(glm::greaterThan(box.end, field.geometry().dimensions())))
  {
    throw std::invalid_argument("a Laplacian is asked for outside the grid");
  }
  return Laplacian<T, Real>(field, box, deviation, laplacian).run(progress);
}

#define INK_INSTANTIATE(T)                                                                                   \
  template bool laplacianOfGaussian(                                                                         \
    const GridField<T>&, const SampleBox&, const glm::dvec3&, std::span<float>, const Progress&);            \
  template bool laplacianOfGaussian(                                                                         \
    const GridField<T>&, const SampleBox&, const glm::dvec3&, std::span<double>, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)

} // namespace ink
