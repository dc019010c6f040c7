// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

namespace ink
{

/// A color as hue, lightness and saturation (Foley et al. 1990), each in 0..1; red has hue 0, green 1/3.
struct HlsColor
{
  float hue;
  float lightness;
  float saturation; ///< 0: gray, whatever the hue
};

/// @param rgb in 0..1
HlsColor hlsFromRgb(const glm::vec3& rgb);
glm::vec3 rgbFromHls(const HlsColor& hls);

/// Interpolates linearly between two colors, hues along the shorter arc; a gray takes the other's hue.
HlsColor mixHls(const HlsColor& from, const HlsColor& to, float t);

} // namespace ink
