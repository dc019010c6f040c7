// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace ink::hatching
{

/// Sums of weights around positions on a surface, with the kernel (1 - d^2 / r^2)^2 of the distance d up to a
/// radius r. Samples are kept in rows along x, which are a radius apart.
class KernelSums
{
public:
  struct Sample
  {
    glm::vec3 position; ///< finite
    glm::vec3 normal;   ///< unit; 0: unknown
    glm::vec3 weights;
  };

  /// @param radius above 0
  KernelSums(std::vector<Sample> samples, float radius);

  /// Of the samples that are on the same side of the same sheet (ink::areApart).
  glm::vec3 at(const glm::vec3& position, const glm::vec3& normal) const;

private:
  glm::ivec2 rowOf(const glm::vec3& position) const;
  std::size_t indexOf(int y, int z) const
  {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(this->Rows.x) + static_cast<std::size_t>(y);
  }

  float Radius;
  float Edge;                      ///< of rows, no less than the radius
  glm::vec3 Lower;                 ///< corner of the samples' box
  glm::ivec2 Rows;                 ///< along y and z, with an empty one at each side
  std::vector<std::size_t> Begins; ///< of the rows' samples
  std::vector<Sample> Samples;     ///< row by row, along x
};

} // namespace ink::hatching
