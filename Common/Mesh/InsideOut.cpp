// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/InsideOut.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace ink
{

bool isInsideOut(const TriangleMesh& mesh)
{
  constexpr double largestHoles = 0.1;
  glm::dvec3 middle(0.0);
  double count = 0.0;
  for (const glm::dvec3& p : mesh.points)
  {
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
    {
      // A running mean, which does not overflow.
      count += 1.0;
      middle += (p - middle) / count;
    }
  }
  glm::dvec3 vector(0.0);
  double area = 0.0;
  double volume = 0.0;
  for (const auto& [i, j, k] : mesh.triangles)
  {
    const glm::dvec3 a = mesh.points[i] - middle;
    const glm::dvec3 b = mesh.points[j] - middle;
    const glm::dvec3 c = mesh.points[k] - middle;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double part = glm::dot(a, glm::cross(b, c));
    if (std::isfinite(part) && std::isfinite(glm::dot(normal, normal)))
    {
      vector += normal;
      area += glm::length(normal);
      volume += part;
    }
  }
  return volume < 0.0 && glm::length(vector) < largestHoles * area;
}

} // namespace ink
