// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/WeldedTriangles.h"

#include "Core/IsFinite.h"
#include "Mesh/CoincidentPoints.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>

namespace ink
{

WeldedTriangles::WeldedTriangles(const TriangleMesh& mesh)
  : points(mesh.points)
{
  std::vector<std::uint8_t> isUsed(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle& triangle = mesh.triangles[t];
    if (!std::all_of(triangle.begin(), triangle.end(),
          [&mesh](std::uint32_t point) { return isFinite(mesh.points[point]); }))
    {
      continue;
    }
    if (this->triangles.empty())
    {
      this->lower = this->upper = mesh.points[triangle[0]];
    }
    for (const std::uint32_t point : triangle)
    {
      isUsed[point] = 1;
      this->lower = glm::min(this->lower, mesh.points[point]);
      this->upper = glm::max(this->upper, mesh.points[point]);
    }
    this->triangles.push_back(triangle);
    this->source.push_back(static_cast<std::uint32_t>(t));
  }
  std::vector<std::uint32_t> used;
  std::vector<std::uint32_t> number(mesh.points.size());
  for (std::uint32_t point = 0; point < mesh.points.size(); ++point)
  {
    number[point] = static_cast<std::uint32_t>(used.size());
    if (isUsed[point] != 0)
    {
      used.push_back(point);
    }
  }
  const std::vector<std::uint32_t> firsts =
    coincidentPoints(mesh.points, used, coincidenceDistance(this->lower, this->upper));
  for (Triangle& triangle : this->triangles)
  {
    for (std::uint32_t& point : triangle)
    {
      point = firsts[number[point]];
    }
  }
}

double WeldedTriangles::diagonal() const
{
  return glm::distance(this->lower, this->upper);
}

} // namespace ink
