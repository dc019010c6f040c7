// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ink
{

/// Six times the volume between the origin and a triangle: negative where the normal faces the origin,
/// however the triangle is wound.
/// @param normal of any length
inline double signedVolume(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& normal)
{
  const double side = glm::dot(glm::cross(b - a, c - a), normal);
  return (side < 0.0 ? -1.0 : 1.0) * glm::dot(a, glm::cross(b, c));
}

} // namespace ink
