#include "Sampling/IsoSurfaceSamples.h"

#include "Fields/Scalars.h"
#include "Sampling/CellStencils.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace ink
{
namespace
{

/// Values of the field minus the iso-value, in double, times a power of two that keeps sums and differences
/// of a few of them from overflowing. Their signs are exact, but for doubles that differ by less than any
/// normal one.
template <class T>
class RelativeValue
{
public:
  explicit RelativeValue(double isoValue)
  {
    if constexpr (Wide)
    {
      // The integer next below, so that the difference to it is exact.
      const double end = std::ldexp(1.0, std::numeric_limits<T>::digits);
      const double low = static_cast<double>(std::numeric_limits<T>::lowest());
      const double whole = std::clamp(std::floor(isoValue), low, std::nextafter(end, 0.0));
      this->Base = static_cast<T>(whole);
      this->Iso = isoValue - whole;
    }
    else
    {
      this->Iso = isoValue * Scale;
    }
  }

  double operator()(T value) const
  {
    if constexpr (Wide)
    {
      return difference(value, this->Base) - this->Iso;
    }
    else
    {
      return static_cast<double>(value) * Scale - this->Iso;
    }
  }

private:
  static constexpr bool Wide = std::is_integral_v<T> && sizeof(T) == 8;
  static constexpr double Scale = std::is_same_v<T, double> ? 0x1p-4 : 1.0;

  T Base = 0;
  double Iso = 0.0;
};

/// Places samples, a batch of cells at a time.
template <class T, class Real, CrossingRule rule>
class SamplePlacer
{
public:
  SamplePlacer(const GridField<T>& field, double isoValue, Real* points, float* normals)
    : Field(field)
    , Relative(isoValue)
    , Points(points)
    , Normals(normals)
  {
    const std::ptrdiff_t strideX = static_cast<std::ptrdiff_t>(field.stride());
    const std::ptrdiff_t strideY = strideX * field.geometry().dimensions().x;
    const std::ptrdiff_t strides[3] = { strideX, strideY, strideY * field.geometry().dimensions().y };
    for (int c = 0; c < Corners; ++c)
    {
      this->Offsets[c] = (c & 1) * strides[0] + (c >> 1 & 1) * strides[1] + (c >> 2) * strides[2];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int n = 0; n < 4; ++n)
      {
        const std::ptrdiff_t low = this->Offsets[lowCorner(axis, n)];
        this->Offsets[neighbourBefore(axis, n)] = low - strides[axis];
        this->Offsets[neighbourAfter(axis, n)] = low + 2 * strides[axis];
      }
    }
  }

  void add(const glm::ivec3& cell)
  {
    const glm::ivec3 last = this->Field.geometry().dimensions() - 2;
    const bool inside = cell.x > 0 && cell.y > 0 && cell.z > 0 && cell.x < last.x && cell.y < last.y &&
      cell.z < last.z && this->Field.hidden().empty();
    const T* corner = this->Field.data() + this->Field.geometry().offset(cell) * this->Field.stride();
    // The neighbours of a cell at the border may lie outside the grid: loadNeighboursThere sees to them.
    for (int n = 0; n < Corners; ++n)
    {
      this->Samples[n][this->Count] = corner[this->Offsets[n]];
    }
    if (inside)
    {
      for (int n = Corners; n < StencilSize; ++n)
      {
        this->Samples[n][this->Count] = corner[this->Offsets[n]];
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Cells[axis][this->Count] = cell[axis];
    }
    this->Inside[this->Count] = inside;
    if (++this->Count == Lanes)
    {
      this->flush();
    }
  }

  /// Writes the samples of the cells added since the last time.
  void flush()
  {
    for (int n = 0; n < StencilSize; ++n)
    {
      for (int i = 0; i < Lanes; ++i)
      {
        this->Stencil[n][i] = this->Relative(this->Samples[n][i]);
      }
    }
    findMeanCrossings<rule>(this->Stencil, this->Mean);
    this->writePoints();
    if (this->Normals)
    {
      this->writeNormals();
    }
    this->Count = 0;
  }

private:
  void writePoints()
  {
    // As GridGeometry::toWorld does it.
    Batch index[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int first = this->Field.geometry().first()[axis];
      for (int i = 0; i < Lanes; ++i)
      {
        index[axis][i] = (first + this->Cells[axis][i]) + this->Mean[axis][i];
      }
    }
    Batch steps[3];
    transform(this->Field.geometry().stepToWorld(), index, steps);
    const glm::dvec3& origin = this->Field.geometry().origin();
    for (int i = 0; i < this->Count; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        *this->Points++ = static_cast<Real>(origin[axis] + steps[axis][i]);
      }
    }
  }

  void writeNormals()
  {
    for (int i = 0; i < this->Count; ++i)
    {
      if (!this->Inside[i])
      {
        this->loadNeighboursThere(i);
      }
    }
    Batch directions[3];
    interpolateDirections(this->Stencil, this->Mean, this->Field.geometry().gradientDirection(), directions);
    Batch scale;
    for (int i = 0; i < Lanes; ++i)
    {
      const double square = directions[0][i] * directions[0][i] + directions[1][i] * directions[1][i] +
        directions[2][i] * directions[2][i];
      // False for NaN too, which a missing neighbour leads to.
      scale[i] = square > SmallestSquare ? -1.0 / std::sqrt(square) : 0.0;
    }
    for (int i = 0; i < this->Count; ++i)
    {
      const glm::dvec3 normal = scale[i] != 0.0
        ? scale[i] * glm::dvec3(directions[0][i], directions[1][i], directions[2][i])
        : this->carefulNormal(i);
      for (int axis = 0; axis < 3; ++axis)
      {
        *this->Normals++ = static_cast<float>(normal[axis]);
      }
    }
  }

  /// The normal where the corners' directions cancel, a gradient is out of bounds or a neighbour is missing.
  glm::dvec3 carefulNormal(int lane)
  {
    this->loadNeighboursThere(lane);
    this->normalizeStencil(lane);
    const glm::dmat3& toWorld = this->Field.geometry().gradientDirection();
    Batch directions[3];
    interpolateDirections(this->Stencil, this->Mean, toWorld, directions);
    const glm::dvec3 direction(directions[0][lane], directions[1][lane], directions[2][lane]);
    if (glm::dot(direction, direction) > SmallestSquare)
    {
      return -glm::normalize(direction);
    }
    const glm::dvec3 at(this->Mean[0][lane], this->Mean[1][lane], this->Mean[2][lane]);
    for (const glm::dvec3& gradient :
      { cellGradient(this->Stencil, lane, at), risingEdges<rule>(this->Stencil, lane) })
    {
      if (glm::dot(gradient, gradient) > SmallestSquare)
      {
        return -glm::normalize(toWorld * gradient);
      }
    }
    // Nothing tells one side from the other.
    return glm::normalize(toWorld[2]);
  }

  /// Makes the largest value of a stencil 1, so that no gradient's square overflows or vanishes.
  void normalizeStencil(int lane)
  {
    double largest = 0.0;
    for (const Batch& values : this->Stencil)
    {
      largest = std::max(largest, std::abs(values[lane]));
    }
    for (Batch& values : this->Stencil)
    {
      values[lane] /= largest > 0.0 ? largest : 1.0;
    }
  }

  /// A missing neighbour is extrapolated from the edge it continues, which makes the central difference there
  /// one-sided.
  void loadNeighboursThere(int lane)
  {
    const glm::ivec3 cell(this->Cells[0][lane], this->Cells[1][lane], this->Cells[2][lane]);
    const auto load = [&](int n, const glm::ivec3& sample, int near, int far)
    {
      this->Stencil[n][lane] = this->Field.has(sample)
        ? this->Relative(this->Field.at(sample))
        : 2.0 * this->Stencil[near][lane] - this->Stencil[far][lane];
    };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int n = 0; n < 4; ++n)
      {
        const int low = lowCorner(axis, n);
        const int high = highCorner(axis, n);
        glm::ivec3 sample = cell + glm::ivec3(low & 1, low >> 1 & 1, low >> 2);
        sample[axis] -= 1;
        load(neighbourBefore(axis, n), sample, low, high);
        sample[axis] += 3;
        load(neighbourAfter(axis, n), sample, high, low);
      }
    }
  }

  /// What is left of a sum of vectors of about unit length is rounding where its square is smaller.
  static constexpr double SmallestSquare = 1e-20;

  const GridField<T>& Field;
  RelativeValue<T> Relative;
  std::ptrdiff_t Offsets[StencilSize]; ///< from a cell's first corner
  Real* Points;
  float* Normals;

  int Count = 0;
  int Cells[3][Lanes] = {};
  bool Inside[Lanes];
  T Samples[StencilSize][Lanes] = {};
  Stencils Stencil;
  Batch Mean[3];
};

template <CrossingRule rule, class T, class Real>
bool placeAll(const GridField<T>& field, double isoValue, const CrossedCells& cells, std::span<Real> points,
  std::span<float> normals, const Progress& progress)
{
  const auto placeSlab = [&](std::size_t s)
  {
    const CrossedCells::Slab& slab = cells.slabs[s];
    SamplePlacer<T, Real, rule> placer(field, isoValue, points.data() + 3 * slab.before,
      normals.empty() ? nullptr : normals.data() + 3 * slab.before);
    for (const CellRun& run : slab.runs)
    {
      for (std::uint64_t rest = run.cells; rest != 0; rest &= rest - 1)
      {
        placer.add(run.first + glm::ivec3(std::countr_zero(rest), 0, 0));
      }
    }
    placer.flush();
  };
  return parallelFor(cells.slabs.size(), placeSlab, progress);
}

} // namespace

template <class T, class Real>
bool placeIsoSurfaceSamples(const GridField<T>& field, double isoValue, CrossingRule rule,
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
  return rule == CrossingRule::HalfOpen
    ? placeAll<CrossingRule::HalfOpen>(field, isoValue, cells, points, normals, progress)
    : placeAll<CrossingRule::Strict>(field, isoValue, cells, points, normals, progress);
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
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, CrossingRule, const CrossedCells&,       \
    std::span<float>, std::span<float>, const Progress&);                                                    \
  template bool placeIsoSurfaceSamples(const GridField<T>&, double, CrossingRule, const CrossedCells&,       \
    std::span<double>, std::span<float>, const Progress&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)

} // namespace ink
