// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/SmallElements.h"

#include <algorithm>

namespace ink::stipple
{

float SmallElements::weight(float maximumStipples) const
{
  return std::clamp(1.0f - (maximumStipples - 1.0f) / (this->minimumCoverage - 1.0f), 0.0f, 1.0f);
}

float SmallElements::part(float tone, int rank, float random, float weightOfSmall) const
{
  float number = tone;
  float width = this->fade;
  if (this->way == Way::probability)
  {
    number += weightOfSmall * (random - 0.5f);
    width *= 1.0f - weightOfSmall;
  }
  else
  {
    width += weightOfSmall * (1.0f - width);
  }
  const float beyond = number - static_cast<float>(rank) - 0.5f;
  // Not a very steep ramp instead: far away, where tones are tiny, its foot would be darker than they are.
  constexpr float leastFade = 1e-3f;
  if (width < leastFade)
  {
    return beyond >= 0.0f ? 1.0f : 0.0f;
  }
  return std::clamp(beyond / width + 0.5f, 0.0f, 1.0f);
}

} // namespace ink::stipple
