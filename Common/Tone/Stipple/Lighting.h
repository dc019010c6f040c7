// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tone/Light.h"

#include <span>

namespace ink::stipple
{

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
  float lit(std::span<const Light> lights, const glm::vec3& position, const glm::vec3& normal) const;

  /// T_l = 1 - lit: elements that face away from the light keep all their stipples. With light ink, lit.
  float factor(float lit) const;

  /// Whether an element of a volume is drawn at all.
  /// @param cosine of the angle between its normal and the eye, with its sign
  bool faces(float cosine) const;
};

} // namespace ink::stipple
