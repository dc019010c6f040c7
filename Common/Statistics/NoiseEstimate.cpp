// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/NoiseEstimate.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Resampling/SliceDistances.h"
#include "Statistics/AreLabels.h"
#include "Statistics/NoiseSampler.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace ink
{
namespace
{

/// The median magnitude of a normal distribution of deviation 1.
constexpr double normalMedian = 0.6744897501960817;

/// Fewer neighborhoods on one side of the surface, or a smaller share of those on the other, do not tell its
/// noise: they lie at edges.
constexpr std::size_t fewest = 64;
constexpr double leastShare = 0.1;

/// The share of positions that may be thinner than the thickness: lines that touch a ball hardly cross it,
/// too.
constexpr double thinShare = 0.1;
constexpr double usuallyThinShare = 0.25;

/// Keeps a single sample.
constexpr double leastKeeping = 0.5;

/// Of atlases that are fit to be drawn the most is .11, of tissues that are not the least .13; see
/// NoiseEstimate::raggedBorders.
constexpr double mostRaggedBorders = 0.12;

/// By how many deviations noise makes the range of so many samples across a blurred edge larger, as a median.
constexpr double noiseRange = 0.4;

/// What noise may turn normals by, in radians; measured on pictures of phantoms
/// (Documentation/picture-quality.md).
constexpr double largestAngle = 0.02;
constexpr double leastSmoothing = 0.3; ///< less does not show
constexpr double pointSpread = 0.7;

/// The noise that steps of one gray level count as.
constexpr double terraceWeight = 1.5;

/// Longer voxels show their slices.
constexpr double leastAnisotropy = 1.1;
/// Of their length. With half of it, a head's crown has a ring around each slice; with .8 its eyelids blur.
constexpr double sliceShare = 2.0 / 3.0;
/// Slices show everywhere, so a few thin parts, as a head's ears, do not ask for less; with 2, a horse in
/// slices of 3 loses its ears and hooves.
constexpr double fewThinParts = 1.65;
/// Slices further apart than this, in voxels, that hardly blur into each other show as stairs more than parts
/// show what they lose, as on foreheads in MR with slices of 7 mm: of the step .55 to .65 lies between two
/// slices there, of phantoms with a point spread of .7 slices .48 to .51.
constexpr double farSlices = 3.0;
constexpr double blurredSlices = 0.5;
constexpr double sharpSlices = 0.55;
constexpr double mostSliceSmoothing = 4.0;
/// Where contours are interpolated, what is rough within slices is drawn out between them: with 2, foreheads
/// in slices of 7 and 14 times the voxels' width have whiskers.
constexpr double mostShapeSmoothing = 3.0;
/// Where values between slices are what interpolation says, half of an edge lies inside as a median: .43 to
/// .52 in phantoms whose slices blur into each other, .61 to .81 where foreheads have rings.
constexpr double mostInnerShare = 0.58;
/// From so many times as far apart on, slices of scans are sharp, and contours the better guess.
constexpr double farShapes = 4.0;

/// Steps of scans are not that sharp, see NoiseEstimate::sharpness.
constexpr double leastSharpness = 0.55;

/// Of brains that a mask cuts through, see NoiseEstimate::cut.
constexpr double leastCut = 0.45;

/// What is rough from sample to sample, see NoiseEstimate::roughness: its angle, and that in angles of bends.
/// Phantoms that are as rough have noise of 10 % of their step, which asks for more.
constexpr double leastRoughness = 0.165;
constexpr double leastRoughnessInBends = 2.1;
/// What hardly bends shows less: of samples that were picked from finer ones, a chest of 64 x 64 voxels, .12.
/// That of noise, 1.5 to 3.2 times its share of the step in phantoms, is left out.
constexpr double leastSmoothRoughness = 0.087;
constexpr double leastSmoothRoughnessInBends = 4.0;
constexpr double roughnessOfNoise = 3.0;
/// Smooth surfaces are no rougher than this, as an angle and in angles of bends (a ball behind a point spread
/// of .6, .05); what is rougher is noise that turns normals by this much, for noise of a whole step: 1.5
/// to 3.2 of that in phantoms.
constexpr double mostSmoothRoughness = 0.06;
constexpr double mostSmoothRoughnessInBends = 2.0;
constexpr double turnOfNoise = 1.7;

/// Whether it asks for smoothing.
bool isRough(const NoiseEstimate& estimate)
{
  const double without = estimate.roughness - roughnessOfNoise * estimate.noise / estimate.step;
  return estimate.roughness > std::max(leastRoughness, leastRoughnessInBends * estimate.bend) ||
    without > std::max(leastSmoothRoughness, leastSmoothRoughnessInBends * estimate.bend);
}

/// The deviation of a normal's angle at a blurred unit step, for noise of deviation 1: the deviation of a
/// derivative of noise under a Gaussian, by the step's own.
double angleOf(double deviation)
{
  const double pi = std::acos(-1.0);
  const double noise = std::sqrt(1.0 / (16.0 * std::pow(pi, 1.5) * std::pow(deviation, 5.0)));
  return noise * std::sqrt(2.0 * pi * (pointSpread * pointSpread + deviation * deviation));
}

/// The noise, as a share of the step, that turns the surface's normals as much as it is rougher than it
/// bends. Second differences hardly see noise that neighbors share, as in MR that was reconstructed on a
/// finer grid: .023 of a face's step, of which this is .079.
double noiseOfRoughness(const NoiseEstimate& estimate)
{
  const double smooth = std::max(mostSmoothRoughness, mostSmoothRoughnessInBends * estimate.bend);
  return std::sqrt(std::max(estimate.roughness * estimate.roughness - smooth * smooth, 0.0)) / turnOfNoise;
}

/// The least with which noise, as a share of the step, turns normals no further than largestAngle.
double deviationFor(double ratio)
{
  if (ratio * angleOf(leastSmoothing) <= largestAngle)
  {
    return 0.0;
  }
  double low = leastSmoothing;
  double high = mostSuggestedSmoothing;
  for (int n = 0; n < 40; ++n)
  {
    const double middle = 0.5 * (low + high);
    (ratio * angleOf(middle) > largestAngle ? low : high) = middle;
  }
  return high;
}

/// Changes the order of numbers. 0 for none.
double quantileOf(std::vector<double>& numbers, double share)
{
  if (numbers.empty())
  {
    return 0.0;
  }
  const auto at =
    numbers.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(numbers.size() - 1));
  std::nth_element(numbers.begin(), at, numbers.end());
  return *at;
}

/// The difference between neighboring gray levels, from changes between neighboring samples: nearly the
/// smallest, if nearly all that are not much larger are multiples of it. Changes their order.
double quantumOf(std::vector<double>& changes)
{
  const double quantum = quantileOf(changes, 0.01);
  constexpr double largest = 16.0;
  constexpr double tolerance = 0.02;
  std::size_t small = 0;
  std::size_t multiples = 0;
  for (const double change : changes)
  {
    const double ratio = change / quantum;
    if (ratio < largest)
    {
      ++small;
      multiples += std::abs(ratio - std::round(ratio)) < tolerance;
    }
  }
  return static_cast<double>(multiples) > 0.9 * static_cast<double>(small) ? quantum : 0.0;
}

/// See areGrayLevels, of which as many are known as there are different changes.
bool haveGrayLevels(const std::vector<double>& changes, double quantum)
{
  if (quantum == 0.0)
  {
    return false;
  }
  std::set<double> different;
  double sum = 0.0;
  for (const double change : changes)
  {
    const double levels = std::round(change / quantum);
    different.insert(levels);
    sum += levels;
  }
  return areGrayLevels(
    1.0 + static_cast<double>(different.size()), sum / static_cast<double>(changes.size()));
}

/// Along axes of one or two samples there are no second differences.
glm::ivec3 reachIn(const glm::ivec3& size)
{
  return { size.x > 2, size.y > 2, size.z > 2 };
}

/// Some slices of a grid, by their indices in the whole.
template <class T>
struct HeldSlices
{
  GridField<T> field;
  int first;

  glm::ivec3 inField(const glm::ivec3& sample) const
  {
    return { sample.x, sample.y, sample.z - this->first };
  }
  bool has(const glm::ivec3& sample) const { return this->field.has(this->inField(sample)); }
  T at(const glm::ivec3& sample) const { return this->field.at(this->inField(sample)); }
};

/// Which samples of a grid are looked at: every so many along a row, shifted from row to row, without those
/// at the border.
class SampledRows
{
public:
  explicit SampledRows(const glm::ivec3& size)
    : Reach(reachIn(size))
    , Inside(glm::max(size - 2 * this->Reach, 0))
    , Every(noiseStride(static_cast<double>(size.x) * size.y * size.z))
  {
  }

  const glm::ivec3& reach() const { return this->Reach; }
  /// The slices with samples to look at, from reach().z on.
  int slices() const { return this->Inside.z; }

  /// Looks at those of slices `begin` to `end` - 1 of these.
  template <class Samples>
  void look(
    const Samples& samples, double isoValue, int begin, int end, std::span<NoiseSightings> found) const
  {
    const NoiseSampler<Samples> sampler(samples, isoValue, this->Reach);
    parallelFor(static_cast<std::size_t>(end - begin),
      [&](std::size_t n)
      {
        const std::size_t slice = static_cast<std::size_t>(begin) + n;
        std::size_t row = slice * static_cast<std::size_t>(this->Inside.y);
        for (int j = 0; j < this->Inside.y; ++j, ++row)
        {
          const auto width = static_cast<std::size_t>(this->Inside.x);
          for (std::size_t i = row * 7919 % this->Every; i < width; i += this->Every)
          {
            sampler.look(this->Reach + glm::ivec3(i, j, slice), found[slice]);
          }
        }
      });
  }

private:
  glm::ivec3 Reach;
  glm::ivec3 Inside;
  std::size_t Every;
};

} // namespace

double keepingDeviation(const glm::dvec3& size)
{
  constexpr double kept = 0.75;
  const auto keeps = [&](double deviation)
  {
    double value = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      value *= std::erf(0.5 * size[axis] / (std::sqrt(2.0) * deviation));
    }
    return value >= kept;
  };
  double low = 0.0;
  double high = 2.0 * mostSuggestedSmoothing;
  const auto isLarge = [](double length) { return std::isinf(length); };
  if (isLarge(size.x) + isLarge(size.y) + isLarge(size.z) > 1 || keeps(high))
  {
    return std::numeric_limits<double>::infinity();
  }
  for (int n = 0; n < 20; ++n)
  {
    const double middle = 0.5 * (low + high);
    (keeps(middle) ? low : high) = middle;
  }
  return low;
}

void NoiseSightings::append(const NoiseSightings& other)
{
  const auto add = [](std::vector<double>& to, const std::vector<double>& from)
  { to.insert(to.end(), from.begin(), from.end()); };
  add(this->differences[0], other.differences[0]);
  add(this->differences[1], other.differences[1]);
  add(this->changes, other.changes);
  add(this->steps, other.steps);
  for (std::size_t axis = 0; axis < this->edgeShares.size(); ++axis)
  {
    add(this->edgeShares[axis], other.edgeShares[axis]);
    add(this->innerShares[axis], other.innerShares[axis]);
  }
  add(this->runs, other.runs);
  add(this->outerRuns, other.outerRuns);
  add(this->keeping, other.keeping);
  this->maskChanges += other.maskChanges;
  this->maskSteps += other.maskSteps;
  this->outerSteps += other.outerSteps;
  this->cutSteps += other.cutSteps;
  this->borders += other.borders;
  this->raggedBorders += other.raggedBorders;
  add(this->turns[0], other.turns[0]);
  add(this->turns[1], other.turns[1]);
}

NoiseEstimate makeNoiseEstimate(std::span<const NoiseSightings> parts, const glm::ivec3& reach)
{
  NoiseSightings all;
  for (const NoiseSightings& some : parts)
  {
    all.append(some);
  }
  // Of a neighborhood's sum, for noise of deviation 1.
  const double deviationOfSum = std::pow(6.0, 0.5 * (reach.x + reach.y + reach.z));
  NoiseEstimate result;
  std::array<double, 2> variances = {};
  int sides = 0;
  const std::size_t most = std::max(all.differences[0].size(), all.differences[1].size());
  for (std::vector<double>& differences : all.differences)
  {
    if (differences.size() >= fewest &&
      static_cast<double>(differences.size()) >= leastShare * static_cast<double>(most))
    {
      const double deviation = quantileOf(differences, 0.5) / normalMedian / deviationOfSum;
      variances[static_cast<std::size_t>(sides++)] = deviation * deviation;
    }
  }
  result.noise = sides == 0 ? 0.0 : std::sqrt((variances[0] + variances[1]) / sides);
  result.quantum = quantumOf(all.changes);
  result.labels = (areLabels(all.maskChanges, static_cast<std::int64_t>(all.changes.size())) &&
                    !haveGrayLevels(all.changes, result.quantum)) ||
    areLabels(all.maskSteps, static_cast<std::int64_t>(all.steps.size()));
  std::vector<double> edgeShares;
  for (std::size_t axis = 0; axis < all.edgeShares.size(); ++axis)
  {
    std::vector<double>& along = all.edgeShares[axis];
    edgeShares.insert(edgeShares.end(), along.begin(), along.end());
    result.sharpnessAlong[axis] = quantileOf(along, 0.5);
    result.innerShareAlong[axis] = quantileOf(all.innerShares[axis], 0.5);
  }
  result.sharpness = quantileOf(edgeShares, 0.5);
  if (all.outerSteps >= static_cast<std::int64_t>(fewest))
  {
    result.cut = static_cast<double>(all.cutSteps) / static_cast<double>(all.outerSteps);
  }
  if (all.borders >= static_cast<std::int64_t>(fewest))
  {
    result.raggedBorders = static_cast<double>(all.raggedBorders) / static_cast<double>(all.borders);
  }
  if (all.turns[0].size() >= fewest)
  {
    result.roughness = quantileOf(all.turns[0], 0.5);
    result.bend = quantileOf(all.turns[1], 0.5);
  }
  result.step = std::max(quantileOf(all.steps, 0.5) - noiseRange * result.noise, 0.0);
  // What is inside is not seen.
  std::vector<double>& runs = all.outerRuns.size() >= fewest ? all.outerRuns : all.runs;
  if (!runs.empty())
  {
    result.thickness = quantileOf(runs, thinShare);
    result.usualThickness = quantileOf(runs, usuallyThinShare);
  }
  // What is seen of a cavity only through gaps is not what is to be kept.
  const double crossings = 0.5 * static_cast<double>(all.runs.size());
  if (all.keeping.size() >= fewest && static_cast<double>(all.keeping.size()) >= leastShare * crossings)
  {
    result.keeping = std::max(quantileOf(all.keeping, thinShare), leastKeeping);
  }
  return result;
}

template <class T>
NoiseEstimate estimateNoise(const GridField<T>& field, double isoValue)
{
  const SampledRows rows(field.geometry().dimensions());
  std::vector<NoiseSightings> found(static_cast<std::size_t>(rows.slices()));
  rows.look(field, isoValue, 0, rows.slices(), found);
  return makeNoiseEstimate(found, rows.reach());
}

template <class T>
NoiseEstimate estimateNoise(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce, double isoValue)
{
  const glm::ivec3 size(dimensions[0], dimensions[1], dimensions[2]);
  using Sampler = NoiseSampler<HeldSlices<T>>;
  static_assert(Sampler::before + 1 + Sampler::behind == NoiseEstimate::slices);
  if (slicesAtOnce < std::min(NoiseEstimate::slices, size.z))
  {
    throw std::invalid_argument("estimateNoise: " + std::to_string(slicesAtOnce) +
      " slices at a time, expected " + std::to_string(NoiseEstimate::slices) + " or more");
  }
  const SampledRows rows(size);
  std::vector<NoiseSightings> found(static_cast<std::size_t>(rows.slices()));
  const int atOnce =
    slicesAtOnce >= size.z ? rows.slices() : slicesAtOnce - Sampler::before - Sampler::behind;
  for (int begin = 0; begin < rows.slices(); begin += atOnce)
  {
    const int end = std::min(begin + atOnce, rows.slices());
    const int first = std::max(begin + rows.reach().z - Sampler::before, 0);
    const int last = std::min(end + rows.reach().z + Sampler::behind, size.z);
    const HeldSlices<T> slices{
      GridField<T>(GridGeometry({ size.x, size.y, last - first }), read(first, last)), first
    };
    rows.look(slices, isoValue, begin, end, found);
  }
  return makeNoiseEstimate(found, rows.reach());
}

double suggestSmoothing(const NoiseEstimate& estimate, const glm::dvec3& spacing, bool shapeBased)
{
  // What half a sample smooths still shows the samples.
  const double thickness = estimate.thickness < 2.0 ? estimate.usualThickness : estimate.thickness;
  const glm::dvec3 size = glm::abs(spacing);
  const double longest = std::max({ size.x, size.y, size.z });
  const double shortest = std::min({ size.x, size.y, size.z });
  const double anisotropy = longest / shortest;
  const double middle = (size.x + size.y + size.z - longest - shortest) / shortest;
  const bool hasSlices = anisotropy > leastAnisotropy;
  const bool hasShapes = shapeBased && thickSlices(spacing);
  double deviation = 0.0;
  if (estimate.labels)
  {
    // Without a surface there is nothing to smooth.
    deviation =
      estimate.step > 0.0 ? std::min({ mostSuggestedSmoothing, 0.5 * thickness, estimate.keeping }) : 0.0;
    const double most = hasShapes ? mostSuggestedSmoothing : mostSliceSmoothing;
    return hasSlices ? std::max(deviation, std::min(anisotropy, most)) : deviation;
  }
  if (estimate.step > 0.0)
  {
    // Noise hides the steps of gray levels; without it their edges are long, and smoothing has to reach
    // further.
    const double terraces = terraceWeight * std::max(estimate.quantum - estimate.noise, 0.0);
    deviation = std::max(deviationFor(estimate.noise / estimate.step),
      std::min(deviationFor((estimate.noise + terraces) / estimate.step), 0.5 * estimate.thickness));
    deviation = std::max(deviation,
      std::min({ deviationFor(noiseOfRoughness(estimate)), sharpSmoothing, 0.5 * estimate.usualThickness }));
    // Thin parts that a mask has cut to pieces would lose their outlines.
    const bool isCut = estimate.cut > leastCut && estimate.usualThickness >= NoiseEstimate::thickEnough;
    if (estimate.sharpness > leastSharpness || isCut || isRough(estimate))
    {
      deviation =
        std::max(deviation, std::min(middle * std::min(sharpSmoothing, 0.5 * thickness), mostSliceSmoothing));
    }
  }
  if (hasSlices)
  {
    const int axis = size.x == longest ? 0 : size.y == longest ? 1 : 2;
    const double sharpness = estimate.sharpnessAlong[static_cast<std::size_t>(axis)];
    const double stairs = std::clamp((sharpness - blurredSlices) / (sharpSlices - blurredSlices), 0.0, 1.0);
    const double whole = std::min(mostSuggestedSmoothing, 0.5 * estimate.thickness);
    const bool isThick = estimate.usualThickness >= NoiseEstimate::thickEnough;
    const double most =
      (isThick ? std::max(whole, fewThinParts) : whole) + stairs * std::max(anisotropy - farSlices, 0.0);
    deviation = std::max(deviation,
      std::min({ sliceShare * anisotropy, most, hasShapes ? mostShapeSmoothing : mostSliceSmoothing }));
  }
  return deviation;
}

bool suggestShapeBasedInterpolation(const NoiseEstimate& estimate, const glm::dvec3& spacing)
{
  const std::optional<ThickSlices> slices = thickSlices(spacing);
  if (!slices)
  {
    return false;
  }
  const auto axis = static_cast<std::size_t>(slices->axis);
  const bool areFar = slices->ratio() > farShapes && estimate.sharpnessAlong[axis] > blurredSlices;
  return areFar || estimate.innerShareAlong[axis] > mostInnerShare;
}

void SuggestedDeviations::add(const SuggestedDeviations& other)
{
  this->ofValues = std::max(this->ofValues, other.ofValues);
  this->ofLabels = std::max(this->ofLabels, other.ofLabels);
  this->keepsLabels = this->keepsLabels && other.keepsLabels;
}

void SuggestedSmoothing::add(const SuggestedSmoothing& other)
{
  this->byValues.add(other.byValues);
  this->byShapes.add(other.byShapes);
  this->labels = this->labels || other.labels;
  this->clearBorders = this->clearBorders && other.clearBorders;
  this->shapeBased = this->shapeBased || other.shapeBased;
}

SuggestedSmoothing suggestSmoothings(const NoiseEstimate& estimate, const glm::dvec3& spacing)
{
  const auto suggest = [&](bool shapeBased)
  {
    const auto with = [&](bool labels)
    {
      NoiseEstimate one = estimate;
      one.labels = labels;
      return suggestSmoothing(one, spacing, shapeBased);
    };
    const double ofLabels = with(true);
    const bool isThick = estimate.thickness >= NoiseEstimate::thickEnough;
    return SuggestedDeviations{ with(false), ofLabels, isThick || ofLabels <= 0.5 * estimate.thickness };
  };
  return { suggest(false), suggest(true), estimate.labels, estimate.raggedBorders < mostRaggedBorders,
    suggestShapeBasedInterpolation(estimate, spacing) };
}

#define INK_INSTANTIATE(T)                                                                                   \
  template NoiseEstimate estimateNoise(const GridField<T>&, double);                                         \
  template NoiseEstimate estimateNoise(const SliceReader<T>&, std::array<int, 3>, int, double);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
