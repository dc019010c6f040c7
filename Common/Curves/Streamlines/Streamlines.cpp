// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/Streamlines.h"

#include "Core/ParallelFor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

constexpr std::size_t blockSize = 1 << 12;

} // namespace

Streamlines joinLines(std::span<const TracedLine> lines, std::span<const std::uint32_t> order)
{
  Streamlines result;
  const auto lengthOf = [](const TracedLine& line)
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
      const std::vector<TracedPoint>& points = lines[order[i]].points;
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

glm::vec3 normalAt(const MeshNavigation& mesh, std::span<const glm::vec3> normals, const MeshPoint& point)
{
  glm::dvec3 normal(0.0);
  if (!normals.empty())
  {
    const auto& [a, b, c] = mesh.mesh().triangles[point.triangle];
    normal = point.weights.x * glm::dvec3(normals[a]) + point.weights.y * glm::dvec3(normals[b]) +
      point.weights.z * glm::dvec3(normals[c]);
  }
  const double length = glm::length(normal);
  // Unit normals of opposite sides cancel out up to rounding. False for NaN.
  return length > 1e-3 ? glm::vec3(normal / length) : glm::vec3(mesh.chart(point.triangle).normal());
}

std::vector<glm::vec3> normalsAt(
  const MeshNavigation& mesh, std::span<const glm::vec3> normals, std::span<const MeshPoint> points)
{
  std::vector<glm::vec3> result(points.size());
  parallelFor((points.size() + blockSize - 1) / blockSize,
    [&](std::size_t block)
    {
      for (std::size_t i = block * blockSize; i < std::min((block + 1) * blockSize, points.size()); ++i)
      {
        result[i] = normalAt(mesh, normals, points[i]);
      }
    });
  return result;
}

} // namespace ink
