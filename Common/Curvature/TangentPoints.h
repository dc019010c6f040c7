// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace ink
{

/// An orthonormal frame at a point of a surface: axisU x axisV = normal, outward.
struct TangentFrame
{
  glm::dvec3 origin = glm::dvec3(0.0);
  glm::dvec3 axisU = glm::dvec3(1.0, 0.0, 0.0);
  glm::dvec3 axisV = glm::dvec3(0.0, 1.0, 0.0);
  glm::dvec3 normal = glm::dvec3(0.0, 0.0, 1.0);
};

/// The points around a point in its tangent frame: world units, heights along the normal. The arrays are
/// aligned for vectors; what follows the last point is not set.
struct TangentPoints
{
  static constexpr std::size_t capacity = 512;

  TangentFrame frame;
  std::size_t count = 0;
  alignas(64) std::array<double, capacity> u;
  alignas(64) std::array<double, capacity> v;
  alignas(64) std::array<double, capacity> height;

  void start(const TangentFrame& at)
  {
    this->frame = at;
    this->count = 0;
  }
  bool isFull() const { return this->count == capacity; }
  void add(const glm::dvec3& point)
  {
    const glm::dvec3 offset = point - this->frame.origin;
    this->u[this->count] = glm::dot(offset, this->frame.axisU);
    this->v[this->count] = glm::dot(offset, this->frame.axisV);
    this->height[this->count] = glm::dot(offset, this->frame.normal);
    ++this->count;
  }
};

} // namespace ink
