// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/RobustPlacement.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink
{
namespace
{

constexpr int Across[3][2] = { { 1, 2 }, { 0, 2 }, { 0, 1 } };

/// The squared length below which a sum of roughly unit vectors is only rounding error.
constexpr double SmallestSquare = 1e-20;

/// Whether the surface intersects an edge with these values, relative to the iso-value, at its ends.
bool crosses(double a, double b, CrossingRule rule)
{
  return rule == CrossingRule::HalfOpen
    ? (a < 0.0) != (b < 0.0)
    : (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0) || (a == 0.0 && b == 0.0);
}

/// The corner's trilinear weight at t.
double shareOf(int corner, const glm::dvec3& t)
{
  return (corner & 1 ? t.x : 1.0 - t.x) * (corner & 2 ? t.y : 1.0 - t.y) * (corner & 4 ? t.z : 1.0 - t.z);
}

/// Twice the gradient at a corner, per sample step.
glm::dvec3 centralDifference(const CellStencil& cell, int corner)
{
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int n = (corner >> Across[axis][0] & 1) | (corner >> Across[axis][1] & 1) << 1;
    const bool upper = corner >> axis & 1;
    gradient[axis] = cell.values[upper ? neighborAfter(axis, n) : highCorner(axis, n)] -
      cell.values[upper ? lowCorner(axis, n) : neighborBefore(axis, n)];
  }
  return gradient;
}

/// The trilinear interpolation of the unit vectors along the corners' gradients, or of the gradients
/// themselves.
glm::dvec3 interpolateDirections(
  const CellStencil& cell, const glm::dvec3& at, NormalMethod method, const glm::dmat3& toWorld)
{
  glm::dvec3 sum(0.0);
  for (int c = 0; c < Corners; ++c)
  {
    const glm::dvec3 world = toWorld * centralDifference(cell, c);
    const double length = method == NormalMethod::InterpolatedGradient
      ? 1.0
      : std::sqrt(glm::dot(world, world) + std::numeric_limits<double>::min());
    sum += shareOf(c, at) / length * world;
  }
  return sum;
}

/// The gradient, per sample step, of the corners' trilinear interpolant.
glm::dvec3 cellGradient(const CellStencil& cell, const glm::dvec3& at)
{
  glm::dvec3 gradient(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int n = 0; n < 4; ++n)
    {
      const double p = at[Across[axis][0]];
      const double q = at[Across[axis][1]];
      gradient[axis] += (n & 1 ? p : 1.0 - p) * (n >> 1 ? q : 1.0 - q) *
        (cell.values[highCorner(axis, n)] - cell.values[lowCorner(axis, n)]);
    }
  }
  return gradient;
}

/// The number of rising minus the number of falling intersected edges, along each axis.
glm::dvec3 risingEdges(const CellStencil& cell, CrossingRule rule)
{
  glm::dvec3 sum(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int n = 0; n < 4; ++n)
    {
      const double low = cell.values[lowCorner(axis, n)];
      const double high = cell.values[highCorner(axis, n)];
      if (crosses(low, high, rule) && low != high)
      {
        sum[axis] += low < high ? 1.0 : -1.0;
      }
    }
  }
  return sum;
}

} // namespace

int lowCorner(int axis, int n)
{
  return (n & 1) << Across[axis][0] | (n >> 1) << Across[axis][1];
}

int highCorner(int axis, int n)
{
  return lowCorner(axis, n) | 1 << axis;
}

int neighborBefore(int axis, int n)
{
  return Corners + 4 * axis + n;
}

int neighborAfter(int axis, int n)
{
  return Corners + Edges + 4 * axis + n;
}

void CellStencil::extrapolateBefore(int axis, int n)
{
  this->values[neighborBefore(axis, n)] =
    2.0 * this->values[lowCorner(axis, n)] - this->values[highCorner(axis, n)];
}

void CellStencil::extrapolateAfter(int axis, int n)
{
  this->values[neighborAfter(axis, n)] =
    2.0 * this->values[highCorner(axis, n)] - this->values[lowCorner(axis, n)];
}

void CellStencil::normalize()
{
  double largest = 0.0;
  for (const double value : this->values)
  {
    largest = std::max(largest, std::abs(value));
  }
  for (double& value : this->values)
  {
    value /= largest > 0.0 ? largest : 1.0;
  }
}

glm::dvec3 meanCrossing(const CellStencil& cell, CrossingRule rule)
{
  glm::dvec3 sum(0.0);
  int count = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int n = 0; n < 4; ++n)
    {
      const double low = cell.values[lowCorner(axis, n)];
      const double high = cell.values[highCorner(axis, n)];
      if (crosses(low, high, rule))
      {
        sum[axis] += low == high ? 0.5 : std::abs(low) / (std::abs(low) + std::abs(high));
        sum[Across[axis][0]] += n & 1;
        sum[Across[axis][1]] += n >> 1;
        ++count;
      }
    }
  }
  // Values too close to distinguish an intersection in double: the cell's center.
  return count > 0 ? sum / static_cast<double>(count) : glm::dvec3(0.5);
}

glm::dvec3 robustNormal(const CellStencil& cell, const glm::dvec3& at, CrossingRule rule, NormalMethod method,
  const glm::dmat3& toWorld)
{
  if (method != NormalMethod::Cell)
  {
    const glm::dvec3 direction = interpolateDirections(cell, at, method, toWorld);
    if (glm::dot(direction, direction) > SmallestSquare)
    {
      return -glm::normalize(direction);
    }
  }
  for (const glm::dvec3& gradient : { cellGradient(cell, at), risingEdges(cell, rule) })
  {
    if (glm::dot(gradient, gradient) > SmallestSquare)
    {
      return -glm::normalize(toWorld * gradient);
    }
  }
  // The sides cannot be distinguished.
  return glm::normalize(toWorld[2]);
}

} // namespace ink
