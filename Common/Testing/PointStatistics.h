// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

namespace ink::testing
{

/// The mean distance to the nearest other point, in units of what it would be if the points were thrown on
/// the surface independently, 1 / (2 sqrt(density)): 1 for white noise, 2.15 for a hexagonal lattice.
/// @param measured how many of the points count, the first ones; the others are only neighbors
inline double meanNearestDistance(const std::vector<glm::dvec3>& points, double density, std::size_t measured)
{
  const double cell = 2.0 / std::sqrt(density);
  const auto cellOf = [cell](const glm::dvec3& p)
  { return std::tuple(std::floor(p.x / cell), std::floor(p.y / cell), std::floor(p.z / cell)); };
  std::map<std::tuple<double, double, double>, std::vector<std::size_t>> cells;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    cells[cellOf(points[n])].push_back(n);
  }
  double sum = 0.0;
  for (std::size_t n = 0; n < measured; ++n)
  {
    const auto [x, y, z] = cellOf(points[n]);
    double nearest = std::numeric_limits<double>::infinity();
    for (int offset = 0; offset < 27; ++offset)
    {
      const auto found = cells.find({ x + offset % 3 - 1, y + offset / 3 % 3 - 1, z + offset / 9 - 1 });
      if (found != cells.end())
      {
        for (const std::size_t other : found->second)
        {
          nearest = other == n ? nearest : std::min(nearest, glm::distance(points[n], points[other]));
        }
      }
    }
    sum += std::min(nearest, cell);
  }
  return sum / static_cast<double>(measured) * 2.0 * std::sqrt(density);
}

/// The power of a pattern at a frequency: 1 on average for white noise, the number of points for a grid of
/// that frequency.
inline double powerAt(const std::vector<glm::dvec2>& points, const glm::dvec2& frequency)
{
  std::complex<double> sum = 0.0;
  for (const glm::dvec2& point : points)
  {
    sum += std::polar(1.0, -2.0 * std::numbers::pi * glm::dot(frequency, point));
  }
  return std::norm(sum) / static_cast<double>(points.size());
}

} // namespace ink::testing
