// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Lighting.h"

#include "Tone/Power.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace ink::stipple
{

float StippleLight::intensityAt(const glm::vec3& place) const
{
  if (!this->isLamp())
  {
    return this->intensity;
  }
  const glm::vec3 from = place - glm::vec3(this->position);
  const float length = glm::length(from);
  const float loss =
    this->attenuation.x + length * this->attenuation.y + length * length * this->attenuation.z;
  float result = loss > 0.0f ? this->intensity / loss : 0.0f;
  if (this->coneCosine > -1.0f)
  {
    const float cosine = length > 0.0f ? glm::dot(from, this->direction) / length : 1.0f;
    result *= cosine >= this->coneCosine ? power(std::min(cosine, 1.0f), this->coneExponent) : 0.0f;
  }
  return result;
}

float Lighting::lit(
  std::span<const StippleLight> lights, const glm::vec3& position, const glm::vec3& normal) const
{
  float sum = 0.0f;
  for (const StippleLight& light : lights)
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
