// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/HounsfieldUnits.h"

#include "Statistics/IsoStatistics.h"
#include "Statistics/ThresholdSharpness.h"

#include <algorithm>
#include <vector>

namespace ink
{

bool areHounsfieldUnits(const IsoStatistics& statistics)
{
  const std::vector<double> kept = keptShares(statistics.voxels);
  const auto keptAbove = [&](double value)
  { return value < statistics.bins.low ? 1.0 : kept[thresholdAt(statistics.bins, value)]; };
  const auto share = [&](double low, double high) { return keptAbove(low) - keptAbove(high); };
  const double air = share(-1100.0, -800.0);
  const double tissue = share(-150.0, 150.0);
  const double below = std::min(kept.front(), 1.0) - keptAbove(-1100.0);
  return air > 0.05 && tissue > 0.05 && share(-700.0, -300.0) < 0.5 * std::min(air, tissue) && below < 0.01;
}

} // namespace ink
