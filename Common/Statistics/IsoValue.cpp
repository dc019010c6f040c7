// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoValue.h"

#include "Fields/ScalarDifference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace ink
{
namespace
{

// With fewer intersected edges the sharpness of a surface is not significant.
constexpr std::int64_t fewestEdges = 200;
// A maximum counts if the sharpness falls by this fraction on both sides of it.
constexpr double prominence = 0.05;
// The maximum fraction of a surface's edges at voxels with at most one neighbor inside; above it, the surface
// is noise.
constexpr double largestSpeckShare = 0.05;
// A disc that touches the sides of its square covers 78.5 % of it: the border of a round field of view.
constexpr double largestInsideShare = 0.75;

/// The mean step along the edges that cross each threshold. Infinite for noise and the border of the field of
/// view, so that nothing beside them is a maximum; zero for thresholds that hardly any edge crosses.
std::vector<double> sharpness(const IsoStatistics& profile)
{
  const std::int64_t all = std::accumulate(profile.voxels.begin(), profile.voxels.end(), std::int64_t{ 0 });
  std::vector<double> result(profile.edges.size(), 0.0);
  std::int64_t inside = all;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    inside -= profile.voxels[i];
    if (profile.edges[i] < fewestEdges)
    {
      continue;
    }
    const auto edges = static_cast<double>(profile.edges[i]);
    const bool noise = static_cast<double>(profile.speckEdges[i]) > largestSpeckShare * edges;
    const bool border = static_cast<double>(inside) > largestInsideShare * static_cast<double>(all);
    result[i] = noise || border ? std::numeric_limits<double>::infinity()
                                : static_cast<double>(profile.steps[i]) / edges;
  }
  return result;
}

/// The center of the lowest prominent maximum, as a position between bins.
std::optional<double> lowestMaximum(const std::vector<double>& values)
{
  constexpr double keep = 1.0 - prominence;
  double valley = 0.0;
  std::size_t first = 0;
  std::size_t last = 0;
  double peak = 0.0;
  for (std::size_t i = 0; i <= values.size(); ++i)
  {
    const double value = i < values.size() ? values[i] : 0.0;
    if (value < keep * peak)
    {
      if (std::isfinite(peak) && valley < keep * peak)
      {
        return (static_cast<double>(first) + static_cast<double>(last)) / 2;
      }
      valley = peak = value;
      first = last = i;
    }
    else if (value > peak)
    {
      peak = value;
      first = last = i;
    }
    else if (value == peak && last + 1 == i)
    {
      last = i;
    }
    valley = std::min(valley, value);
  }
  return std::nullopt;
}

double otsuThreshold(const std::vector<std::int64_t>& histogram)
{
  double count = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < histogram.size(); ++i)
  {
    count += static_cast<double>(histogram[i]);
    sum += static_cast<double>(histogram[i]) * static_cast<double>(i);
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double best = -1.0;
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i + 1 < histogram.size(); ++i)
  {
    below += static_cast<double>(histogram[i]);
    sumBelow += static_cast<double>(histogram[i]) * static_cast<double>(i);
    if (below == 0.0 || below == count)
    {
      continue;
    }
    const double difference = sumBelow / below - (sum - sumBelow) / (count - below);
    const double variance = below * (count - below) * difference * difference;
    if (variance > best)
    {
      best = variance;
      first = last = i;
    }
    else if (variance == best)
    {
      last = i;
    }
  }
  return (static_cast<double>(first) + static_cast<double>(last)) / 2;
}

} // namespace

template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce)
{
  const std::optional<IsoStatistics> profile = makeIsoStatistics(read, dimensions, slicesAtOnce);
  if (!profile)
  {
    return std::nullopt;
  }
  const std::optional<double> maximum = lowestMaximum(sharpness(*profile));
  const double threshold = maximum ? *maximum : otsuThreshold(profile->voxels);
  return IsoSuggestion{ profile->bins.low + (threshold + 1.0) * profile->bins.width,
    maximum ? IsoSuggestion::Method::Boundary : IsoSuggestion::Method::Otsu };
}

template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(std::span<const T> values, std::array<int, 3> dimensions)
{
  for (int& dimension : dimensions)
  {
    dimension = std::max(dimension, 0);
  }
  const std::size_t sliceSize = static_cast<std::size_t>(dimensions[0]) * dimensions[1];
  if (values.size() != sliceSize * dimensions[2])
  {
    throw std::invalid_argument("suggestIsoValue: " + std::to_string(values.size()) + " values, but " +
      std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
      std::to_string(dimensions[2]) + " voxels");
  }
  const SliceReader<T> read = [&](int first, int last)
  { return values.subspan(sliceSize * first, sliceSize * (last - first)); };
  return suggestIsoValue(read, dimensions, std::max(dimensions[2], 1) + 2);
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::optional<IsoSuggestion> suggestIsoValue(std::span<const T>, std::array<int, 3>);             \
  template std::optional<IsoSuggestion> suggestIsoValue(const SliceReader<T>&, std::array<int, 3>, int);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
