#include "Tone/Boundary.h"

#include "Tone/Power.h"

namespace ink
{

float Boundary::factor(float value, float gradientMagnitude) const
{
  return this->on ? value * (this->kgc + this->kgs * power(gradientMagnitude, this->kge)) : 1.0f;
}

} // namespace ink
