#include "Sampling/CoverRadius.h"

#include "Sampling/BlueNoise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ink
{

namespace
{

// Of the radius: how far from the discs gaps may lie that sampleBlueNoise does not look for.
constexpr double gap = 1.06;
// Of what the radius would be if the count were a saturated set's: measured, see the documentation's table.
constexpr double gapAfterLeavingOut = 1.3;
constexpr double holes = 0.01;

} // namespace

double blueNoiseCover(double radius)
{
  return gap * radius;
}

double blueNoiseCover(double area, double count)
{
  return gapAfterLeavingOut * std::sqrt(saturatedCount * area / count);
}

double whiteNoiseCover(double area, double count)
{
  const double wanted = std::log(std::max(count, 1.0) / holes);
  double cover = wanted;
  for (int i = 0; i < 20; ++i)
  {
    cover = wanted + std::log(cover);
  }
  return std::sqrt(cover * area / (std::numbers::pi * count));
}

} // namespace ink
