// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Interior.h"

#include "Tone/Power.h"

namespace ink::stipple
{

float Interior::factor(float gradientMagnitude) const
{
  return this->on ? power(gradientMagnitude, this->exponent) : 1.0f;
}

float Interior::sizeFactor(float gradientMagnitude) const
{
  return 1.0f + this->size * (this->factor(gradientMagnitude) - 1.0f);
}

} // namespace ink::stipple
