#include "Tone/Silhouette.h"

#include "Tone/Power.h"

#include <cmath>

namespace ink
{

float Silhouette::factor(float value, float cosine) const
{
  return this->on ? value * (this->ksc + this->kss * (1.0f - power(std::abs(cosine), this->kse))) : 1.0f;
}

} // namespace ink
