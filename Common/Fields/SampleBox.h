#pragma once

#include <glm/vec3.hpp>

#include <cstddef>

namespace ink
{

/// The samples `begin` to `end`, `end` left out, of a grid: a part that something is computed for.
struct SampleBox
{
  glm::ivec3 begin = glm::ivec3(0);
  glm::ivec3 end = glm::ivec3(0);

  glm::ivec3 size() const { return this->end - this->begin; }
  bool empty() const
  {
    const glm::ivec3 n = this->size();
    return n.x <= 0 || n.y <= 0 || n.z <= 0;
  }
  /// As a grid's size it never overflows: 0 where the box is empty.
  std::size_t count() const
  {
    const glm::ivec3 n = this->size();
    return this->empty() ? 0 : static_cast<std::size_t>(n.x) * n.y * n.z;
  }
};

} // namespace ink
