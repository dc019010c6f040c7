// CMakeLists.txt lets the compiler judge several members at a time: the least of some numbers does not depend
// on their order.

#include "Sampling/StippleCrowd.h"

#include <algorithm>

namespace ink
{

StippleCrowd::StippleCrowd(std::size_t capacity)
  : X(capacity)
  , Y(capacity)
  , Number(capacity)
{
}

void StippleCrowd::keepWithin(float distance)
{
  std::size_t kept = 0;
  for (std::size_t n = 0; n < this->Size; ++n)
  {
    const float x = this->X[n];
    const float y = this->Y[n];
    this->X[kept] = x;
    this->Y[kept] = y;
    this->Number[kept] = this->Number[n];
    kept += x * x + y * y <= distance * distance;
  }
  this->Size = kept;
}

void StippleCrowd::leastSpacing(const Lanes& x, const Lanes& y, int number, Lanes& least) const
{
  const float* const memberX = this->X.data();
  const float* const memberY = this->Y.data();
  const float* const memberNumber = this->Number.data();
  const float own = static_cast<float>(number);
  float candidateX[lanes];
  float candidateY[lanes];
  float best[lanes];
  for (int i = 0; i < lanes; ++i)
  {
    candidateX[i] = x[i];
    candidateY[i] = y[i];
    best[i] = 1e30f;
  }
  for (std::size_t n = 0; n < this->Size; ++n)
  {
    const float weight = std::max(own, memberNumber[n]);
    for (int i = 0; i < lanes; ++i)
    {
      const float dx = candidateX[i] - memberX[n];
      const float dy = candidateY[i] - memberY[n];
      best[i] = std::min(best[i], weight * (dx * dx + dy * dy));
    }
  }
  std::copy(best, best + lanes, least.begin());
}

} // namespace ink
