// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoValue.h"

#include "Fields/ScalarDifference.h"
#include "Statistics/AreLabels.h"
#include "Statistics/ChangedSlices.h"
#include "Statistics/CoveredSides.h"
#include "Statistics/FilledBox.h"
#include "Statistics/HounsfieldUnits.h"
#include "Statistics/IsoBoundaries.h"
#include "Statistics/OtsuThreshold.h"
#include "Statistics/SmoothedSlices.h"
#include "Statistics/ThresholdSharpness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ink
{
namespace
{

constexpr std::size_t mostSuggestions = 3;
// What keeps so many times the voxels of another surface lies around it.
constexpr double outerShare = 1.25;
// A side of a volume cuts what covers more than this share of it; of four cropped chests .39 to .99 of each
// side is covered, of 80 other volumes at most .29 of the least covered.
constexpr double cutShare = 1.0 / 3.0;
// What keeps less cannot be cut so on all sides.
constexpr double cutKeeps = 0.5;
// Of what an implicit function's surface encloses, as thin vessels in a box.
constexpr double thinObjectShare = 1e-4;
// Where 0 is the value of so many voxels, it is no surface of an implicit function but what surrounds those
// of a map of differences, as in statistics of a brain.
constexpr double backgroundShare = 0.125;
// The negative differences are as large as so many times the positive ones, at least.
constexpr double leastNegative = 0.25;
// Of fields of both signs that fade to 0, as orbitals, .58 to .88 of the values are within this share of the
// largest.
constexpr double faintValue = 0.01;
constexpr double mostlyFaint = 0.5;
// A field of view is padded with a value that this share of the voxels or more has, and that is so many times
// as low as all others: CT, whose air is around -1000, with -1500 to -3024.
constexpr double paddingShare = 0.01;
constexpr double farBelow = 1.25;
// What keeps this share of the values above the padding may be its edge, or noise: .84 of a chest with noisy
// lungs; the skin in seven other scans keeps up to .51.
constexpr double mostlyMeasured = 2.0 / 3.0;
// Bone is this share of a scan, at least.
constexpr double boneShare = 0.001;
// Otsu's threshold splits what is around something, not that itself, where more than this fraction of the
// volume is above it and the threshold of what is above is so many times as sharp: 2.8 of an angiography,
// at most 1 of six others of which so much is above it.
constexpr double mostOfSomething = 0.5;
constexpr double sharperThanAround = 2.0;
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

/// What a position between bins is as a value.
double valueAt(const ValueBins& bins, double threshold)
{
  return bins.low + (threshold + 1.0) * bins.width;
}

/// The values of both signs below which a field is faint that fades to 0 on all sides of what it has, as an
/// orbital; 0 if it does not.
double faintBelow(const IsoStatistics& statistics, const std::vector<double>& kept)
{
  const ValueBins& bins = statistics.bins;
  const double highest = bins.low + bins.width * bins.count;
  if (!(-bins.low > leastNegative * highest && highest > leastNegative * -bins.low))
  {
    return 0.0;
  }
  const double faint = faintValue * std::max(-bins.low, highest);
  const double share = kept[thresholdAt(bins, -faint)] - kept[thresholdAt(bins, faint)];
  return share > mostlyFaint ? faint : 0.0;
}

/// The iso-values of clear boundaries, the best first.
/// @param noisy of the values themselves, if the others are of smoothed ones
std::vector<IsoSuggestion> suggestBoundaries(
  const IsoStatistics& statistics, const IsoStatistics* noisy = nullptr)
{
  const std::vector<double> kept = keptShares(statistics.voxels);
  std::vector<IsoBoundary> boundaries = findBoundaries(statistics, kept);
  // However steep it is there, no material begins where an orbital changes its sign.
  const double faint = faintBelow(statistics, kept);
  std::erase_if(boundaries,
    [&](const IsoBoundary& one) { return std::abs(valueAt(statistics.bins, one.threshold)) < faint; });
  if (noisy)
  {
    std::erase_if(
      boundaries, [&](const IsoBoundary& one) { return !isSharperThanNoise(statistics, one.index); });
    // Half way from air to lungs, say, there is more noise than skin.
    const auto clean = std::find_if(boundaries.begin(), boundaries.end(),
      [&](const IsoBoundary& one) { return !isSpeckled(*noisy, valueAt(statistics.bins, one.threshold)); });
    boundaries.erase(boundaries.begin(), clean == boundaries.end() ? boundaries.begin() : clean);
    const auto thresholdOf = [&](const IsoBoundary& one)
    { return thresholdAt(noisy->bins, valueAt(statistics.bins, one.threshold)); };
    // Smoothed noise looks like a material.
    if (boundaries.size() > 1 && isPadding(*noisy, thresholdOf(boundaries[0]), thresholdOf(boundaries[1])))
    {
      boundaries.erase(boundaries.begin());
    }
  }
  if (boundaries.empty())
  {
    return {};
  }
  centerBoundaries(statistics, boundaries);
  mendBoundary(statistics, boundaries.front());
  const double densest = boundaries.back().threshold;
  std::stable_sort(boundaries.begin() + 1, boundaries.end(),
    [](const IsoBoundary& a, const IsoBoundary& b) { return a.totalStep > b.totalStep; });
  boundaries.resize(std::min(boundaries.size(), mostSuggestions));
  std::vector<IsoSuggestion> suggestions;
  for (const IsoBoundary& one : boundaries)
  {
    const IsoSuggestion::Boundary kind = suggestions.empty() ? IsoSuggestion::Boundary::Outermost
      : one.threshold == densest                             ? IsoSuggestion::Boundary::Densest
                                                             : IsoSuggestion::Boundary::Inner;
    const double value = valueAt(statistics.bins, one.threshold);
    suggestions.push_back({ value, kind, kept[one.index], 0, faint > 0.0 && value > 0.0 });
  }
  return suggestions;
}

/// Whether the first of some suggestions, of smoothed values, is a surface around that of others.
bool showsMore(const std::vector<IsoSuggestion>& smoothed, const std::vector<IsoSuggestion>& suggestions,
  const IsoStatistics& statistics)
{
  return !smoothed.empty() && !isSpeckled(statistics, smoothed.front().value) &&
    smoothed.front().keptShare > outerShare * suggestions.front().keptShare;
}

/// Whether values are labels, see areLabels.
bool hasLabels(const IsoStatistics& statistics)
{
  if (!areLabels(statistics.maskChanges, statistics.changes))
  {
    return false;
  }
  // A change of some levels crosses as many thresholds, of which those within a gap are one.
  double levels = 0.0;
  double crossed = 0.0;
  for (std::size_t i = 0; i < statistics.edges.size(); ++i)
  {
    const bool isLevel = statistics.voxels[i] > 0;
    levels += isLevel ? 1.0 : 0.0;
    crossed += isLevel ? static_cast<double>(statistics.edges[i]) : 0.0;
  }
  return !areGrayLevels(levels, crossed / static_cast<double>(statistics.changes));
}

/// Counts different values, with memory for a few times as many.
template <typename T>
class DifferentValues
{
public:
  void add(T value)
  {
    if (!this->Values.empty() && value == this->Values.back())
    {
      return;
    }
    if (this->Values.size() == this->Most)
    {
      this->count();
      this->Most = std::max(this->Most, 2 * this->Values.size());
    }
    this->Values.push_back(value);
  }
  std::int64_t count()
  {
    std::sort(this->Values.begin(), this->Values.end());
    this->Values.erase(std::unique(this->Values.begin(), this->Values.end()), this->Values.end());
    return static_cast<std::int64_t>(this->Values.size());
  }

private:
  std::vector<T> Values;
  std::size_t Most = 1 << 16;
};

/// The edge of all labels, if values are labels: exactly, as the ids of atlases lie far apart.
template <typename T>
std::optional<IsoSuggestion> suggestLabels(
  const SliceReader<T>& read, int slices, int slicesAtOnce, const IsoStatistics& statistics)
{
  if (!hasLabels(statistics))
  {
    return std::nullopt;
  }
  const double low = statistics.bins.low;
  const double background = std::is_integral_v<T> ? std::ceil(low) : low;
  double next = std::numeric_limits<double>::infinity();
  std::int64_t finite = 0;
  std::int64_t kept = 0;
  DifferentValues<T> different;
  for (int first = 0; first < slices; first += slicesAtOnce)
  {
    for (const T value : read(first, std::min(first + slicesAtOnce, slices)))
    {
      const auto v = static_cast<double>(value);
      const bool isFinite = std::isfinite(v);
      const bool isKept = isFinite && v > background;
      finite += isFinite ? 1 : 0;
      kept += isKept ? 1 : 0;
      if (isKept)
      {
        next = std::min(next, v);
        different.add(value);
      }
    }
  }
  return IsoSuggestion{ std::midpoint(background, next), IsoSuggestion::Boundary::Labels,
    static_cast<double>(kept) / static_cast<double>(finite), different.count() };
}

/// Whether each side of a volume cuts what lies above a value, as where a scan of a chest was cropped: what
/// is seen of its surface then is the inside of the lungs.
template <typename T>
bool isCutOnAllSides(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce, double value)
{
  const std::array<double, 6> sides = coveredSides(read, dimensions, slicesAtOnce, value);
  return std::all_of(sides.begin(), sides.end(), [](double share) { return share > cutShare; });
}

/// Whether values change as fast at a threshold as elsewhere, as signed distances do, but not values that end
/// there and swing a little beyond.
bool isAsSteepAsElsewhere(const IsoStatistics& statistics, std::size_t threshold)
{
  const auto sum = [](const std::vector<std::int64_t>& counts)
  { return std::accumulate(counts.begin(), counts.end(), 0.0); };
  const double here = static_cast<double>(statistics.steps[threshold]) * sum(statistics.edges);
  const double elsewhere = sum(statistics.steps) * static_cast<double>(statistics.edges[threshold]);
  return here > 0.5 * elsewhere;
}

/// Otsu's threshold of the values from a bin on, or one below it where the surface is whole, see
/// findSurfaceAround and mendBoundary.
/// @param first the lowest bin
IsoBoundary splitHistogram(
  const IsoStatistics& statistics, const std::vector<double>& kept, std::size_t first)
{
  const auto otsuFrom = [&](std::size_t bin)
  {
    std::vector<std::int64_t> above = statistics.voxels;
    std::fill_n(above.begin(), bin, 0);
    return otsuThreshold(above);
  };
  const auto indexOf = [](double threshold) { return static_cast<std::size_t>(threshold); };
  const auto isNoise = [&](double threshold)
  { return areTooMany(statistics.edges[indexOf(threshold)], statistics); };
  const auto sharpness = [&](double threshold) { return meanStep(statistics, indexOf(threshold)); };
  double otsu = otsuFrom(first);
  // Where it splits what is around something, that may be what is above.
  const double higher = otsuFrom(indexOf(otsu) + 1);
  const bool isAround =
    kept[indexOf(otsu)] > mostOfSomething && sharpness(higher) > sharperThanAround * sharpness(otsu);
  // 0 where nothing is above to be split.
  if (higher > otsu && !isNoise(higher) && (isAround || isNoise(otsu)))
  {
    otsu = higher;
  }
  const std::size_t index = indexOf(otsu);
  IsoBoundary split{ otsu, index, 0.0, index, index + 1 };
  const std::vector<bool> noise = findNoisyThresholds(statistics.edges, statistics.speckEdges, kept);
  while (split.begin > first && !noise[split.begin] && !noise[split.begin - 1])
  {
    --split.begin;
  }
  // Of the positive values the negative ones are not around.
  const auto around = first == 0 ? findSurfaceAround(split, statistics, kept, false) : std::nullopt;
  if (around)
  {
    return *around;
  }
  mendBoundary(statistics, split);
  return split;
}

/// Whether values are differences around a background of 0, at the end of a bin.
bool areDifferences(const IsoStatistics& statistics, const std::vector<double>& kept, std::size_t zero)
{
  const double highest = statistics.bins.low + statistics.bins.width * statistics.bins.count;
  return zero + 1 < kept.size() && kept[zero] - kept[zero + 1] > backgroundShare &&
    kept[zero + 1] > fragmentShare && -statistics.bins.low > leastNegative * highest;
}

/// Of a volume without a boundary.
/// @param integers whether values are, which scans have, implicit functions hardly ever
std::vector<IsoSuggestion> suggestThresholds(const IsoStatistics& statistics, bool integers)
{
  const std::vector<double> kept = keptShares(statistics.voxels);
  std::vector<IsoSuggestion> suggestions;
  std::size_t first = 0;
  const double zero = std::floor(-statistics.bins.low / statistics.bins.width) - 1.0;
  if (zero >= 0.0 && zero < static_cast<double>(kept.size()))
  {
    const auto threshold = static_cast<std::size_t>(zero);
    const double share = kept[threshold];
    const double least =
      !integers && isAsSteepAsElsewhere(statistics, threshold) ? thinObjectShare : fragmentShare;
    if (areDifferences(statistics, kept, threshold) || faintBelow(statistics, kept) > 0.0)
    {
      first = threshold + 2;
    }
    // Values around 0, as those of densities of crystals, have no surface there.
    else if (share >= least && share <= 1.0 - least && !areTooMany(statistics.edges[threshold], statistics))
    {
      suggestions.push_back({ 0.0, IsoSuggestion::Boundary::Sign, share });
    }
  }
  const IsoBoundary split = splitHistogram(statistics, kept, first);
  suggestions.push_back({ valueAt(statistics.bins, split.threshold), IsoSuggestion::Boundary::None,
    kept[split.index], 0, first > 0 });
  return suggestions;
}

/// Whether a suggestion is the boundary between two materials.
bool isClear(const IsoSuggestion& suggestion)
{
  using Boundary = IsoSuggestion::Boundary;
  return suggestion.boundary == Boundary::Outermost || suggestion.boundary == Boundary::Inner ||
    suggestion.boundary == Boundary::Densest;
}

/// The least value that is measured, where a field of view is padded with one that is far below it, as -3024
/// below air in CT.
std::optional<double> findLeastMeasured(const IsoStatistics& statistics)
{
  const std::vector<std::int64_t>& voxels = statistics.voxels;
  const double all = std::accumulate(voxels.begin(), voxels.end(), 0.0);
  const auto next = std::find_if(voxels.begin() + 1, voxels.end(), [](std::int64_t n) { return n > 0; });
  const double least =
    statistics.bins.low + statistics.bins.width * static_cast<double>(next - voxels.begin());
  const bool isPadded = static_cast<double>(voxels[0]) > paddingShare * all &&
    statistics.bins.low < farBelow * least && least < 0.0;
  return isPadded ? std::optional(least) : std::nullopt;
}

/// Whatever surrounds the volume.
template <typename T>
std::vector<IsoSuggestion> suggestOf(const SliceReader<T>& read, const std::array<int, 3>& dimensions,
  int slicesAtOnce, const IsoStatistics& statistics)
{
  if (const std::optional<IsoSuggestion> labels =
        suggestLabels(read, dimensions[2], slicesAtOnce, statistics))
  {
    return { *labels };
  }
  std::vector<IsoSuggestion> suggestions = suggestBoundaries(statistics);
  if (noiseHidesBoundaries(statistics))
  {
    const SliceReader<double> readSmoothed = smoothedSlices(read, dimensions, slicesAtOnce);
    const std::optional<IsoStatistics> smoothed =
      makeIsoStatistics(readSmoothed, dimensions, countSmoothedAtOnce(dimensions, slicesAtOnce));
    const std::vector<IsoSuggestion> others =
      smoothed ? suggestBoundaries(*smoothed, &statistics) : std::vector<IsoSuggestion>();
    suggestions = suggestions.empty() || showsMore(others, suggestions, statistics) ? others : suggestions;
  }
  if (suggestions.size() > 1 && suggestions.front().keptShare > cutKeeps &&
    isCutOnAllSides(read, dimensions, slicesAtOnce, suggestions.front().value))
  {
    // What keeps nearly as much is cut as well.
    const auto within = std::find_if(suggestions.begin() + 1, suggestions.end(),
      [&](const IsoSuggestion& one) { return outerShare * one.keptShare < suggestions.front().keptShare; });
    if (within != suggestions.end())
    {
      std::rotate(suggestions.begin(), within, within + 1);
    }
  }
  return suggestions.empty() ? suggestThresholds(statistics, std::is_integral_v<T>) : suggestions;
}

/// Of what padding surrounds on some sides with the lowest value: the boundaries within, if there are any.
template <typename T>
std::vector<IsoSuggestion> suggestWithinPadding(const SliceReader<T>& read,
  const std::array<int, 3>& dimensions, int slicesAtOnce, const IsoStatistics& statistics)
{
  constexpr double mostlyMasked = 0.5;
  const double edges = static_cast<double>(statistics.edges[0]);
  if (static_cast<double>(statistics.maskEdges[0]) <= mostlyMasked * edges || hasLabels(statistics))
  {
    return {};
  }
  const auto box = findFilledBox(read, dimensions, slicesAtOnce, valueAt(statistics.bins, -0.5));
  if (!box)
  {
    return {};
  }
  const std::array<int, 3> size{ (*box)[1] - (*box)[0] + 1, (*box)[3] - (*box)[2] + 1,
    (*box)[5] - (*box)[4] + 1 };
  // Of what is cropped there is a copy.
  const int atOnce = countSmoothedAtOnce(dimensions, slicesAtOnce);
  const auto cropped = croppedSlices(read, dimensions, *box);
  const std::optional<IsoStatistics> within = makeIsoStatistics(cropped, size, atOnce);
  std::vector<IsoSuggestion> suggestions =
    within ? suggestOf(cropped, size, atOnce, *within) : std::vector<IsoSuggestion>();
  if (suggestions.empty() || !isClear(suggestions.front()))
  {
    return {};
  }
  const std::vector<double> kept = keptShares(statistics.voxels);
  for (IsoSuggestion& one : suggestions)
  {
    one.keptShare = kept[thresholdAt(statistics.bins, one.value)];
  }
  return suggestions;
}

/// Where a field of view is padded: the boundaries of what is measured, in place of some that lie around
/// them, if the first is not just the padding's edge.
template <typename T>
std::vector<IsoSuggestion> withinFieldOfView(std::vector<IsoSuggestion> suggestions,
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce,
  const IsoStatistics& statistics)
{
  const std::optional<double> least = findLeastMeasured(statistics);
  const double measuredShare = keptShares(statistics.voxels).front();
  if (!least || suggestions.front().keptShare < mostlyMeasured * measuredShare)
  {
    return suggestions;
  }
  // Of what is raised there is a copy.
  const int atOnce = countSmoothedAtOnce(dimensions, slicesAtOnce);
  const SliceReader<T> raised = raisedSlices(read, *least);
  const std::optional<IsoStatistics> measured = makeIsoStatistics(raised, dimensions, atOnce);
  std::vector<IsoSuggestion> within =
    measured ? suggestOf(raised, dimensions, atOnce, *measured) : std::vector<IsoSuggestion>();
  const bool isAround = !within.empty() && isClear(within.front()) &&
    suggestions.front().keptShare > outerShare * within.front().keptShare;
  return isAround && !isMask(*measured, thresholdAt(measured->bins, within.front().value)) ? within
                                                                                           : suggestions;
}

/// In CT, puts bone second if no boundary is as dense.
void addBone(const IsoStatistics& statistics, std::vector<IsoSuggestion>& suggestions)
{
  constexpr double bone = 200.0;
  constexpr double asDense = 100.0;
  const ValueBins& bins = statistics.bins;
  const bool isFound = std::any_of(
    suggestions.begin(), suggestions.end(), [](const IsoSuggestion& one) { return one.value > asDense; });
  if (isFound || suggestions.empty() || !isClear(suggestions.front()) ||
    bone >= bins.low + bins.width * bins.count || !areHounsfieldUnits(statistics))
  {
    return;
  }
  const double share = keptShares(statistics.voxels)[thresholdAt(bins, bone)];
  if (share > boneShare)
  {
    suggestions.insert(suggestions.begin() + 1, { bone, IsoSuggestion::Boundary::Bone, share });
    suggestions.resize(std::min(suggestions.size(), mostSuggestions));
  }
}

} // namespace

template <typename T>
std::vector<IsoSuggestion> suggestIsoValues(
  const SliceReader<T>& readAll, std::array<int, 3> dimensions, int slicesAtOnce)
{
  const std::optional<IsoStatistics> statistics = makeIsoStatistics(readAll, dimensions, slicesAtOnce);
  if (!statistics)
  {
    return {};
  }
  const SliceReader<T> read = withoutFill(readAll, statistics->bins.fill);
  std::vector<IsoSuggestion> suggestions = suggestWithinPadding(read, dimensions, slicesAtOnce, *statistics);
  if (suggestions.empty())
  {
    suggestions = withinFieldOfView(
      suggestOf(read, dimensions, slicesAtOnce, *statistics), read, dimensions, slicesAtOnce, *statistics);
  }
  addBone(*statistics, suggestions);
  return suggestions;
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

void preferInner(std::vector<IsoSuggestion>& suggestions)
{
  // The others follow the outermost from the clearest on.
  if (suggestions.size() > 1 && suggestions.front().boundary == IsoSuggestion::Boundary::Outermost)
  {
    std::swap(suggestions[0], suggestions[1]);
  }
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::vector<IsoSuggestion> suggestIsoValues(std::span<const T>, std::array<int, 3>);              \
  template std::vector<IsoSuggestion> suggestIsoValues(const SliceReader<T>&, std::array<int, 3>, int);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
