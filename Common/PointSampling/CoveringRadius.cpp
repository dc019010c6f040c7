// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/CoveringRadius.h"

#include "PointSampling/PoissonDisk.h"
#include "PointSampling/ProgressiveBlueNoise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ink
{

namespace
{

// The factor on the covering radius for the voids that removing a few samples leaves: chosen so that probing
// known surfaces finds no hole.
constexpr double afterLeavingOut = 1.4;
constexpr double holes = 0.01;
// The uncovered area in a void whose width exceeds the radius by a length is this times the length squared;
// fitted to the widest voids on a square for 2 to 16 candidates.
constexpr double gapArea = 11.0;

} // namespace

double poissonDiskCover(double radius, double slack)
{
  return (1.0 + slack) * radius;
}

double poissonDiskCover(double area, double count, double slack)
{
  return afterLeavingOut * poissonDiskCover(std::sqrt(fittedCount(slack) * area / count), slack);
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
