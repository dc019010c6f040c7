#include "Sampling/CoverRadius.h"

#include "Sampling/BlueNoise.h"
#include "Sampling/ProgressiveBlueNoise.h"

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
// The area between samples that lies beyond their radius, where the gap between them is wider than that by a
// length: this times the length squared, by the widest gaps on a square for 2 to 16 candidates.
constexpr double gapArea = 11.0;

} // namespace

double blueNoiseCover(double radius, double gap)
{
  return (1.0 + gap) * radius;
}

double blueNoiseCover(double area, double count, double gap)
{
  return afterLeavingOut * blueNoiseCover(std::sqrt(fittedCount(gap) * area / count), gap);
}

double progressiveCover(double area, double count, double candidates)
{
  const double wider = std::sqrt(std::log(std::max(count, 1.0) / holes) / (gapArea * candidates));
  return (std::sqrt(progressiveCount(candidates)) + wider) * std::sqrt(area / count);
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
