#include "Tone/Interior.h"

#include "Tone/Power.h"

namespace ink
{

float Interior::factor(float gradientMagnitude) const
{
  return this->on ? power(gradientMagnitude, this->kie) : 1.0f;
}

float Interior::sizeFactor(float gradientMagnitude) const
{
  return 1.0f + this->size * (this->factor(gradientMagnitude) - 1.0f);
}

} // namespace ink
