// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/Eye.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace ink
{

void Eye::check() const
{
  const glm::dvec3& vector = this->parallel ? this->direction : this->position;
  if (!std::isfinite(vector.x) || !std::isfinite(vector.y) || !std::isfinite(vector.z))
  {
    throw std::invalid_argument(
      "the eye's " + std::string(this->parallel ? "direction" : "position") + " is not finite");
  }
  if (this->parallel && vector == glm::dvec3(0.0))
  {
    throw std::invalid_argument("the eye's direction is zero, expected a vector into the scene");
  }
}

} // namespace ink
