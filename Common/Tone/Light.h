// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace ink
{

/// A light source in view coordinates: positional (a lamp) or directional (the sun).
struct Light
{
  glm::vec4 position; ///< positional: x, y, z, 1; directional: the unit vector towards it, 0
  float intensity;    ///< a factor of the light that falls on a point
  /// Of a lamp: the unit vector of its axis, the cosine of its cone's half angle, -1 for one that shines all
  /// around, and how fast its light fades towards the cone's rim, as a power of the angle's cosine.
  glm::vec3 direction{ 0.0f, 0.0f, -1.0f };
  float coneCosine = -1.0f;
  float coneExponent = 1.0f;
  /// A lamp's intensity is divided by [0] + [1] d + [2] d^2 at the distance d.
  glm::vec3 attenuation{ 1.0f, 0.0f, 0.0f };

  bool isLamp() const { return this->position.w != 0.0f; }
  /// The intensity at a position in view coordinates.
  float intensityAt(const glm::vec3& at) const;
};

} // namespace ink
