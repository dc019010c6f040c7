// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// The positions p with normal . p <= offset.
struct HalfSpace
{
  glm::dvec3 normal;
  double offset;

  bool contains(const glm::dvec3& p) const { return glm::dot(this->normal, p) <= this->offset; }
};

/// Whether a position is in all of them; of no half-spaces, as any is.
inline bool areContaining(std::span<const HalfSpace> region, const glm::dvec3& p)
{
  return std::all_of(region.begin(), region.end(), [&](const HalfSpace& half) { return half.contains(p); });
}

/// The triangles that reach into a region: those that are not all outside of one of its half-spaces, so that
/// a few beyond its edges are among them. Ascending.
/// @param mesh each triangle's points exist
std::vector<std::uint32_t> trianglesWithin(const TriangleMesh& mesh, std::span<const HalfSpace> region);

} // namespace ink
