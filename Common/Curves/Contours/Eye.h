// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ink
{

/// The eye: a position, or with a parallel projection a direction.
struct Eye
{
  glm::dvec3 position = glm::dvec3(0.0);  ///< in world units; of no effect if parallel
  glm::dvec3 direction = glm::dvec3(0.0); ///< from the eye into the scene, of any length; only if parallel
  bool parallel = false;

  bool operator==(const Eye&) const = default;

  static Eye at(const glm::dvec3& position) { return { position, glm::dvec3(0.0), false }; }
  static Eye along(const glm::dvec3& direction) { return { glm::dvec3(0.0), direction, true }; }

  /// The vector from a point to the eye, not normalized.
  glm::dvec3 from(const glm::dvec3& point) const
  {
    return this->parallel ? -this->direction : this->position - point;
  }

  /// @throws std::invalid_argument if the position or direction that counts is not finite, or the direction
  ///   is zero
  void check() const;
};

} // namespace ink
