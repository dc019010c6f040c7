// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StreamlineShapes.h"

#include "Curves/Streamlines/Streamlines.h"
#include "PointSampling/WhiteNoise.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ink::test
{

inline double squaredDistance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 along = b - a;
  const double size = glm::dot(along, along);
  const double share = size > 0.0 ? std::clamp(glm::dot(p - a, along) / size, 0.0, 1.0) : 0.0;
  const glm::dvec3 offset = p - a - share * along;
  return glm::dot(offset, offset);
}

/// Slow and obvious: the distance of a position to the nearest of the first lines, but for one.
template <class Lines>
double nearest(const Lines& lines, std::size_t count, const glm::dvec3& p, std::size_t other)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t end = lines.lines.offsets[n + 1];
    for (std::size_t i = lines.lines.offsets[n]; n != other && i + 1 < end; ++i)
    {
      least = std::min(least, squaredDistance(p, lines.positions[i], lines.positions[i + 1]));
    }
  }
  return std::sqrt(least);
}

template <class Lines>
double lengthOf(const Lines& lines, std::size_t count)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < count; ++n)
  {
    sum += lines.arcLength[lines.lines.offsets[n + 1] - 1];
  }
  return sum;
}

/// How even the first lines are: the largest and the mean distance of the surface from them, as a share of
/// the distance at which parallel lines of their length would be, and the least between two of them.
struct Evenness
{
  double spacing; ///< area over length
  double farthest;
  double mean;
  double closest;
};

template <class Lines>
Evenness evenness(const Shape& shape, const Lines& lines, std::size_t count)
{
  const TriangleMesh mesh = shape.mesh.view();
  const CumulativeArea areas = cumulateArea(mesh);
  Evenness result{ areas.area.back() / lengthOf(lines, count), 0.0, 0.0, 1e300 };
  const std::vector<glm::dvec3> positions = positionsOf(mesh, sampleWhiteNoise(mesh, areas, 300, 7));
  for (const glm::dvec3& position : positions)
  {
    const double distance = nearest(lines, count, position, ~std::size_t(0)) / result.spacing;
    result.farthest = std::max(result.farthest, distance);
    result.mean += distance / static_cast<double>(positions.size());
  }
  for (std::size_t n = 0; n < count; ++n)
  {
    for (std::size_t i = lines.lines.offsets[n]; i < lines.lines.offsets[n + 1]; i += 10)
    {
      result.closest = std::min(result.closest, nearest(lines, count, lines.positions[i], n));
    }
  }
  return result;
}

template <class Lines>
bool areSame(const Lines& a, const Lines& b)
{
  return a.positions == b.positions && a.lines.offsets == b.lines.offsets &&
    a.lines.closed == b.lines.closed && a.priorities == b.priorities && a.arcLength == b.arcLength;
}

} // namespace ink::test
