// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointGroups.h"

#include <glm/geometric.hpp>

#include <limits>

namespace ink
{

PointGroups groupPoints(
  const TriangleMesh& mesh, const PointTriangles& around, std::span<const glm::vec3> normals, double radius)
{
  constexpr float leastCosine = 0.75f;
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  PointGroups groups;
  groups.ofPoints.assign(mesh.points.size(), none);
  groups.members.reserve(mesh.points.size());
  groups.begins.push_back(0);
  for (std::uint32_t middle = 0; middle < mesh.points.size(); ++middle)
  {
    if (groups.ofPoints[middle] != none)
    {
      continue;
    }
    const auto number = static_cast<std::uint32_t>(groups.size());
    groups.ofPoints[middle] = number;
    groups.members.push_back(middle);
    for (std::size_t next = groups.begins.back(); next < groups.members.size(); ++next)
    {
      for (const std::uint32_t t : around.of(groups.members[next]))
      {
        for (const std::uint32_t point : mesh.triangles[t])
        {
          if (groups.ofPoints[point] == none &&
            glm::distance(mesh.points[point], mesh.points[middle]) <= radius &&
            glm::dot(normals[point], normals[middle]) >= leastCosine)
          {
            groups.ofPoints[point] = number;
            groups.members.push_back(point);
          }
        }
      }
    }
    groups.begins.push_back(groups.members.size());
  }
  return groups;
}

} // namespace ink
