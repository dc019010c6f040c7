// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Hatching/Intensity.h"

#include <algorithm>
#include <cmath>

namespace ink::hatching
{

namespace
{

/// At the slider's very ends all tones would be 0 or 1.
constexpr float leastBias = 0.02f;

} // namespace

float truncated(float intensity, float level)
{
  return level < 1.0f ? std::max(intensity - level, 0.0f) / (1.0f - level) : 0.0f;
}

float Intensity::tone(float lit, float cosine) const
{
  const float diffuse = truncated(1.0f - std::clamp(lit, 0.0f, 1.0f), this->diffuseTruncation);
  const float silhouette = truncated(1.0f - std::min(std::abs(cosine), 1.0f), this->silhouetteTruncation);
  const float combined = (1.0f - this->silhouetteWeight) * diffuse + this->silhouetteWeight * silhouette;
  const float b = std::clamp(this->bias, leastBias, 1.0f - leastBias);
  return this->darkest * combined / ((1.0f / b - 2.0f) * (1.0f - combined) + 1.0f);
}

} // namespace ink::hatching
