#include "Sampling/CellStencils.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink
{
namespace
{

// Arithmetic in place of conditions, which compilers turn into vector instructions.

/// The side of the surface that a value is on: for CrossingRule::HalfOpen -1 below the iso-value and 0 at or
/// above it, for CrossingRule::Strict -1, 0 at it, 1.
template <CrossingRule rule>
double sideOf(double value)
{
  const double below = value < 0.0 ? 1.0 : 0.0;
  const double above = value > 0.0 ? 1.0 : 0.0;
  return rule == CrossingRule::HalfOpen ? -below : above - below;
}

/// 1 where the surface intersects an edge with its ends on the given sides, 0 elsewhere.
template <CrossingRule rule>
double crosses(double a, double b)
{
  if constexpr (rule == CrossingRule::HalfOpen)
  {
    return std::abs(a - b);
  }
  else
  {
    const double opposite = 0.5 * a * b * (a * b - 1.0);
    const double bothAt = (1.0 - a * a) * (1.0 - b * b);
    return opposite + bothAt;
  }
}

} // namespace

template <CrossingRule rule>
void findMeanCrossings(const Stencils& cells, Batch (&mean)[3])
{
  // Distances from the iso-value. Too small to be seen beside any other, `nothing` makes the share of two
  // equal ends 1/2, without a case of its own.
  constexpr double nothing = std::numeric_limits<double>::min();
  Batch distance[Corners];
  Batch side[Corners];
  for (int c = 0; c < Corners; ++c)
  {
    for (int i = 0; i < Lanes; ++i)
    {
      distance[c][i] = std::abs(cells[c][i]) + nothing;
      side[c][i] = sideOf<rule>(cells[c][i]);
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
        crossed[n][i] = crosses<rule>(side[low][i], side[high][i]);
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
      if (crosses<rule>(sideOf<rule>(low), sideOf<rule>(high)) != 0.0 && low != high)
      {
        sum[axis] += low < high ? 1.0 : -1.0;
      }
    }
  }
  return sum;
}

#define INK_INSTANTIATE(rule)                                                                                \
  template void findMeanCrossings<rule>(const Stencils&, Batch(&)[3]);                                       \
  template glm::dvec3 risingEdges<rule>(const Stencils&, int);
INK_INSTANTIATE(CrossingRule::HalfOpen)
INK_INSTANTIATE(CrossingRule::Strict)

} // namespace ink
