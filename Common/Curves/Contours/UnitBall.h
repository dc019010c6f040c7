// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Eye.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ink
{

/// Coordinates in which a surface lies in about the unit ball, so that float will do for it, wherever it is
/// and whatever its size.
struct UnitBall
{
  glm::dvec3 center = glm::dvec3(0.0); ///< in world units
  double radius = 1.0;                 ///< in world units

  glm::dvec3 toBall(const glm::dvec3& position) const { return (position - this->center) / this->radius; }

  /// The eye's position; with a parallel projection, v of length 1, which is the same for all points.
  glm::vec3 toBall(const Eye& eye) const
  {
    return glm::vec3(eye.parallel ? -glm::normalize(eye.direction) : this->toBall(eye.position));
  }
};

/// Bounds what n.v loses in float for an eye there, of unit n and positions in the ball.
inline float facingSlack(const glm::vec3& eyeInBall)
{
  return 4e-6f * (1.0f + glm::length(eyeInBall));
}

} // namespace ink
