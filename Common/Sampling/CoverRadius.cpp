#include "Sampling/CoverRadius.h"

#include "Sampling/BlueNoise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ink
{

namespace
{

// How much wider discs must be for the gaps that leaving out a few samples leaves: chosen so that probes of
// known surfaces find no hole.
constexpr double afterLeavingOut = 1.4;
constexpr double holes = 0.01;

} // namespace

double blueNoiseCover(double radius, double gap)
{
  return (1.0 + gap) * radius;
}

double blueNoiseCover(double area, double count, double gap)
{
  return afterLeavingOut * blueNoiseCover(std::sqrt(fittedCount(gap) * area / count), gap);
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
