#include "Tone/Resolution.h"

#include "Tone/Power.h"

#include <algorithm>

namespace ink
{

float Resolution::distanceFactor(float distance, float nearest) const
{
  return this->on ? power(distance / nearest, this->krc) : 1.0f;
}

float Resolution::slantFactor(float cosine) const
{
  return this->on ? power(std::clamp(cosine, 0.0f, 1.0f), this->knz) : 1.0f;
}

} // namespace ink
