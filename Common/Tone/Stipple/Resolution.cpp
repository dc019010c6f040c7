// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Resolution.h"

#include "Tone/Power.h"

#include <algorithm>

namespace ink::stipple
{

float Resolution::distanceFactor(float distance, float nearest) const
{
  // What is at the eye does not have room without end.
  constexpr float leastRatio = 1e-4f;
  const float ratio = std::max(distance / nearest, leastRatio);
  if (ratio < 1.0f)
  {
    return 1.0f / (ratio * ratio);
  }
  return this->on ? power(ratio, this->exponent) : 1.0f;
}

float Resolution::nearestDistance(float middle, float halfRange)
{
  return std::max(middle - halfRange, halfRange);
}

float Resolution::slantFactor(float cosine) const
{
  return this->on ? power(std::clamp(cosine, 0.0f, 1.0f), this->slantExponent) : 1.0f;
}

} // namespace ink::stipple
