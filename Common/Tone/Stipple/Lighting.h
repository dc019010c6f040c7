// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>

namespace ink::stipple
{

/// A light source in view coordinates: positional (a lamp) or directional (the sun).
struct StippleLight
{
  glm::vec4 position; ///< positional: x, y, z, 1; directional: the unit vector towards it, 0
  float intensity;    ///< 1: as Table 1 has it
  /// Of a lamp: the unit vector of its axis, the cosine of its cone's half angle, -1 for one that shines all
  /// around, and how fast its light fades towards the cone's rim, as a power of the angle's cosine.
  glm::vec3 direction{ 0.0f, 0.0f, -1.0f };
  float coneCosine = -1.0f;
  float coneExponent = 1.0f;
  /// A lamp's intensity is divided by [0] + [1] d + [2] d^2 at the distance d.
  glm::vec3 attenuation{ 1.0f, 0.0f, 0.0f };

  bool isLamp() const { return this->position.w != 0.0f; }
  /// The intensity at a position in view coordinates.
  float intensityAt(const glm::vec3& place) const;
};

/// Light enhancement (Lu et al. 2003, section 5.5 and Table 1, row 6): fewer stipples where the light falls.
struct Lighting
{
  bool on = true;
  float exponent = 1.0f;     ///< strength: with smaller values more is lit; positive
  float facingCosine = 0.0f; ///< volumes: only elements within this angle's cosine of the eye are drawn
  bool lightInk = false;     ///< the ink is lighter than the paper: stipples show light instead of shade

  /// How much light an element gets, 0 to 1: the sum of intensityAt() (N . L)^k_le over the lights it faces;
  /// with one light of intensity 1, Table 1's term.
  /// @param position, normal the element's, in view coordinates, the normal of unit length
  float lit(std::span<const StippleLight> lights, const glm::vec3& position, const glm::vec3& normal) const;

  /// T_l = 1 - lit: elements that face away from the light keep all their stipples. With light ink, lit.
  float factor(float lit) const;

  /// Whether an element of a volume is drawn at all.
  /// @param cosine of the angle between its normal and the eye, with its sign
  bool faces(float cosine) const;
};

} // namespace ink::stipple
