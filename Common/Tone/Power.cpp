// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Power.h"

#include <cmath>

namespace ink
{

float power(float base, float exponent)
{
  if (base > 0.0f)
  {
    return std::pow(base, exponent);
  }
  return base == 0.0f && exponent == 0.0f ? 1.0f : 0.0f;
}

} // namespace ink
