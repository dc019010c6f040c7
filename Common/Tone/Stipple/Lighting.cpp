// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Lighting.h"

#include "Tone/Power.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace ink::stipple
{

float Lighting::lit(std::span<const Light> lights, const glm::vec3& position, const glm::vec3& normal) const
{
  float sum = 0.0f;
  for (const Light& light : lights)
  {
    const glm::vec3 towards = glm::vec3(light.position) - light.position.w * position;
    const float length = glm::length(towards);
    const float cosine = length > 0.0f ? glm::dot(normal, towards) / length : 1.0f;
    sum += cosine > 0.0f ? light.intensityAt(position) * power(std::min(cosine, 1.0f), this->exponent) : 0.0f;
  }
  return std::min(sum, 1.0f);
}

float Lighting::factor(float lit) const
{
  return !this->on ? 1.0f : this->lightInk ? lit : 1.0f - lit;
}

bool Lighting::faces(float cosine) const
{
  return !this->on || cosine >= this->facingCosine;
}

} // namespace ink::stipple
