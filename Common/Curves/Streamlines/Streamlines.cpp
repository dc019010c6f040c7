// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/Streamlines.h"

#include "Core/ParallelChunks.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace ink
{

namespace
{

} // namespace

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
  parallelForEach(points.size(), [&](std::size_t i) { result[i] = normalAt(mesh, normals, points[i]); });
  return result;
}

} // namespace ink
