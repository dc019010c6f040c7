#include "Sampling/IsoSurfaceSamples.h"

#include "Fields/Scalars.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
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

/// How many cells are worked on at once: the compiler turns a loop over them into vector instructions.
constexpr int Lanes = 16;

/// The two axes across a given one.
constexpr int Across[3][2] = { { 1, 2 }, { 0, 2 }, { 0, 1 } };

/// The samples that a cell's sample depends on: its 8 corners, corner c being on the upper side along axis a
/// where bit a of c is set, and the two outer neighbours of each of its 12 edges, along that edge. Edge e = 4
/// * axis + n runs along `axis`, on the upper side of the first axis across where bit 0 of n is set, and of
/// the second where bit 1 is.
constexpr int Corners = 8;
constexpr int Edges = 12;
constexpr int StencilSize = Corners + 2 * Edges;

constexpr int lowCorner(int axis, int n)
{
  return (n & 1) << Across[axis][0] | (n >> 1) << Across[axis][1];
}
constexpr int highCorner(int axis, int n)
{
  return lowCorner(axis, n) | 1 << axis;
}
constexpr int neighbourBefore(int axis, int n)
{
  return Corners + 4 * axis + n;
}
constexpr int neighbourAfter(int axis, int n)
{
  return Corners + Edges + 4 * axis + n;
}

/// The edge along an axis that a corner belongs to.
constexpr int edgeAt(int axis, int corner)
{
  return (corner >> Across[axis][0] & 1) | (corner >> Across[axis][1] & 1) << 1;
}

/// One number for each of the cells worked on.
using Batch = double[Lanes];

/// The stencils of the cells, relative to the iso-value.
using Stencils = Batch[StencilSize];

/// 1 where a value counts as being on the given side, 0 elsewhere.
double below(double value)
{
  return value < 0.0 ? 1.0 : 0.0;
}
double above(double value)
{
  return value > 0.0 ? 1.0 : 0.0;
}

/// 1 where the surface intersects an edge with the values a and b at its ends, 0 elsewhere. Arithmetic
/// instead of conditions, which compilers turn into vector instructions.
template <CrossingRule rule>
double crosses(double a, double b)
{
  if constexpr (rule == CrossingRule::HalfOpen)
  {
    return std::abs(below(a) - below(b));
  }
  else
  {
    const double bothOn = (1.0 - below(a) - above(a)) * (1.0 - below(b) - above(b));
    return below(a) * above(b) + above(a) * below(b) + bothOn;
  }
}

/// The mean of the intersections with each cell's edges, in the unit cell.
template <CrossingRule rule>
void findMeanCrossings(const Stencils& cells, Batch (&mean)[3])
{
  // Distances from the iso-value. Too small to be seen beside any other, `nothing` makes the share of two
  // equal ends 1/2, without a case of its own.
  constexpr double nothing = std::numeric_limits<double>::min();
  Batch distance[Corners];
  for (int c = 0; c < Corners; ++c)
  {
    for (int i = 0; i < Lanes; ++i)
    {
      distance[c][i] = std::abs(cells[c][i]) + nothing;
    }
  }
  Batch sum[3] = {};
  Batch count = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    Batch crossed[4];
    Batch along[4];
    for (int n = 0; n < 4; ++n)
    {
      const int low = lowCorner(axis, n);
      const int high = highCorner(axis, n);
      for (int i = 0; i < Lanes; ++i)
      {
        crossed[n][i] = crosses<rule>(cells[low][i], cells[high][i]);
        along[n][i] = crossed[n][i] * (distance[low][i] / (distance[low][i] + distance[high][i]));
      }
    }
    Batch& first = sum[Across[axis][0]];
    Batch& second = sum[Across[axis][1]];
    for (int i = 0; i < Lanes; ++i)
    {
      sum[axis][i] += (along[0][i] + along[1][i]) + (along[2][i] + along[3][i]);
    }
    for (int i = 0; i < Lanes; ++i)
    {
      first[i] += crossed[1][i] + crossed[3][i];
    }
    for (int i = 0; i < Lanes; ++i)
    {
      second[i] += crossed[2][i] + crossed[3][i];
    }
    for (int i = 0; i < Lanes; ++i)
    {
      count[i] += (crossed[0][i] + crossed[1][i]) + (crossed[2][i] + crossed[3][i]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Lanes; ++i)
    {
      // Doubles too close for a crossing to be told from none: the cell's middle.
      const double none = count[i] == 0.0 ? 1.0 : 0.0;
      mean[axis][i] = (sum[axis][i] + 0.5 * none) / (count[i] + none);
    }
  }
}

/// matrix * (x, y, z) for each cell.
void transform(const glm::dmat3& matrix, const Batch (&from)[3], Batch (&to)[3])
{
  for (int row = 0; row < 3; ++row)
  {
    const double mx = matrix[0][row];
    const double my = matrix[1][row];
    const double mz = matrix[2][row];
    for (int i = 0; i < Lanes; ++i)
    {
      to[row][i] = mx * from[0][i] + my * from[1][i] + mz * from[2][i];
    }
  }
}

/// The trilinear interpolation, at the point `at` of each unit cell, of the unit vectors along the corners'
/// central-difference gradients. `toWorld` takes gradients per sample step to their direction in the world. A
/// corner with no gradient adds nothing.
void interpolateDirections(
  const Stencils& cells, const Batch (&at)[3], const glm::dmat3& toWorld, Batch (&directions)[3])
{
  for (Batch& component : directions)
  {
    std::fill_n(component, Lanes, 0.0);
  }
  for (int c = 0; c < Corners; ++c)
  {
    // Twice the gradient.
    Batch gradient[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int n = edgeAt(axis, c);
      const bool upper = c >> axis & 1;
      const Batch& next = cells[upper ? neighbourAfter(axis, n) : highCorner(axis, n)];
      const Batch& previous = cells[upper ? lowCorner(axis, n) : neighbourBefore(axis, n)];
      for (int i = 0; i < Lanes; ++i)
      {
        gradient[axis][i] = next[i] - previous[i];
      }
    }
    Batch world[3];
    transform(toWorld, gradient, world);
    // The corner's weight is that of t or 1 - t along each axis.
    const double x0 = c & 1 ? 0.0 : 1.0;
    const double y0 = c & 2 ? 0.0 : 1.0;
    const double z0 = c & 4 ? 0.0 : 1.0;
    Batch weight;
    for (int i = 0; i < Lanes; ++i)
    {
      const double square = world[0][i] * world[0][i] + world[1][i] * world[1][i] + world[2][i] * world[2][i];
      const double share = std::abs(x0 - at[0][i]) * std::abs(y0 - at[1][i]) * std::abs(z0 - at[2][i]);
      weight[i] = share / std::sqrt(square + std::numeric_limits<double>::min());
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < Lanes; ++i)
      {
        directions[axis][i] += weight[i] * world[axis][i];
      }
    }
  }
}

/// The gradient, per sample step, of the trilinear interpolation of one cell's corners, at the point `at` of
/// the unit cell.
glm::dvec3 cellGradient(const Stencils& cells, int lane, const glm::dvec3& at)
{
  glm::dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int n = 0; n < 4; ++n)
    {
      const double p = at[Across[axis][0]];
      const double q = at[Across[axis][1]];
      gradient[axis] += (n & 1 ? p : 1.0 - p) * (n >> 1 ? q : 1.0 - q) *
        (cells[highCorner(axis, n)][lane] - cells[lowCorner(axis, n)][lane]);
    }
  }
  return gradient;
}

/// How many more of one cell's crossed edges rise than fall, along each axis.
template <CrossingRule rule>
glm::dvec3 risingEdges(const Stencils& cells, int lane)
{
  glm::dvec3 sum(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int n = 0; n < 4; ++n)
    {
      const double low = cells[lowCorner(axis, n)][lane];
      const double high = cells[highCorner(axis, n)][lane];
      if (crosses<rule>(low, high) != 0.0 && low != high)
      {
        sum[axis] += low < high ? 1.0 : -1.0;
      }
    }
  }
  return sum;
}

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
    const glm::dvec3 at(this->Mean[0][lane], this->Mean[1][lane], this->Mean[2][lane]);
    for (const glm::dvec3& candidate : { direction, toWorld * cellGradient(this->Stencil, lane, at),
           toWorld * risingEdges<rule>(this->Stencil, lane) })
    {
      const double square = glm::dot(candidate, candidate);
      if (square > SmallestSquare)
      {
        return candidate / -std::sqrt(square);
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

  /// A sum of unit vectors whose square is smaller is rounding.
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
