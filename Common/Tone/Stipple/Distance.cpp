// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Distance.h"

#include "Tone/Power.h"

#include <algorithm>
#include <cmath>

namespace ink::stipple
{

float Distance::factor(float depth) const
{
  if (!this->on)
  {
    return 1.0f;
  }
  const float z = std::clamp(depth, -1.0f, 1.0f);
  return 1.0f + std::copysign(power(std::abs(z), this->exponent), z);
}

float Distance::sizeFactor(float depth) const
{
  return 1.0f + this->size * (this->factor(depth) - 1.0f);
}

} // namespace ink::stipple
