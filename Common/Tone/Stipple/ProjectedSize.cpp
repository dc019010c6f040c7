// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/ProjectedSize.h"

#include <algorithm>
#include <cmath>

namespace ink::stipple
{

float maximumStipples(float elementSize, float pixelSize, float pixelsPerStipple)
{
  constexpr float mostPixels = 1e6f;
  const float pixels = std::min(elementSize / pixelSize, mostPixels);
  return pixels * pixels / pixelsPerStipple;
}

int projectedListLength(float elementSize, float pixelSize, int longest)
{
  const float room = maximumStipples(elementSize, pixelSize, 1.0f);
  return static_cast<int>(std::lround(std::clamp(room, 1.0f, static_cast<float>(longest))));
}

} // namespace ink::stipple
