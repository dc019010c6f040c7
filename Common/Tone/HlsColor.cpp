// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/HlsColor.h"

#include <algorithm>
#include <cmath>

namespace ink
{

HlsColor hlsFromRgb(const glm::vec3& rgb)
{
  const float most = std::max({ rgb.r, rgb.g, rgb.b });
  const float least = std::min({ rgb.r, rgb.g, rgb.b });
  const float chroma = most - least;
  const float lightness = 0.5f * (most + least);
  if (!(chroma > 0.0f))
  {
    return { 0.0f, lightness, 0.0f };
  }
  const float saturation = chroma / (1.0f - std::abs(2.0f * lightness - 1.0f));
  float sextant;
  if (most == rgb.r)
  {
    sextant = (rgb.g - rgb.b) / chroma;
  }
  else if (most == rgb.g)
  {
    sextant = 2.0f + (rgb.b - rgb.r) / chroma;
  }
  else
  {
    sextant = 4.0f + (rgb.r - rgb.g) / chroma;
  }
  const float hue = sextant / 6.0f;
  return { hue - std::floor(hue), lightness, std::min(saturation, 1.0f) };
}

glm::vec3 rgbFromHls(const HlsColor& hls)
{
  const float amplitude = hls.saturation * std::min(hls.lightness, 1.0f - hls.lightness);
  const auto channel = [&](float offset)
  {
    const float turned = hls.hue + offset / 12.0f;
    const float k = 12.0f * (turned - std::floor(turned));
    return hls.lightness - amplitude * std::clamp(std::min(k - 3.0f, 9.0f - k), -1.0f, 1.0f);
  };
  return { channel(0.0f), channel(8.0f), channel(4.0f) };
}

HlsColor mixHls(const HlsColor& from, const HlsColor& to, float t)
{
  const float fromHue = from.saturation > 0.0f ? from.hue : to.hue;
  const float toHue = to.saturation > 0.0f ? to.hue : fromHue;
  const float way = toHue - fromHue - std::round(toHue - fromHue);
  const float hue = fromHue + t * way;
  return { hue - std::floor(hue), from.lightness + t * (to.lightness - from.lightness),
    from.saturation + t * (to.saturation - from.saturation) };
}

} // namespace ink
