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

/// A cell's corners, at [1..2][1..2][1..2] as [z][y][x], and their neighbours along the axes.
struct Neighbourhood
{
  double v[4][4][4];
};

template <CrossingRule rule>
bool crosses(double a, double b)
{
  if constexpr (rule == CrossingRule::HalfOpen)
  {
    return (a < 0.0) != (b < 0.0);
  }
  else
  {
    return (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) || (a == 0.0 && b == 0.0);
  }
}

/// Calls visit(axis, low corner, value there, value at the other end) for the cell's twelve edges.
template <class Visit>
void forEachEdge(const Neighbourhood& near, const Visit& visit)
{
  for (int q = 0; q < 2; ++q)
  {
    for (int p = 0; p < 2; ++p)
    {
      visit(0, glm::ivec3(0, p, q), near.v[1 + q][1 + p][1], near.v[1 + q][1 + p][2]);
      visit(1, glm::ivec3(p, 0, q), near.v[1 + q][1][1 + p], near.v[1 + q][2][1 + p]);
      visit(2, glm::ivec3(p, q, 0), near.v[1][1 + q][1 + p], near.v[2][1 + q][1 + p]);
    }
  }
}

/// The mean of the intersections with the cell's edges, in the unit cell.
template <CrossingRule rule>
glm::dvec3 meanCrossing(const Neighbourhood& near)
{
  glm::dvec3 sum(0.0);
  double count = 0.0;
  forEachEdge(near,
    [&](int axis, const glm::ivec3& corner, double a, double b)
    {
      const bool crossed = crosses<rule>(a, b);
      const double alpha = a != b ? a / (a - b) : 0.5;
      glm::dvec3 position(corner);
      position[axis] = alpha;
      sum += crossed ? position : glm::dvec3(0.0);
      count += crossed ? 1.0 : 0.0;
    });
  // Doubles too close for a crossing to be told from none: the cell's middle.
  return count > 0.0 ? sum / count : glm::dvec3(0.5);
}

/// The trilinear interpolation, at the point t of the unit cell, of the corners' central differences, per
/// sample step and times two.
glm::dvec3 centralGradient(const Neighbourhood& near, const glm::dvec3& t)
{
  const double wx[2] = { 1.0 - t.x, t.x };
  const double wy[2] = { 1.0 - t.y, t.y };
  const double wz[2] = { 1.0 - t.z, t.z };
  // The samples along each axis, interpolated across it.
  double x[4] = {};
  double y[4] = {};
  double z[4] = {};
  for (int q = 0; q < 2; ++q)
  {
    for (int p = 0; p < 2; ++p)
    {
      for (int n = 0; n < 4; ++n)
      {
        x[n] += wy[p] * wz[q] * near.v[1 + q][1 + p][n];
        y[n] += wx[p] * wz[q] * near.v[1 + q][n][1 + p];
        z[n] += wx[p] * wy[q] * near.v[n][1 + q][1 + p];
      }
    }
  }
  return { wx[0] * (x[2] - x[0]) + wx[1] * (x[3] - x[1]), wy[0] * (y[2] - y[0]) + wy[1] * (y[3] - y[1]),
    wz[0] * (z[2] - z[0]) + wz[1] * (z[3] - z[1]) };
}

/// The gradient, per sample step, of the trilinear interpolation of the cell's corners.
glm::dvec3 cellGradient(const Neighbourhood& near, const glm::dvec3& t)
{
  glm::dvec3 gradient(0.0);
  forEachEdge(near,
    [&](int axis, const glm::ivec3& corner, double a, double b)
    {
      double weight = 1.0;
      for (int across = 0; across < 3; ++across)
      {
        weight *= across == axis ? 1.0 : corner[across] ? t[across] : 1.0 - t[across];
      }
      gradient[axis] += weight * (b - a);
    });
  return gradient;
}

/// How many more of the crossed edges along each axis rise than fall.
template <CrossingRule rule>
glm::dvec3 risingEdges(const Neighbourhood& near)
{
  glm::dvec3 sum(0.0);
  forEachEdge(near,
    [&](int axis, const glm::ivec3&, double a, double b) {
      sum[axis] += !crosses<rule>(a, b) || a == b ? 0.0 : a < b ? 1.0 : -1.0;
    });
  return sum;
}

/// The unit vector along v, or zero where v has no direction.
glm::dvec3 unit(const glm::dvec3& v)
{
  const double size = std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
  return size > 0.0 && std::isfinite(size) && v == v ? glm::normalize(v / size) : glm::dvec3(0.0);
}

template <class T>
class SamplePlacer
{
public:
  SamplePlacer(const GridField<T>& field, double isoValue)
    : Field(field)
    , Relative(isoValue)
    , Last(field.geometry().dimensions() - 2)
    , StrideX(field.stride())
    , StrideY(this->StrideX * field.geometry().dimensions().x)
    , StrideZ(this->StrideY * field.geometry().dimensions().y)
  {
  }

  template <CrossingRule rule, class Real>
  void place(const glm::ivec3& cell, Real* point, float* normal) const
  {
    const T* corner = this->Field.data() + this->Field.geometry().offset(cell) * this->StrideX;
    Neighbourhood near;
    this->loadCorners(corner, near);
    const glm::dvec3 t = meanCrossing<rule>(near);
    const glm::dvec3 world = this->Field.geometry().toWorld(glm::dvec3(cell) + t);
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = static_cast<Real>(world[axis]);
    }
    if (normal)
    {
      const glm::dvec3 n = this->normal<rule>(cell, corner, near, t);
      for (int axis = 0; axis < 3; ++axis)
      {
        normal[axis] = static_cast<float>(n[axis]);
      }
    }
  }

private:
  void loadCorners(const T* corner, Neighbourhood& near) const
  {
    for (int z = 1; z < 3; ++z)
    {
      for (int y = 1; y < 3; ++y)
      {
        for (int x = 1; x < 3; ++x)
        {
          near.v[z][y][x] = this->Relative(
            corner[(x - 1) * this->StrideX + (y - 1) * this->StrideY + (z - 1) * this->StrideZ]);
        }
      }
    }
  }

  template <CrossingRule rule>
  glm::dvec3 normal(const glm::ivec3& cell, const T* corner, Neighbourhood& near, const glm::dvec3& t) const
  {
    const glm::dmat3& toWorld = this->Field.geometry().gradientDirection();
    const bool inside = cell.x > 0 && cell.y > 0 && cell.z > 0 && cell.x < this->Last.x &&
      cell.y < this->Last.y && cell.z < this->Last.z;
    if (inside && this->Field.hidden().empty())
    {
      this->loadNeighbours(corner, near);
      const glm::dvec3 gradient = toWorld * centralGradient(near, t);
      const double square = glm::dot(gradient, gradient);
      // Fails for NaN too, which a missing neighbour leads to.
      if (square > SmallestSquare && square < LargestSquare)
      {
        return gradient * (-1.0 / std::sqrt(square));
      }
    }
    this->loadNeighboursThere(cell, near);
    const std::array candidates = { toWorld * centralGradient(near, t), toWorld * cellGradient(near, t),
      toWorld * risingEdges<rule>(near) };
    for (const glm::dvec3& gradient : candidates)
    {
      const glm::dvec3 direction = unit(gradient);
      if (direction != glm::dvec3(0.0))
      {
        return -direction;
      }
    }
    // Nothing tells one side from the other.
    return unit(toWorld[2]);
  }

  /// For a cell all of whose neighbours are on the grid.
  void loadNeighbours(const T* corner, Neighbourhood& near) const
  {
    for (int q = 0; q < 2; ++q)
    {
      for (int p = 0; p < 2; ++p)
      {
        const T* alongX = corner + p * this->StrideY + q * this->StrideZ;
        const T* alongY = corner + p * this->StrideX + q * this->StrideZ;
        const T* alongZ = corner + p * this->StrideX + q * this->StrideY;
        near.v[1 + q][1 + p][0] = this->Relative(*(alongX - this->StrideX));
        near.v[1 + q][1 + p][3] = this->Relative(alongX[2 * this->StrideX]);
        near.v[1 + q][0][1 + p] = this->Relative(*(alongY - this->StrideY));
        near.v[1 + q][3][1 + p] = this->Relative(alongY[2 * this->StrideY]);
        near.v[0][1 + q][1 + p] = this->Relative(*(alongZ - this->StrideZ));
        near.v[3][1 + q][1 + p] = this->Relative(alongZ[2 * this->StrideZ]);
      }
    }
  }

  /// For any cell. A missing neighbour is extrapolated from the edge it continues, which makes the central
  /// difference there one-sided.
  void loadNeighboursThere(const glm::ivec3& cell, Neighbourhood& near) const
  {
    const auto load = [&](int x, int y, int z, double corner, double opposite)
    {
      const glm::ivec3 sample = cell + glm::ivec3(x, y, z) - 1;
      near.v[z][y][x] =
        this->Field.has(sample) ? this->Relative(this->Field.at(sample)) : 2.0 * corner - opposite;
    };
    for (int q = 1; q < 3; ++q)
    {
      for (int p = 1; p < 3; ++p)
      {
        load(0, p, q, near.v[q][p][1], near.v[q][p][2]);
        load(3, p, q, near.v[q][p][2], near.v[q][p][1]);
        load(p, 0, q, near.v[q][1][p], near.v[q][2][p]);
        load(p, 3, q, near.v[q][2][p], near.v[q][1][p]);
        load(p, q, 0, near.v[1][q][p], near.v[2][q][p]);
        load(p, q, 3, near.v[2][q][p], near.v[1][q][p]);
      }
    }
  }

  static constexpr double SmallestSquare = 1e-200;
  static constexpr double LargestSquare = 1e200;

  const GridField<T>& Field;
  RelativeValue<T> Relative;
  glm::ivec3 Last;
  std::ptrdiff_t StrideX;
  std::ptrdiff_t StrideY;
  std::ptrdiff_t StrideZ;
};

template <CrossingRule rule, class T, class Real>
bool placeAll(const GridField<T>& field, double isoValue, const CrossedCells& cells, std::span<Real> points,
  std::span<float> normals, const Progress& progress)
{
  const SamplePlacer<T> placer(field, isoValue);
  const auto placeSlab = [&](std::size_t s)
  {
    const CrossedCells::Slab& slab = cells.slabs[s];
    Real* point = points.data() + 3 * slab.before;
    float* normal = normals.empty() ? nullptr : normals.data() + 3 * slab.before;
    for (const CellRun& run : slab.runs)
    {
      for (std::uint64_t rest = run.cells; rest != 0; rest &= rest - 1)
      {
        const glm::ivec3 cell = run.first + glm::ivec3(std::countr_zero(rest), 0, 0);
        placer.template place<rule>(cell, point, normal);
        point += 3;
        normal += normal ? 3 : 0;
      }
    }
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
