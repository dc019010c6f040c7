// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"
#include "Curves/Polylines.h"
#include "Curves/Streamlines/StreamlineTracer.h"
#include "Mesh/MeshNavigation.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Lines on a surface, in the order of their priority.
template <class Point>
struct StreamlinesOn
{
  Polylines lines;
  /// In [0, 1), ascending, one per line: the share of the length of all lines that lies before it. So the
  /// lines of less than p have about the share p of all ink.
  std::vector<float> priorities;
  std::vector<Point> points;         ///< one per point, as all that follow
  std::vector<glm::dvec3> positions; ///< of the points
  std::vector<double> arcLength;     ///< from the line's first point, in world units
};

using Streamlines = StreamlinesOn<MeshPoint>;

/// Puts traced lines together in the order of `order`.
template <class Point>
StreamlinesOn<Point> joinLines(
  std::span<const TracedLineOn<Point>> lines, std::span<const std::uint32_t> order);

/// The unit normals at points of a mesh: those of its points, interpolated, or where there are none or they
/// cancel out, of its triangles.
/// @param normals of unit length, one per point of the mesh, or empty
std::vector<glm::vec3> normalsAt(
  const MeshNavigation& mesh, std::span<const glm::vec3> normals, std::span<const MeshPoint> points);

/// One such normal.
glm::vec3 normalAt(const MeshNavigation& mesh, std::span<const glm::vec3> normals, const MeshPoint& point);

template <class Point>
StreamlinesOn<Point> joinLines(
  std::span<const TracedLineOn<Point>> lines, std::span<const std::uint32_t> order)
{
  StreamlinesOn<Point> result;
  const auto lengthOf = [](const TracedLineOn<Point>& line)
  {
    const double open = line.points.empty() ? 0.0 : line.points.back().arc - line.points.front().arc;
    return line.closed ? open + glm::distance(line.points.back().position, line.points.front().position)
                       : open;
  };
  double whole = 0.0;
  for (const std::uint32_t n : order)
  {
    whole += lengthOf(lines[n]);
  }
  double before = 0.0;
  for (const std::uint32_t n : order)
  {
    result.lines.offsets.push_back(result.lines.pointCount() + lines[n].points.size());
    result.lines.closed.push_back(lines[n].closed ? 1 : 0);
    result.priorities.push_back(std::min(static_cast<float>(before / whole), std::nextafter(1.0f, 0.0f)));
    before += lengthOf(lines[n]);
  }
  result.points.resize(result.lines.pointCount());
  result.positions.resize(result.lines.pointCount());
  result.arcLength.resize(result.lines.pointCount());
  parallelFor(order.size(),
    [&](std::size_t i)
    {
      const std::vector<TracedPointOn<Point>>& points = lines[order[i]].points;
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        const std::size_t index = result.lines.offsets[i] + k;
        result.points[index] = points[k].at;
        result.positions[index] = points[k].position;
        result.arcLength[index] = points[k].arc - points.front().arc;
      }
    });
  return result;
}

} // namespace ink
