// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>

namespace ink
{

/// A box of a grid's samples, from `begin` up to but excluding `end`.
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
  /// The number of samples; 0 if the box is empty. Boxes lie in grids, whose size does not overflow.
  std::size_t count() const
  {
    const glm::ivec3 n = this->size();
    return this->empty() ? 0 : static_cast<std::size_t>(n.x) * n.y * n.z;
  }
};

} // namespace ink
