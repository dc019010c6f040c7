// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Stipple/Silhouette.h"

#include "Tone/Power.h"

#include <cmath>

namespace ink::stipple
{

float Silhouette::factor(float value, float cosine) const
{
  return this->on ? value * (this->base + this->gain * (1.0f - power(std::abs(cosine), this->exponent)))
                  : 1.0f;
}

} // namespace ink::stipple
