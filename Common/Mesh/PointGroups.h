// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/PointTriangles.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Points of a mesh put together with those around them: a coarser mesh's points.
struct PointGroups
{
  std::vector<std::uint32_t> ofPoints; ///< the group of each point
  std::vector<std::uint32_t> members;  ///< points, one group's after another's; the first is its middle
  std::vector<std::size_t> begins;     ///< of groups among the members, and their end

  std::size_t size() const { return this->begins.size() - 1; }
  std::span<const std::uint32_t> of(std::size_t group) const
  {
    return std::span(this->members)
      .subspan(this->begins[group], this->begins[group + 1] - this->begins[group]);
  }
};

/// Groups of points that edges join to their group's middle: no farther from it than a radius, and with a
/// normal less than some 40 degrees from its. Each point is in one; with long edges it is alone.
/// @param around the mesh's
/// @param normals one per point; a point whose normal is zero is alone
PointGroups groupPoints(
  const TriangleMesh& mesh, const PointTriangles& around, std::span<const glm::vec3> normals, double radius);

} // namespace ink
