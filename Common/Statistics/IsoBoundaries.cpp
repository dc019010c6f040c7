// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoBoundaries.h"

#include "Statistics/MaterialValues.h"
#include "Statistics/ThresholdSharpness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

namespace ink
{
namespace
{

// A maximum counts if the sharpness falls by this fraction on both sides of it.
constexpr double prominence = 0.1;
// Thresholds around a maximum with this fraction of its sharpness are as good as it is.
constexpr double nearlyAsSharp = 0.8;
// Of these, those with this fraction of the greatest total step leave the surface as whole.
constexpr double nearlyAsLarge = 0.9;
// Thresholds with this fraction of the greatest sharpness lie evenly on both sides of a boundary.
constexpr double asSharp = 0.95;
// So is the lowest boundary without a material above it if it has less than this fraction of the area of the
// surfaces at lower values: smooth fields, such as simulations have, are steepest towards their peaks.
constexpr double fragmentArea = 0.05;
// What intersects more than this fraction of a volume's edges is noise rather than a surface.
constexpr double mostIntersected = 0.125;
// Of the edges of padding more than this fraction begin in its one value; in the field of view noise reaches
// it.
constexpr double paddedShare = 0.25;
// What a material's boundary is sharper than the noise within it, at least.
constexpr double sharperThanInside = 2.0;
// Tissue that has no boundary of its own is steepest where its brightest spots are, of which a surface would
// be scraps: more than this fraction of the edges are at voxels with at most one neighbor inside. Those of
// the outermost boundaries of 80 volumes are up to .14, of the brightest spots of two MR scans and two
// density maps .18 to .23.
constexpr double scrapShare = 0.16;
// Closer to the middle of two materials, by this fraction of their difference, a boundary stays where it is
// sharpest: that makes up for what a point spread takes off from convex parts.
constexpr double farFromMiddle = 0.08;
// Up to so many times the least area of thresholds that are nearly as sharp, a surface is whole. At the
// sharpest, those of four MR heads have 1.4 to 1.8 times, of 26 other volumes up to 1.12.
constexpr double mostArea = 1.25;
// Above the least area around a clear boundary mostArea times as much follows, or more, and so many times
// where none is clear: 1.25 of a FLAIR head.
constexpr double areaAboveUnclear = 1.15;
// Where no mask has cut something out, thresholds with this fraction of its sharpness count, too: heads that
// are a mean of many, and noisy ones, are whole there.
constexpr double stillSharp = 0.7;
// A mask cuts where so many edges begin at it: .13 to .72 of five brains without a skull, at most .055 of
// twelve heads.
constexpr double maskedShare = 0.09;

// What a mask cut out is drawn, not the brightest that is within it, as a tumor or the ventricles of a brain,
// where that keeps less than this fraction of it: .001 to .14 in 11 brains; .31 and more where it is most of
// what the mask left, in 10 others.
constexpr double smallWithinMask = 1.0 / 6.0;
// What is around something within a padded field of view is air, whose values vary by less than this: by
// noise of 60 Hounsfield units, .1.
constexpr double leastVaried = 0.125;

// The first boundary is a haze around another one, as the foam that a head rests on, where its step times
// what it keeps is less than this fraction of the other's: .29 and .41 of two, 1.46 and more of 25 other
// volumes.
constexpr double hazeShare = 0.7;
// What keeps less than this fraction of the voxels of a whole surface below it, which is at least half as
// sharp, are the brightest spots of what that surface is around: fat in MR, the nearer to the coil the
// brighter. Vessels in angiography are sharper than that.
constexpr double brightestKeeps = 0.05;
constexpr double halfAsSharp = 0.5;
// What keeps less than this fraction of the voxels of a surface around it, but no less than the brightest
// spots, is not the outermost either, such as bone, brain and fat within the skin in MR: .08 to .68 of seven
// scans.
constexpr double mostWithin = 0.7;
// Around less than this fraction, as vessels and cells are of what fades, that surface is halfAsSharp.
constexpr double mostBright = 0.4;
// Elsewhere it is so sharp, compared with the other: .3 to .75; of air that varies around two chests, .13.
constexpr double leastSharp = 1.0 / 6.0;
// Its least area is at most so many times as large: 1.9; of lungs within a chest in CT, 2.6.
constexpr double largestAround = 2.0;
// Its threshold is at most this fraction of the other, from the lowest value, as air is the lowest: .26.
constexpr double lowestPart = 0.5;
// It keeps less than this fraction of the volume, which noise fills.
constexpr double mostAround = 0.7;

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

/// The middle of the sharpest thresholds, of those around a maximum of sharpness that are nearly as sharp and
/// have nearly the greatest total step of these; if that is at the edge of them, beside another boundary or
/// noise, the maximum of sharpness itself. The total step alone is greatest on the side where a bent surface
/// has more area.
IsoBoundary placeBoundary(
  const Maximum& maximum, const std::vector<double>& sharpness, const ThresholdEdges& sums)
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

std::vector<IsoBoundary> findBoundaries(
  const ThresholdEdges& sums, const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept)
{
  const std::vector<double> sharp = thresholdSharpness(sums, speckEdges, kept);
  std::vector<IsoBoundary> boundaries;
  for (const Maximum& maximum : prominentMaxima(sharp))
  {
    const IsoBoundary boundary = placeBoundary(maximum, sharp, sums);
    if (boundaries.empty() || boundaries.back().index != boundary.index)
    {
      boundaries.push_back(boundary);
    }
  }
  return boundaries;
}

/// Whether a mask cuts what lies above a threshold.
bool isCutByMask(const IsoStatistics& statistics, std::size_t threshold)
{
  return static_cast<double>(statistics.maskEdges[threshold]) >
    maskedShare * static_cast<double>(statistics.edges[threshold]);
}

/// Whether the values between two thresholds vary as those of tissues do, not as those of air around
/// something or where nothing was found: their middle half, by how far the upper threshold is from their
/// median.
bool isVaried(const std::vector<double>& kept, std::size_t low, std::size_t high)
{
  const auto quantile = [&](double share)
  {
    const double above = kept[low] - share * (kept[low] - kept[high]);
    const auto begin = kept.begin() + static_cast<std::ptrdiff_t>(low);
    const auto end = kept.begin() + static_cast<std::ptrdiff_t>(high);
    const auto found = std::partition_point(begin, end, [&](double one) { return one > above; });
    return static_cast<double>(found - kept.begin());
  };
  return quantile(0.75) - quantile(0.25) >= leastVaried * (static_cast<double>(high) - quantile(0.5));
}

/// Whether a threshold belongs to the peaks of a smooth field.
bool isPeak(const IsoStatistics& statistics, const std::vector<double>& kept, std::size_t threshold)
{
  const ThresholdEdges sums = withoutMasks(statistics);
  const std::vector<bool> noise = findNoisyThresholds(sums.edges, statistics.speckEdges, kept);
  std::int64_t most = 0;
  for (std::size_t i = 0; i < threshold; ++i)
  {
    most = noise[i] ? most : std::max(most, sums.edges[i]);
  }
  // The last bin has all outliers, too.
  const BinRange above{ threshold + 1, statistics.voxels.size() - 1 };
  return static_cast<double>(sums.edges[threshold]) < fragmentArea * static_cast<double>(most) &&
    !areTooMany(most, statistics) && !findMaterialValue(statistics.voxels, above, false);
}

/// Whether the first boundary is a haze around another one.
bool isHaze(const IsoStatistics& statistics, const std::vector<double>& kept,
  const std::vector<IsoBoundary>& boundaries)
{
  const auto weight = [&](const IsoBoundary& one)
  { return meanStep(statistics, one.index) * kept[one.index]; };
  return std::any_of(boundaries.begin() + 1, boundaries.end(),
    [&](const IsoBoundary& other) { return weight(boundaries.front()) < hazeShare * weight(other); });
}

/// Whether the surface at a threshold is drawn, not what it is around.
/// @param edges that cross the threshold of the least area nearby @param inner the lowest boundary
bool isOutermost(const IsoStatistics& statistics, const std::vector<double>& kept, std::size_t threshold,
  std::int64_t edges, const IsoBoundary& inner)
{
  const double part = kept[inner.index] / kept[threshold];
  // What a mask cut out is no vessel within something.
  const bool isCut = isCutByMask(statistics, threshold);
  const double sharpness = isCut || part >= mostBright ? leastSharp : halfAsSharp;
  const bool isSharp = meanStep(statistics, threshold) >= sharpness * meanStep(statistics, inner.index);
  if (part < brightestKeeps)
  {
    return isSharp && !isCut;
  }
  return isSharp && part < (isCut ? smallWithinMask : mostWithin) && kept[threshold] < mostAround &&
    static_cast<double>(threshold) < lowestPart * static_cast<double>(inner.index) &&
    static_cast<double>(edges) <= largestAround * static_cast<double>(statistics.edges[inner.index]);
}

} // namespace

bool areTooMany(std::int64_t edges, const IsoStatistics& statistics)
{
  const std::int64_t voxels =
    std::accumulate(statistics.voxels.begin(), statistics.voxels.end(), std::int64_t{ 0 });
  return static_cast<double>(edges) > mostIntersected * 3.0 * static_cast<double>(voxels);
}

bool isMask(const IsoStatistics& statistics, std::size_t threshold)
{
  return 2 * statistics.maskEdges[threshold] > statistics.edges[threshold];
}

bool isPadding(const IsoStatistics& statistics, std::size_t boundary, std::size_t next)
{
  const std::vector<bool> noise =
    findNoisyThresholds(statistics.edges, statistics.speckEdges, keptShares(statistics.voxels));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = boundary + 1; i < next; ++i)
  {
    least = noise[i] ? std::min(least, meanStep(statistics, i)) : least;
  }
  const double masked =
    static_cast<double>(statistics.maskEdges[0]) / static_cast<double>(statistics.edges[0]);
  return std::isfinite(least) && meanStep(statistics, 0) < sharperThanInside * least && masked > paddedShare;
}

std::vector<IsoBoundary> findBoundaries(const IsoStatistics& statistics, const std::vector<double>& kept)
{
  std::vector<IsoBoundary> boundaries = findBoundaries(withoutMasks(statistics), statistics.speckEdges, kept);
  std::erase_if(boundaries, [&](const IsoBoundary& one) { return isMask(statistics, one.index); });
  const std::size_t unmasked = boundaries.size();
  const bool areScraps = unmasked > 0 && speckShare(statistics, boundaries.front().index) > scrapShare;
  // Of the edge of a mask.
  const auto isLeftOut = [&, front = unmasked > 0 ? boundaries.front().index : 0](std::size_t edge)
  {
    return unmasked > 0 &&
      (areScraps || kept[front] >= smallWithinMask * kept[edge] || !isVaried(kept, edge, front));
  };
  // A mask hides boundaries; without what looks like its edge, others may no longer be prominent.
  for (const IsoBoundary& one :
    findBoundaries({ statistics.edges, statistics.steps }, statistics.speckEdges, kept))
  {
    const bool known = std::any_of(boundaries.begin(), boundaries.end(),
      [&one](const IsoBoundary& other) { return one.contains(other) || other.contains(one); });
    if (!known && !(isMask(statistics, one.index) && isLeftOut(one.index)))
    {
      boundaries.push_back(one);
    }
  }
  std::sort(boundaries.begin(), boundaries.end(),
    [](const IsoBoundary& a, const IsoBoundary& b) { return a.threshold < b.threshold; });
  std::erase_if(boundaries,
    [&, least = boundaries.empty() ? 0.0 : fragmentShare * kept[boundaries.front().index]](
      const IsoBoundary& one) { return kept[one.index] < least; });
  if (boundaries.size() > 1 && isPadding(statistics, boundaries[0].index, boundaries[1].index))
  {
    boundaries.erase(boundaries.begin());
  }
  while (!boundaries.empty() &&
    (isPeak(statistics, kept, boundaries.front().index) ||
      speckShare(statistics, boundaries.front().index) > scrapShare))
  {
    boundaries.erase(boundaries.begin());
  }
  if (boundaries.empty())
  {
    return boundaries;
  }
  if (isHaze(statistics, kept, boundaries))
  {
    boundaries.erase(boundaries.begin());
  }
  else if (const auto around = findSurfaceAround(boundaries.front(), statistics, kept, true))
  {
    boundaries.insert(boundaries.begin(), *around);
  }
  return boundaries;
}

void centerBoundaries(const IsoStatistics& statistics, std::vector<IsoBoundary>& boundaries)
{
  const std::vector<IsoBoundary> found = boundaries;
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

std::optional<IsoBoundary> findSurfaceAround(
  const IsoBoundary& inner, const IsoStatistics& statistics, const std::vector<double>& kept, bool isClear)
{
  const std::vector<bool> noise = findNoisyThresholds(statistics.edges, statistics.speckEdges, kept);
  std::size_t begin = inner.index;
  while (begin > 0 && !noise[begin - 1] && !isMask(statistics, begin - 1))
  {
    --begin;
  }
  // The area is small above the brightest material, too: here more of it follows.
  const std::vector<std::int64_t>& edges = statistics.edges;
  const double valleyArea = isClear ? mostArea : areaAboveUnclear;
  std::size_t least = inner.index;
  std::int64_t hill = 0;
  std::int64_t highest = 0;
  for (std::size_t i = inner.index; i-- > begin; highest = std::max(highest, edges[i]))
  {
    const bool isValley = valleyArea * static_cast<double>(edges[i]) <= static_cast<double>(highest);
    if (isValley && (least == inner.index || edges[i] < edges[least]))
    {
      least = i;
      hill = highest;
    }
  }
  const auto valley = static_cast<double>(edges[least]);
  // A hill that is low is climbed half way, in ratios.
  const double halfway = std::sqrt(valley * static_cast<double>(hill));
  const double most = isClear ? mostArea * valley : std::min(mostArea * valley, halfway);
  std::size_t index = least;
  while (index + 1 < inner.index && static_cast<double>(edges[index + 1]) <= most)
  {
    ++index;
  }
  const bool isWhole = least < inner.index && speckShare(statistics, index) <= scrapShare &&
    !areTooMany(edges[index], statistics) && isOutermost(statistics, kept, index, edges[least], inner);
  if (!isWhole)
  {
    return std::nullopt;
  }
  return IsoBoundary{ static_cast<double>(index), index, static_cast<double>(statistics.steps[index]), index,
    index + 1 };
}

void mendBoundary(const IsoStatistics& statistics, IsoBoundary& boundary)
{
  const std::vector<std::int64_t>& edges = statistics.edges;
  const std::vector<bool> noise =
    findNoisyThresholds(edges, statistics.speckEdges, keptShares(statistics.voxels));
  const double least = stillSharp * meanStep(statistics, boundary.index);
  const bool masked = isCutByMask(statistics, boundary.begin);
  std::size_t lowest = boundary.begin;
  while (!masked && lowest > 0 && !noise[lowest - 1] && meanStep(statistics, lowest - 1) >= least)
  {
    --lowest;
  }
  const auto begin = edges.begin() + static_cast<std::ptrdiff_t>(lowest);
  const auto own = edges.begin() + static_cast<std::ptrdiff_t>(boundary.index);
  const double most = mostArea * static_cast<double>(*std::min_element(begin, own + 1));
  std::size_t whole = boundary.index;
  while (static_cast<double>(edges[whole]) > most)
  {
    --whole;
  }
  if (whole < boundary.index)
  {
    boundary.index = whole;
    boundary.threshold = static_cast<double>(whole);
  }
}

} // namespace ink
