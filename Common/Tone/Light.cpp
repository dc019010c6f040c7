// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Light.h"

#include "Tone/Power.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace ink
{

float Light::intensityAt(const glm::vec3& at) const
{
  if (!this->isLamp())
  {
    return this->intensity;
  }
  const glm::vec3 from = at - glm::vec3(this->position);
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

} // namespace ink
