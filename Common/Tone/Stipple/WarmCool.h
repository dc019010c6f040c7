// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Tone/HlsColor.h"

namespace ink::stipple
{

/// Warm and cool colors for light and shade, near and far (Lu et al. 2003, section 5.7).
struct WarmCool
{
  HlsColor warm{ 0.0f, 0.4f, 0.9f };         ///< of what faces the light, or is near
  HlsColor cool{ 2.0f / 3.0f, 0.35f, 0.9f }; ///< of what faces away, or is far
  float tone = 1.0f;                         ///< weight of the orientation towards the light
  float distance = 0.0f;                     ///< weight of the depth
  float amount = 0.0f;                       ///< 0: only the stipple's own color; 1: only warm and cool

  /// The color of a stipple.
  /// @param own its own color, RGB in 0..1
  /// @param lightCosine of the angle between normal and light, -1 to 1
  /// @param depth z / a, -1 far to 1 near
  glm::vec3 color(const glm::vec3& own, float lightCosine, float depth) const;
};

} // namespace ink::stipple
