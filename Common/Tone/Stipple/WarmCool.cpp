// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/WarmCool.h"

#include <glm/common.hpp>

#include <algorithm>

namespace ink::stipple
{

glm::vec3 WarmCool::color(const glm::vec3& own, float lightCosine, float depth) const
{
  const float weights = this->tone + this->distance;
  if (this->amount <= 0.0f || weights <= 0.0f)
  {
    return own;
  }
  const float warmth = (this->tone * (0.5f + 0.5f * lightCosine) +
                         this->distance * (0.5f + 0.5f * std::clamp(depth, -1.0f, 1.0f))) /
    weights;
  const glm::vec3 blended = rgbFromHls(mixHls(this->cool, this->warm, warmth));
  return glm::mix(own, blended, this->amount);
}

} // namespace ink::stipple
