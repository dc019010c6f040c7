// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ink
{

/// A tangent vector turned by the smallest turn that brings its unit normal to another.
inline glm::dvec3 turnedTangent(const glm::dvec3& tangent, const glm::dvec3& from, const glm::dvec3& to)
{
  const double cosine = glm::dot(from, to);
  return cosine > -0.999 ? tangent - glm::dot(tangent, to) / (1.0 + cosine) * (from + to) : tangent;
}

} // namespace ink
