// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/InsideOut.h"

#include "Mesh/OnePerPoint.h"
#include "Mesh/SignedVolume.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace ink
{
namespace
{

glm::dvec3 middleOf(std::span<const glm::dvec3> points)
{
  glm::dvec3 middle(0.0);
  double count = 0.0;
  for (const glm::dvec3& p : points)
  {
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
    {
      // A running mean, which does not overflow.
      count += 1.0;
      middle += (p - middle) / count;
    }
  }
  return middle;
}

} // namespace

bool isInsideOut(const TriangleMesh& mesh)
{
  constexpr double largestHoles = 0.1;
  const glm::dvec3 middle = middleOf(mesh.points);
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

bool facesInward(const TriangleMesh& mesh, std::span<const glm::vec3> normals)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  const glm::dvec3 middle = middleOf(mesh.points);
  double volume = 0.0;
  for (const auto& [i, j, k] : mesh.triangles)
  {
    const double part = signedVolume(mesh.points[i] - middle, mesh.points[j] - middle,
      mesh.points[k] - middle, glm::dvec3(normals[i] + normals[j] + normals[k]));
    volume += std::isfinite(part) ? part : 0.0;
  }
  return volume < 0.0;
}

} // namespace ink
