// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/ScalarDifference.h"
#include "Statistics/NoiseEstimate.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

/// Samples that are looked at, about: enough for an error of a percent.
constexpr double noiseSamples = 400000.0;

/// Of so many samples every which one is looked at.
inline std::size_t noiseStride(double count)
{
  return count > noiseSamples ? static_cast<std::size_t>(std::ceil(count / noiseSamples)) : 1;
}

/// What is seen around an iso-surface, in any order.
struct NoiseSightings
{
  std::array<std::vector<double>, 2> differences; ///< second ones, below and above the iso-value
  std::vector<double> changes;                    ///< between neighbors that differ
  std::vector<double> steps;                      ///< across the surface
  /// Of the steps along each axis: between the samples around the surface.
  std::array<std::vector<double>, 3> edgeShares;
  /// The shares of these between the samples around it that lie on the side of the greater one.
  std::array<std::vector<double>, 3> innerShares;
  std::vector<double> runs;      ///< samples on one side of it, along an axis
  std::vector<double> outerRuns; ///< of these those where it is seen from outside, see isOpen
  std::vector<double> keeping;   ///< the deviations that keep what is inside of it, see keepingDeviation
  std::int64_t maskChanges = 0;  ///< of the changes, see IsoStatistics
  std::int64_t maskSteps = 0;    ///< of the steps: at the edge of a mask, which is most of them
  std::int64_t outerSteps = 0;   ///< those that are seen from outside
  std::int64_t cutSteps = 0;     ///< of these, beside the edge of a mask that is half of them or more
  std::int64_t borders = 0;      ///< of some of these: beside another label, see NoiseEstimate::raggedBorders
  std::int64_t raggedBorders = 0; ///< of these
  /// Angles between normals at some of these, radians: of the values and of values that are smoothed some,
  /// and of these and of values that are smoothed more, see NoiseEstimate::roughness.
  std::array<std::vector<double>, 2> turns;

  void append(const NoiseSightings& other);
};

/// @param reach 1 along the axes that neighborhoods extend along, otherwise 0
NoiseEstimate makeNoiseEstimate(std::span<const NoiseSightings> parts, const glm::ivec3& reach);

/// The largest deviation of a Gaussian that keeps three quarters of the value in the middle of a box, of so
/// many samples along each axis, two of them finite at least; infinite of what is larger. A ball and a tube
/// that fill such boxes then keep .59 and .68. Of walls, NoiseEstimate::thickness says more.
double keepingDeviation(const glm::dvec3& size);

/// Looks at samples and their neighbors.
///
/// @tparam Samples has has(index), whether there is a sample, and at(index), its value
template <class Samples>
class NoiseSampler
{
public:
  /// How far samples are looked at along an axis, from that of an edge that is nearer to the first sample.
  static constexpr int before = static_cast<int>(NoiseEstimate::thickEnough) - 1;
  static constexpr int behind = static_cast<int>(NoiseEstimate::thickEnough);
  /// Of the positions seen from outside, every which one's turns are looked at: each takes 729 samples.
  static constexpr int everyTurn = 4;
  /// A label that has less of what is near is an island, or a thin layer; at a straight border it has half.
  static constexpr double raggedShare = 0.3;

  /// @param reach of a neighborhood, as for makeNoiseEstimate
  NoiseSampler(const Samples& samples, double isoValue, const glm::ivec3& reach)
    : Values(samples)
    , IsoValue(isoValue)
    , Reach(reach)
  {
  }

  /// The neighborhood of a sample, and the edges to the next one along each axis.
  void look(const glm::ivec3& at, NoiseSightings& found) const
  {
    this->addNeighborhood(at, found);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->addEdge(at, axis, found);
    }
  }

private:
  bool isAbove(const glm::ivec3& sample) const
  {
    return static_cast<double>(this->Values.at(sample)) >= this->IsoValue;
  }

  void addNeighborhood(const glm::ivec3& at, NoiseSightings& found) const
  {
    if (this->Reach == glm::ivec3(0))
    {
      return;
    }
    const auto middle = this->Values.at(at);
    const bool above = this->isAbove(at);
    double sum = 0.0;
    bool equal = true;
    for (int z = -this->Reach.z; z <= this->Reach.z; ++z)
    {
      for (int y = -this->Reach.y; y <= this->Reach.y; ++y)
      {
        for (int x = -this->Reach.x; x <= this->Reach.x; ++x)
        {
          const glm::ivec3 sample = at + glm::ivec3(x, y, z);
          if (!this->Values.has(sample) || this->isAbove(sample) != above)
          {
            return;
          }
          const auto value = this->Values.at(sample);
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
  void addEdge(const glm::ivec3& at, int axis, NoiseSightings& found) const
  {
    glm::ivec3 next = at;
    ++next[axis];
    if (!this->Values.has(at) || !this->Values.has(next))
    {
      return;
    }
    const double change = std::abs(difference(this->Values.at(at), this->Values.at(next)));
    if (change > 0.0 && std::isfinite(change))
    {
      found.changes.push_back(change);
      found.maskChanges += this->isMaskChange(at, next, axis);
    }
    if (this->isAbove(at) != this->isAbove(next))
    {
      const bool isCut = this->addStep(at, axis, change, found);
      const std::array<double, 2> runs = { this->runOf(at, axis, -1), this->runOf(next, axis, 1) };
      found.runs.insert(found.runs.end(), runs.begin(), runs.end());
      const bool rises = this->isAbove(next);
      const glm::ivec3& inner = rises ? next : at;
      if (change > 0.0 && std::isfinite(change))
      {
        found.innerShares[static_cast<std::size_t>(axis)].push_back(
          (static_cast<double>(this->Values.at(inner)) - this->IsoValue) / change);
      }
      const bool isOuterOpen = this->isOpen(rises ? at : next);
      if (isOuterOpen)
      {
        ++found.outerSteps;
        found.cutSteps += isCut;
        found.keeping.push_back(keepingDeviation(this->sizeAround(inner)));
        // Few slices have many of them: not the same ones' turn in each.
        if ((found.outerSteps + at.z) % everyTurn == 0)
        {
          this->addTurns(inner, found);
          // However large ids are.
          if (this->isMaskChange(at, next, axis))
          {
            this->addBorder(inner, found);
          }
        }
      }
      if (isOuterOpen || this->isOpen(inner))
      {
        found.outerRuns.insert(found.outerRuns.end(), runs.begin(), runs.end());
      }
    }
  }

  /// The samples on one side of the surface along each axis, in the middle of what is around one of them;
  /// infinitely many where no end is near.
  glm::dvec3 sizeAround(const glm::ivec3& start) const
  {
    const bool above = this->isAbove(start);
    // Along z only some slices are there.
    constexpr glm::ivec3 farthest(7, 7, before);
    glm::ivec3 middle = start;
    glm::dvec3 size(0.0);
    // The second time from the middle along all axes: at the tip of a ball, lines across are short.
    for (const int axis : { 0, 1, 2, 0, 1, 2 })
    {
      const int least = start[axis] - farthest[axis];
      const int most = start[axis] + farthest[axis];
      bool ends = true;
      const auto isInside = [&](int index)
      {
        glm::ivec3 sample = middle;
        sample[axis] = index;
        const bool isKnown = index >= least && index <= most && this->Values.has(sample);
        ends = ends && isKnown;
        return isKnown && this->isAbove(sample) == above;
      };
      int first = middle[axis];
      int last = first;
      while (isInside(first - 1))
      {
        --first;
      }
      while (isInside(last + 1))
      {
        ++last;
      }
      middle[axis] = (first + last) / 2;
      size[axis] = ends ? last - first + 1 : std::numeric_limits<double>::infinity();
    }
    return size;
  }

  /// Whether some line from a sample along x or y, of which all samples are there, ends where they do without
  /// meeting the surface, or goes far.
  bool isOpen(const glm::ivec3& at) const
  {
    // Sparse grids have no end.
    constexpr int far = 1024;
    const bool above = this->isAbove(at);
    for (const glm::ivec3& step :
      { glm::ivec3(-1, 0, 0), glm::ivec3(1, 0, 0), glm::ivec3(0, -1, 0), glm::ivec3(0, 1, 0) })
    {
      glm::ivec3 sample = at;
      int n = 0;
      while (n < far && this->Values.has(sample) && this->isAbove(sample) == above)
      {
        sample += step;
        ++n;
      }
      if (n == far || !this->Values.has(sample))
      {
        return true;
      }
    }
    return false;
  }

  /// Whether no gradual transition begins at the lower of two neighbors along an axis: the value behind it is
  /// the same.
  bool isMaskChange(const glm::ivec3& at, const glm::ivec3& next, int axis) const
  {
    const bool rises = this->Values.at(at) < this->Values.at(next);
    const glm::ivec3& lower = rises ? at : next;
    glm::ivec3 beyond = lower;
    beyond[axis] += rises ? -1 : 1;
    return this->Values.has(beyond) && this->Values.at(beyond) == this->Values.at(lower);
  }

  /// What values change by across an edge that the surface intersects, of which the edge itself has a part.
  /// @return whether half of it or more is the edge of a mask
  bool addStep(const glm::ivec3& at, int axis, double change, NoiseSightings& found) const
  {
    // On each side, so many samples show the whole step.
    constexpr int stepReach = 2;
    double least = 0.0;
    double greatest = 0.0;
    for (int n = -stepReach; n <= 1 + stepReach; ++n)
    {
      glm::ivec3 sample = at;
      sample[axis] += n;
      if (this->Values.has(sample))
      {
        const double d = difference(this->Values.at(sample), this->Values.at(at));
        least = std::min(least, d);
        greatest = std::max(greatest, d);
      }
    }
    const double step = greatest - least;
    if (!(step > 0.0) || !std::isfinite(step))
    {
      return false;
    }
    found.steps.push_back(step);
    found.edgeShares[static_cast<std::size_t>(axis)].push_back(change / step);
    // Gradients that end at a constant have no transition there either, but are no step.
    const auto isMaskEdge = [&](int n)
    {
      glm::ivec3 first = at;
      first[axis] += n;
      glm::ivec3 second = first;
      ++second[axis];
      return this->Values.has(first) && this->Values.has(second) &&
        std::abs(difference(this->Values.at(first), this->Values.at(second))) > 0.5 * step &&
        this->isMaskChange(first, second, axis);
    };
    const bool isMask = isMaskEdge(0);
    found.maskSteps += isMask;
    // Where a mask cuts through a gradual transition, the surface may lie a sample or two within.
    return isMask || isMaskEdge(-2) || isMaskEdge(-1) || isMaskEdge(1) || isMaskEdge(2);
  }

  /// A sample above the iso-value that has another label beside it.
  void addBorder(const glm::ivec3& at, NoiseSightings& found) const
  {
    // How many samples around it are above, and how many of these have its own label.
    const auto count = [&](int reach)
    {
      std::array<int, 2> counts = {};
      for (int z = -reach; z <= reach; ++z)
      {
        for (int y = -reach; y <= reach; ++y)
        {
          for (int x = -reach; x <= reach; ++x)
          {
            const glm::ivec3 sample = at + glm::ivec3(x, y, z);
            if (this->Values.has(sample) && this->isAbove(sample))
            {
              ++counts[0];
              counts[1] += this->Values.at(sample) == this->Values.at(at);
            }
          }
        }
      }
      return counts;
    };
    const auto [beside, ownBeside] = count(1);
    if (ownBeside < beside)
    {
      ++found.borders;
      const auto [near, ownNear] = count(3);
      found.raggedBorders += ownNear < raggedShare * near;
    }
  }

  /// By how much smoothing turns a sample's normal. Not where samples for it are missing.
  void addTurns(const glm::ivec3& at, NoiseSightings& found) const
  {
    glm::dvec3 plain(0.0);
    std::array<glm::dvec3, 2> smoothed = {};
    for (int z = -before; z <= before; ++z)
    {
      for (int y = -before; y <= before; ++y)
      {
        for (int x = -before; x <= before; ++x)
        {
          const glm::ivec3 offset(x, y, z);
          if (!this->Values.has(at + offset))
          {
            return;
          }
          const glm::dvec3 slope =
            difference(this->Values.at(at + offset), this->Values.at(at)) * glm::dvec3(offset);
          plain += std::abs(x) + std::abs(y) + std::abs(z) == 1 ? slope : glm::dvec3(0.0);
          for (std::size_t n = 0; n < smoothed.size(); ++n)
          {
            const auto& weights = turnWeights()[n];
            smoothed[n] += weights[std::abs(x)] * weights[std::abs(y)] * weights[std::abs(z)] * slope;
          }
        }
      }
    }
    const auto addAngle = [](const glm::dvec3& a, const glm::dvec3& b, std::vector<double>& angles)
    {
      const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      if (std::isfinite(angle))
      {
        angles.push_back(angle);
      }
    };
    addAngle(plain, smoothed[0], found.turns[0]);
    addAngle(smoothed[0], smoothed[1], found.turns[1]);
  }

  /// Gaussians of sharpSmoothing and mostSuggestedSmoothing, by the distance in samples.
  static const std::array<std::array<double, 1 + before>, 2>& turnWeights()
  {
    static const auto weights = []
    {
      std::array<std::array<double, 1 + before>, 2> all = {};
      for (std::size_t n = 0; n < all.size(); ++n)
      {
        const double deviation = n == 0 ? sharpSmoothing : mostSuggestedSmoothing;
        for (std::size_t i = 0; i < all[n].size(); ++i)
        {
          const double distance = static_cast<double>(i) / deviation;
          all[n][i] = std::exp(-0.5 * distance * distance);
        }
      }
      return all;
    }();
    return weights;
  }

  /// The samples from one on that are on its side of the surface.
  double runOf(glm::ivec3 sample, int axis, int way) const
  {
    const bool above = this->isAbove(sample);
    for (int run = 0; run <= before; ++run, sample[axis] += way)
    {
      if (!this->Values.has(sample))
      {
        // Nobody knows how far it goes on.
        break;
      }
      if (this->isAbove(sample) != above)
      {
        return run;
      }
    }
    return NoiseEstimate::thickEnough;
  }

  const Samples& Values;
  double IsoValue;
  glm::ivec3 Reach;
};

} // namespace ink
