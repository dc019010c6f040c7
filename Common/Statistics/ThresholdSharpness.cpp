// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/ThresholdSharpness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ink
{
namespace
{

// With fewer intersected edges the sharpness of a surface is not significant.
constexpr std::int64_t fewestEdges = 200;
// The maximum fraction of a surface's edges at voxels with at most one neighbor inside; above it, the surface
// is noise, or so thin that it breaks up.
constexpr double largestSpeckShare = 0.05;
// Above this one, a surface is so even where boundaries were found in smoothed values.
constexpr double speckledShare = 2.0 * largestSpeckShare;
// By what factor a material's noise makes the edges at such voxels more; where fine parts break up, they
// become hardly more while the others become fewer.
constexpr std::int64_t noiseGrowth = 4;
// A disc that touches the sides of its square covers 78.5 % of it: the border of a round field of view.
constexpr double largestKeptShare = 0.75;
// Above this share of noisy steps, boundaries are looked for in smoothed values, too.
constexpr double hidingShare = 0.2;
// At rare values noise has up to this many times the steps that it has at common ones.
constexpr double sharperThanNoise = 3.0;

} // namespace

ThresholdEdges withoutMasks(const IsoStatistics& statistics)
{
  ThresholdEdges sums{ statistics.edges, statistics.steps };
  for (std::size_t i = 0; i < sums.edges.size(); ++i)
  {
    sums.edges[i] -= statistics.maskEdges[i];
    sums.steps[i] -= statistics.maskSteps[i];
  }
  return sums;
}

std::vector<double> keptShares(const std::vector<std::int64_t>& voxels)
{
  const std::int64_t all = std::accumulate(voxels.begin(), voxels.end(), std::int64_t{ 0 });
  std::vector<double> shares(voxels.size());
  std::int64_t kept = all;
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    kept -= voxels[i];
    shares[i] = static_cast<double>(kept) / static_cast<double>(all);
  }
  return shares;
}

std::vector<bool> findNoisyThresholds(const std::vector<std::int64_t>& edges,
  const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept)
{
  const std::size_t count = edges.size();
  const auto isBorder = [&](std::size_t i) { return kept[i] > largestKeptShare; };
  const auto hasSpecks = [&](std::size_t i)
  { return static_cast<double>(speckEdges[i]) > largestSpeckShare * static_cast<double>(edges[i]); };
  std::vector<bool> noise(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isBorder(i) || !hasSpecks(i))
    {
      noise[i] = isBorder(i);
      continue;
    }
    std::size_t end = i;
    std::int64_t most = 0;
    for (; end < count && hasSpecks(end); ++end)
    {
      most = std::max(most, speckEdges[end]);
    }
    const bool adds = i == 0 || isBorder(i - 1) || most > noiseGrowth * speckEdges[i - 1];
    std::fill(
      noise.begin() + static_cast<std::ptrdiff_t>(i), noise.begin() + static_cast<std::ptrdiff_t>(end), adds);
    i = end - 1;
  }
  return noise;
}

std::vector<double> thresholdSharpness(
  const ThresholdEdges& sums, const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept)
{
  const std::vector<bool> noise = findNoisyThresholds(sums.edges, speckEdges, kept);
  std::vector<double> result(sums.edges.size(), 0.0);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    if (sums.edges[i] >= fewestEdges)
    {
      result[i] = noise[i] ? std::numeric_limits<double>::infinity()
                           : static_cast<double>(sums.steps[i]) / static_cast<double>(sums.edges[i]);
    }
  }
  return result;
}

double meanStep(const IsoStatistics& statistics, std::size_t threshold)
{
  return static_cast<double>(statistics.steps[threshold]) / static_cast<double>(statistics.edges[threshold]);
}

double speckShare(const IsoStatistics& statistics, std::size_t threshold)
{
  return static_cast<double>(statistics.speckEdges[threshold]) /
    static_cast<double>(statistics.edges[threshold]);
}

std::size_t thresholdAt(const ValueBins& bins, double value)
{
  const double position = (value - bins.low) / bins.width - 1.0;
  return static_cast<std::size_t>(std::clamp(std::round(position), 0.0, bins.count - 1.0));
}

bool isSpeckled(const IsoStatistics& statistics, double value)
{
  return speckShare(statistics, thresholdAt(statistics.bins, value)) > speckledShare;
}

bool noiseHidesBoundaries(const IsoStatistics& statistics)
{
  const std::vector<double> kept = keptShares(statistics.voxels);
  const std::vector<bool> noise = findNoisyThresholds(statistics.edges, statistics.speckEdges, kept);
  double all = 0.0;
  double hidden = 0.0;
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    const double edges = kept[i] > largestKeptShare ? 0.0 : static_cast<double>(statistics.edges[i]);
    all += edges;
    hidden += noise[i] ? edges : 0.0;
  }
  return hidden > hidingShare * all;
}

bool isSharperThanNoise(const IsoStatistics& statistics, std::size_t threshold)
{
  double least = meanStep(statistics, threshold);
  for (std::size_t i = 0; i < statistics.edges.size(); ++i)
  {
    least = statistics.edges[i] >= fewestEdges ? std::min(least, meanStep(statistics, i)) : least;
  }
  return meanStep(statistics, threshold) >= sharperThanNoise * least;
}

} // namespace ink
