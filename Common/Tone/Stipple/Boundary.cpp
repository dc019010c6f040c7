// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Boundary.h"

#include "Tone/Power.h"

namespace ink::stipple
{

float Boundary::factor(float value, float gradientMagnitude) const
{
  return this->on ? value * (this->base + this->gain * power(gradientMagnitude, this->exponent)) : 1.0f;
}

} // namespace ink::stipple
