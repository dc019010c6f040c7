// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/NoiseEstimate.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

/// Samples looked at, about: enough for an error of a percent.
constexpr double mostSamples = 400000.0;

/// The share of positions that may be thinner than the thickness: lines that touch a ball hardly cross it,
/// too.
constexpr double thinShare = 0.1;

/// On each side of an intersected edge, so many samples show the whole step.
constexpr int stepReach = 2;

/// By how many deviations noise makes the range of so many samples across a blurred edge larger, as a median.
constexpr double noiseRange = 0.4;

/// What noise may turn normals by, in radians; measured on pictures of phantoms
/// (Documentation/picture-quality.md).
constexpr double largestAngle = 0.02;
constexpr double leastSmoothing = 0.3; ///< less does not show
constexpr double mostSmoothing = 2.0;
constexpr double pointSpread = 0.7;

/// The noise that steps of one gray level count as.
constexpr double terraceWeight = 1.5;

/// Longer voxels show their slices.
constexpr double leastAnisotropy = 1.1;

/// The deviation of a normal's angle at a blurred unit step, for noise of deviation 1: the deviation of a
/// derivative of noise under a Gaussian, by the step's own.
double angleOf(double deviation)
{
  const double pi = std::acos(-1.0);
  const double noise = std::sqrt(1.0 / (16.0 * std::pow(pi, 1.5) * std::pow(deviation, 5.0)));
  return noise * std::sqrt(2.0 * pi * (pointSpread * pointSpread + deviation * deviation));
}

/// The least with which noise, as a share of the step, turns normals no further than largestAngle.
double deviationFor(double ratio)
{
  if (ratio * angleOf(leastSmoothing) <= largestAngle)
  {
    return 0.0;
  }
  double low = leastSmoothing;
  double high = mostSmoothing;
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

template <class T>
class NoiseSampler
{
public:
  NoiseSampler(const GridField<T>& field, double isoValue)
    : Field(field)
    , Size(field.geometry().dimensions())
    , IsoValue(isoValue)
    , Reach(this->Size.x > 2, this->Size.y > 2, this->Size.z > 2)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Deviation *= this->Reach[axis] > 0 ? std::sqrt(6.0) : 1.0;
    }
  }

  NoiseEstimate estimate()
  {
    const double count = static_cast<double>(this->Field.geometry().sampleCount());
    // Every so many samples along a row, shifted from row to row.
    const int every = std::max(1, static_cast<int>(std::ceil(count / mostSamples)));
    const glm::ivec3 inside = glm::max(this->Size - 2 * this->Reach, 0);
    std::vector<Found> slices(static_cast<std::size_t>(inside.z));
    parallelFor(slices.size(),
      [&](std::size_t slice)
      {
        std::size_t row = slice * static_cast<std::size_t>(inside.y);
        for (int j = 0; j < inside.y; ++j, ++row)
        {
          const int shift = static_cast<int>(row * 7919 % static_cast<std::size_t>(every));
          for (int i = shift; i < inside.x; i += every)
          {
            this->look(this->Reach + glm::ivec3(i, j, static_cast<int>(slice)), slices[slice]);
          }
        }
      });
    Found all;
    for (const Found& some : slices)
    {
      all.append(some);
    }
    NoiseEstimate result;
    std::array<double, 2> variances = {};
    int sides = 0;
    const std::size_t most = std::max(all.differences[0].size(), all.differences[1].size());
    for (std::vector<double>& differences : all.differences)
    {
      if (differences.size() >= fewest &&
        static_cast<double>(differences.size()) >= leastShare * static_cast<double>(most))
      {
        const double deviation = quantileOf(differences, 0.5) / normalMedian / this->Deviation;
        variances[static_cast<std::size_t>(sides++)] = deviation * deviation;
      }
    }
    result.noise = sides == 0 ? 0.0 : std::sqrt((variances[0] + variances[1]) / sides);
    result.quantum = quantileOf(all.changes, 0.01);
    result.step = std::max(quantileOf(all.steps, 0.5) - noiseRange * result.noise, 0.0);
    if (!all.runs.empty())
    {
      result.thickness = quantileOf(all.runs, thinShare);
    }
    return result;
  }

private:
  struct Found
  {
    std::array<std::vector<double>, 2> differences; ///< below and above the iso-value
    std::vector<double> changes;
    std::vector<double> steps;
    std::vector<double> runs; ///< samples on one side of the surface, along an axis

    void append(const Found& other)
    {
      const auto add = [](std::vector<double>& to, const std::vector<double>& from)
      { to.insert(to.end(), from.begin(), from.end()); };
      add(this->differences[0], other.differences[0]);
      add(this->differences[1], other.differences[1]);
      add(this->changes, other.changes);
      add(this->steps, other.steps);
      add(this->runs, other.runs);
    }
  };

  void look(const glm::ivec3& at, Found& found) const
  {
    this->addNeighborhood(at, found);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->addEdge(at, axis, found);
    }
  }

  void addNeighborhood(const glm::ivec3& at, Found& found) const
  {
    if (this->Reach == glm::ivec3(0))
    {
      return;
    }
    const T middle = this->Field.at(at);
    double sum = 0.0;
    bool above = false;
    bool below = false;
    bool equal = true;
    for (int z = -this->Reach.z; z <= this->Reach.z; ++z)
    {
      for (int y = -this->Reach.y; y <= this->Reach.y; ++y)
      {
        for (int x = -this->Reach.x; x <= this->Reach.x; ++x)
        {
          const glm::ivec3 sample = at + glm::ivec3(x, y, z);
          if (!this->Field.has(sample))
          {
            return;
          }
          const T value = this->Field.at(sample);
          (static_cast<double>(value) >= this->IsoValue ? above : below) = true;
          if (above && below)
          {
            return;
          }
          equal = equal && value == middle;
          int weight = 1;
          for (const int step :
            { this->Reach.x > 0 ? x : 1, this->Reach.y > 0 ? y : 1, this->Reach.z > 0 ? z : 1 })
          {
            weight *= step == 0 ? -2 : 1;
          }
          sum += weight * difference(value, middle);
        }
      }
    }
    if (!equal && std::isfinite(sum))
    {
      found.differences[above].push_back(std::abs(sum));
    }
  }

  /// The edge from a sample to the next one along an axis.
  void addEdge(const glm::ivec3& at, int axis, Found& found) const
  {
    glm::ivec3 next = at;
    ++next[axis];
    if (next[axis] >= this->Size[axis] || !this->Field.has(at) || !this->Field.has(next))
    {
      return;
    }
    const double change = std::abs(difference(this->Field.at(at), this->Field.at(next)));
    if (change > 0.0 && std::isfinite(change))
    {
      found.changes.push_back(change);
    }
    const auto isAbove = [&](const glm::ivec3& sample)
    { return static_cast<double>(this->Field.at(sample)) >= this->IsoValue; };
    if (isAbove(at) == isAbove(next))
    {
      return;
    }
    double least = 0.0;
    double greatest = 0.0;
    for (int n = -stepReach; n <= 1 + stepReach; ++n)
    {
      glm::ivec3 sample = at;
      sample[axis] += n;
      if (sample[axis] >= 0 && sample[axis] < this->Size[axis] && this->Field.has(sample))
      {
        const double d = difference(this->Field.at(sample), this->Field.at(at));
        least = std::min(least, d);
        greatest = std::max(greatest, d);
      }
    }
    if (std::isfinite(greatest - least))
    {
      found.steps.push_back(greatest - least);
    }
    const bool above = isAbove(at);
    for (const int way : { -1, 1 })
    {
      glm::ivec3 sample = way < 0 ? at : next;
      double run = 0.0;
      for (; run < NoiseEstimate::thickEnough; run += 1.0, sample[axis] += way)
      {
        if (sample[axis] < 0 || sample[axis] >= this->Size[axis] || !this->Field.has(sample))
        {
          // Nobody knows how far it goes on.
          run = NoiseEstimate::thickEnough;
        }
        else if (isAbove(sample) != (way < 0 ? above : !above))
        {
          break;
        }
      }
      found.runs.push_back(std::min(run, NoiseEstimate::thickEnough));
    }
  }

  const GridField<T>& Field;
  glm::ivec3 Size;
  double IsoValue;
  glm::ivec3 Reach;       ///< of a neighborhood
  double Deviation = 1.0; ///< of a neighborhood's sum, for noise of deviation 1
};

} // namespace

template <class T>
NoiseEstimate estimateNoise(const GridField<T>& field, double isoValue)
{
  return NoiseSampler<T>(field, isoValue).estimate();
}

double suggestSmoothing(const NoiseEstimate& estimate, const glm::dvec3& spacing)
{
  double deviation = 0.0;
  if (estimate.step > 0.0)
  {
    // Noise hides the steps of gray levels; without it their edges are long, and smoothing has to reach
    // further.
    const double terraces = terraceWeight * std::max(estimate.quantum - estimate.noise, 0.0);
    deviation = std::max(deviationFor(estimate.noise / estimate.step),
      std::min(deviationFor((estimate.noise + terraces) / estimate.step), 0.5 * estimate.thickness));
  }
  const glm::dvec3 size = glm::abs(spacing);
  const double anisotropy = std::max({ size.x, size.y, size.z }) / std::min({ size.x, size.y, size.z });
  if (anisotropy > leastAnisotropy)
  {
    deviation = std::max(deviation, std::min(0.5 * anisotropy, mostSmoothing));
  }
  return deviation;
}

#define INK_INSTANTIATE(T) template NoiseEstimate estimateNoise(const GridField<T>&, double);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
