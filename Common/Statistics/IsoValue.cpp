// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoValue.h"

#include "Fields/ScalarDifference.h"
#include "Statistics/MaterialValues.h"
#include "Statistics/SmoothedSlices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
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
constexpr double prominence = 0.1;
// The maximum fraction of a surface's edges at voxels with at most one neighbor inside; above it, the surface
// is noise, or so thin that it breaks up.
constexpr double largestSpeckShare = 0.05;
// By what factor a material's noise makes the edges at such voxels more; where fine parts break up, they
// become hardly more while the others become fewer.
constexpr std::int64_t noiseGrowth = 4;
// A disc that touches the sides of its square covers 78.5 % of it: the border of a round field of view.
constexpr double largestKeptShare = 0.75;
// Thresholds around a maximum with this fraction of its sharpness are as good as it is.
constexpr double nearlyAsSharp = 0.8;
// Of these, those with this fraction of the greatest total step leave the surface as whole.
constexpr double nearlyAsLarge = 0.9;
// Thresholds with this fraction of the greatest sharpness lie evenly on both sides of a boundary.
constexpr double asSharp = 0.95;
// What keeps less than this fraction of the voxels that the lowest boundary keeps is a fragment.
constexpr double fragmentShare = 0.01;
// So is the lowest boundary without a material above it if it has less than this fraction of the area of the
// surfaces at lower values: smooth fields, such as simulations have, are steepest towards their peaks.
constexpr double fragmentArea = 0.05;
// What intersects more than this fraction of a volume's edges is noise rather than a surface.
constexpr double mostIntersected = 0.125;
constexpr std::size_t mostSuggestions = 3;
// Closer to the middle of two materials, by this fraction of their difference, a boundary stays where it is
// sharpest: that makes up for what a point spread takes off from convex parts.
constexpr double farFromMiddle = 0.08;
// At rare values noise has up to this many times the steps that it has at common ones.
constexpr double sharperThanNoise = 3.0;
// Slices that are smoothed at once: enough for all threads, and few enough for this memory in bytes, as far
// as three take less.
constexpr int mostSmoothedAtOnce = 66;
constexpr double smoothingMemory = 0x1p28;

/// How many slices are smoothed at once, of at least 3 that are read at once.
int countSmoothedAtOnce(const std::array<int, 3>& dimensions, int slicesAtOnce)
{
  // See smoothedSlices.
  const double bytes = 24.0 * std::max(dimensions[0], 1) * std::max(dimensions[1], 1);
  const int most = std::min(slicesAtOnce, mostSmoothedAtOnce);
  return static_cast<int>(std::clamp(smoothingMemory / bytes, 3.0, std::max(static_cast<double>(most), 3.0)));
}

/// The edges that cross each threshold and the sums of their steps.
struct EdgeSums
{
  std::vector<std::int64_t> edges;
  std::vector<std::int64_t> steps;
};

EdgeSums withoutMasks(const IsoStatistics& statistics)
{
  EdgeSums sums{ statistics.edges, statistics.steps };
  for (std::size_t i = 0; i < sums.edges.size(); ++i)
  {
    sums.edges[i] -= statistics.maskEdges[i];
    sums.steps[i] -= statistics.maskSteps[i];
  }
  return sums;
}

/// The share of the voxels above each threshold.
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

/// Whether each threshold is noise, or the border of the field of view.
std::vector<bool> findNoise(
  const EdgeSums& sums, const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept)
{
  const std::size_t count = sums.edges.size();
  const auto isBorder = [&](std::size_t i) { return kept[i] > largestKeptShare; };
  const auto hasSpecks = [&](std::size_t i)
  { return static_cast<double>(speckEdges[i]) > largestSpeckShare * static_cast<double>(sums.edges[i]); };
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

/// The mean step along the edges that cross each threshold. Infinite for noise and the border of the field of
/// view, so that nothing beside them is a maximum; zero for thresholds that hardly any edge crosses.
std::vector<double> sharpness(
  const EdgeSums& sums, const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept)
{
  const std::vector<bool> noise = findNoise(sums, speckEdges, kept);
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

/// A finite local maximum that is prominent on both sides: the first and last threshold with its value.
struct Maximum
{
  std::size_t first;
  std::size_t last;
};

std::vector<Maximum> prominentMaxima(const std::vector<double>& values)
{
  constexpr double keep = 1.0 - prominence;
  std::vector<Maximum> maxima;
  double valley = 0.0;
  Maximum highest{ 0, 0 };
  double peak = 0.0;
  for (std::size_t i = 0; i <= values.size(); ++i)
  {
    const double value = i < values.size() ? values[i] : 0.0;
    if (value < keep * peak)
    {
      if (std::isfinite(peak) && valley < keep * peak)
      {
        maxima.push_back(highest);
      }
      valley = peak = value;
      highest = { i, i };
    }
    else if (value > peak)
    {
      peak = value;
      highest = { i, i };
    }
    else if (value == peak && highest.last + 1 == i)
    {
      highest.last = i;
    }
    valley = std::min(valley, value);
  }
  return maxima;
}

struct Boundary
{
  double threshold;  ///< as a position between bins
  std::size_t index; ///< the threshold at or below it
  double totalStep;
  /// The thresholds around it that are nearly as sharp, from `begin` up to but excluding `end`.
  std::size_t begin;
  std::size_t end;

  bool contains(const Boundary& other) const { return other.index >= this->begin && other.index < this->end; }
};

/// The middle of the sharpest thresholds, of those around a maximum of sharpness that are nearly as sharp and
/// have nearly the greatest total step of these; if that is at the edge of them, beside another boundary or
/// noise, the maximum of sharpness itself. The total step alone is greatest on the side where a bent surface
/// has more area.
Boundary placeBoundary(const Maximum& maximum, const std::vector<double>& sharpness, const EdgeSums& sums)
{
  // Beyond a valley another boundary begins.
  const double least = nearlyAsSharp * sharpness[maximum.first];
  const double most = sharpness[maximum.first] / (1.0 - prominence);
  const auto isSharp = [&](std::size_t i) { return sharpness[i] >= least && sharpness[i] <= most; };
  std::size_t begin = maximum.first;
  while (begin > 0 && isSharp(begin - 1))
  {
    --begin;
  }
  std::size_t end = maximum.last + 1;
  while (end < sharpness.size() && isSharp(end))
  {
    ++end;
  }
  const std::int64_t greatest = *std::max_element(sums.steps.begin() + begin, sums.steps.begin() + end);
  const auto isLarge = [&](std::size_t i)
  { return static_cast<double>(sums.steps[i]) >= nearlyAsLarge * static_cast<double>(greatest); };
  double sharpest = 0.0;
  for (std::size_t i = begin; i < end; ++i)
  {
    sharpest = isLarge(i) ? std::max(sharpest, sharpness[i]) : sharpest;
  }
  const auto isIn = [&](std::size_t i) { return isLarge(i) && sharpness[i] >= asSharp * sharpest; };
  Maximum found{ begin, end - 1 };
  while (!isIn(found.first))
  {
    ++found.first;
  }
  while (!isIn(found.last))
  {
    --found.last;
  }
  if (sums.steps[begin] == greatest || sums.steps[end - 1] == greatest)
  {
    found = maximum;
  }
  const std::size_t middle = (found.first + found.last) / 2;
  return { static_cast<double>(found.first + found.last) / 2, middle, static_cast<double>(sums.steps[middle]),
    begin, end };
}

std::vector<Boundary> findBoundaries(
  const EdgeSums& sums, const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept)
{
  const std::vector<double> sharp = sharpness(sums, speckEdges, kept);
  std::vector<Boundary> boundaries;
  for (const Maximum& maximum : prominentMaxima(sharp))
  {
    const Boundary boundary = placeBoundary(maximum, sharp, sums);
    if (boundaries.empty() || boundaries.back().index != boundary.index)
    {
      boundaries.push_back(boundary);
    }
  }
  return boundaries;
}

/// Whether most of the edges that cross a threshold lie at the edge of a mask.
bool isMask(const IsoStatistics& statistics, std::size_t threshold)
{
  return 2 * statistics.maskEdges[threshold] > statistics.edges[threshold];
}

/// Whether a threshold belongs to the peaks of a smooth field.
bool isPeak(const IsoStatistics& statistics, const std::vector<double>& kept, std::size_t threshold)
{
  const EdgeSums sums = withoutMasks(statistics);
  const std::vector<bool> noise = findNoise(sums, statistics.speckEdges, kept);
  std::int64_t most = 0;
  for (std::size_t i = 0; i < threshold; ++i)
  {
    most = noise[i] ? most : std::max(most, sums.edges[i]);
  }
  const std::int64_t voxels =
    std::accumulate(statistics.voxels.begin(), statistics.voxels.end(), std::int64_t{ 0 });
  // The last bin has all outliers, too.
  const BinRange above{ threshold + 1, statistics.voxels.size() - 1 };
  return static_cast<double>(sums.edges[threshold]) < fragmentArea * static_cast<double>(most) &&
    static_cast<double>(most) <= mostIntersected * 3.0 * static_cast<double>(voxels) &&
    !findMaterialValue(statistics.voxels, above, false);
}

/// The clear boundaries, from the lowest to the highest, those of masks only if there are no others.
std::vector<Boundary> findBoundaries(const IsoStatistics& statistics, const std::vector<double>& kept)
{
  std::vector<Boundary> boundaries = findBoundaries(withoutMasks(statistics), statistics.speckEdges, kept);
  std::erase_if(boundaries, [&](const Boundary& one) { return isMask(statistics, one.index); });
  const std::size_t unmasked = boundaries.size();
  // A mask hides boundaries; without what looks like its edge, others may no longer be prominent.
  for (const Boundary& one :
    findBoundaries({ statistics.edges, statistics.steps }, statistics.speckEdges, kept))
  {
    const bool known = std::any_of(boundaries.begin(), boundaries.end(),
      [&one](const Boundary& other) { return one.contains(other) || other.contains(one); });
    if (!known && !(isMask(statistics, one.index) && unmasked > 0))
    {
      boundaries.push_back(one);
    }
  }
  std::sort(boundaries.begin(), boundaries.end(),
    [](const Boundary& a, const Boundary& b) { return a.threshold < b.threshold; });
  std::erase_if(boundaries,
    [&, least = boundaries.empty() ? 0.0 : fragmentShare * kept[boundaries.front().index]](
      const Boundary& one) { return kept[one.index] < least; });
  while (!boundaries.empty() && isPeak(statistics, kept, boundaries.front().index))
  {
    boundaries.erase(boundaries.begin());
  }
  return boundaries;
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

/// What a position between bins is as a value.
double valueAt(const ValueBins& bins, double threshold)
{
  return bins.low + (threshold + 1.0) * bins.width;
}

/// Whether most of the steps lie at thresholds that are noise, which may hide boundaries.
bool isNoisy(const IsoStatistics& statistics)
{
  const std::vector<double> kept = keptShares(statistics.voxels);
  const std::vector<bool> noise =
    findNoise({ statistics.edges, statistics.steps }, statistics.speckEdges, kept);
  double all = 0.0;
  double hidden = 0.0;
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    const double edges = kept[i] > largestKeptShare ? 0.0 : static_cast<double>(statistics.edges[i]);
    all += edges;
    hidden += noise[i] ? edges : 0.0;
  }
  return hidden > 0.5 * all;
}

/// Whether steps at a threshold are much larger than where they are smallest, within a material: smoothed
/// noise has maxima of sharpness of its own, where values are rare.
bool isSharperThanNoise(const IsoStatistics& statistics, std::size_t threshold)
{
  const auto meanStep = [&](std::size_t i)
  { return static_cast<double>(statistics.steps[i]) / static_cast<double>(statistics.edges[i]); };
  double least = meanStep(threshold);
  for (std::size_t i = 0; i < statistics.edges.size(); ++i)
  {
    least = statistics.edges[i] >= fewestEdges ? std::min(least, meanStep(i)) : least;
  }
  return meanStep(threshold) >= sharperThanNoise * least;
}

/// Moves boundaries half way between the values of the materials on both sides, as far as they stay nearly as
/// sharp. Where a denser material touches the surface, too, the sharpness is greatest somewhat nearer to its
/// value.
void center(const IsoStatistics& statistics, std::vector<Boundary>& boundaries)
{
  const std::vector<Boundary> found = boundaries;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const std::size_t own = found[i].index + 1;
    // What lies beyond a mask's edge is not beside this one.
    std::size_t before = own - 1;
    while (before > 0 && (i == 0 || before > found[i - 1].index + 1) && !isMask(statistics, before - 1))
    {
      --before;
    }
    const std::size_t after = i + 1 < found.size() ? found[i + 1].index + 1 : statistics.voxels.size();
    const std::optional<double> low = findMaterialValue(statistics.voxels, { before, own }, true);
    const std::optional<double> high = findMaterialValue(statistics.voxels, { own, after }, false);
    if (!low || !high)
    {
      continue;
    }
    // Threshold i lies at the end of bin i, half a bin after its middle.
    const double middle = std::round(0.5 * (*low + *high) - 0.5);
    if (std::abs(middle - found[i].threshold) >= farFromMiddle * (*high - *low))
    {
      boundaries[i].threshold =
        std::clamp(middle, static_cast<double>(found[i].begin), static_cast<double>(found[i].end - 1));
      boundaries[i].index = static_cast<std::size_t>(boundaries[i].threshold);
    }
  }
}

/// The iso-values of clear boundaries, the best first.
std::vector<IsoSuggestion> suggestBoundaries(const IsoStatistics& statistics, bool smoothed)
{
  const std::vector<double> kept = keptShares(statistics.voxels);
  std::vector<Boundary> boundaries = findBoundaries(statistics, kept);
  if (smoothed)
  {
    std::erase_if(
      boundaries, [&](const Boundary& one) { return !isSharperThanNoise(statistics, one.index); });
  }
  if (boundaries.empty())
  {
    return {};
  }
  center(statistics, boundaries);
  const double densest = boundaries.back().threshold;
  std::stable_sort(boundaries.begin() + 1, boundaries.end(),
    [](const Boundary& a, const Boundary& b) { return a.totalStep > b.totalStep; });
  boundaries.resize(std::min(boundaries.size(), mostSuggestions));
  std::vector<IsoSuggestion> suggestions;
  for (const Boundary& one : boundaries)
  {
    const IsoSuggestion::Boundary kind = suggestions.empty() ? IsoSuggestion::Boundary::Outermost
      : one.threshold == densest                             ? IsoSuggestion::Boundary::Densest
                                                             : IsoSuggestion::Boundary::Inner;
    suggestions.push_back({ valueAt(statistics.bins, one.threshold), kind, kept[one.index] });
  }
  return suggestions;
}

/// Of a volume without a boundary.
std::vector<IsoSuggestion> suggestThresholds(const IsoStatistics& statistics)
{
  const std::vector<double> kept = keptShares(statistics.voxels);
  std::vector<IsoSuggestion> suggestions;
  const double zero = std::floor(-statistics.bins.low / statistics.bins.width) - 1.0;
  if (zero >= 0.0 && zero < static_cast<double>(kept.size()))
  {
    const double share = kept[static_cast<std::size_t>(zero)];
    if (share >= fragmentShare && share <= 1.0 - fragmentShare)
    {
      suggestions.push_back({ 0.0, IsoSuggestion::Boundary::Sign, share });
    }
  }
  const double otsu = otsuThreshold(statistics.voxels);
  suggestions.push_back(
    { valueAt(statistics.bins, otsu), IsoSuggestion::Boundary::None, kept[static_cast<std::size_t>(otsu)] });
  return suggestions;
}

} // namespace

template <typename T>
std::vector<IsoSuggestion> suggestIsoValues(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce)
{
  const std::optional<IsoStatistics> statistics = makeIsoStatistics(read, dimensions, slicesAtOnce);
  if (!statistics)
  {
    return {};
  }
  std::vector<IsoSuggestion> suggestions = suggestBoundaries(*statistics, false);
  if (suggestions.empty() && isNoisy(*statistics))
  {
    const SliceReader<double> readSmoothed = smoothedSlices(read, dimensions, slicesAtOnce);
    const std::optional<IsoStatistics> smoothed =
      makeIsoStatistics(readSmoothed, dimensions, countSmoothedAtOnce(dimensions, slicesAtOnce));
    suggestions = smoothed ? suggestBoundaries(*smoothed, true) : suggestions;
  }
  return suggestions.empty() ? suggestThresholds(*statistics) : suggestions;
}

template <typename T>
std::vector<IsoSuggestion> suggestIsoValues(std::span<const T> values, std::array<int, 3> dimensions)
{
  for (int& dimension : dimensions)
  {
    dimension = std::max(dimension, 0);
  }
  const std::size_t sliceSize = static_cast<std::size_t>(dimensions[0]) * dimensions[1];
  if (values.size() != sliceSize * dimensions[2])
  {
    throw std::invalid_argument("suggestIsoValues: " + std::to_string(values.size()) + " values, but " +
      std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
      std::to_string(dimensions[2]) + " voxels");
  }
  const SliceReader<T> read = [&](int first, int last)
  { return values.subspan(sliceSize * first, sliceSize * (last - first)); };
  return suggestIsoValues(read, dimensions, std::max(dimensions[2], 1) + 2);
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::vector<IsoSuggestion> suggestIsoValues(std::span<const T>, std::array<int, 3>);              \
  template std::vector<IsoSuggestion> suggestIsoValues(const SliceReader<T>&, std::array<int, 3>, int);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
