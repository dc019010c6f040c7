// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Resampling/TileResampler.h"
#include "Fields/SampleBox.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

/// Internal to Common/IsoSurface.
namespace ink
{

/// Normals where several labels meet on a surface: those of each one's own surface, as if regions were
/// smoothed and drawn one by one, so that there is a groove between them. The label of a position is the one
/// with the greatest share around it, so that borders are smooth and single voxels among others have none; of
/// equal ones, as half way between voxels, the least.
///
/// Shares are weighted by the biweight kernel, (1 - t^2)^2 along each axis, which ends smoothly. Half way
/// between two labels on a plane, normals are 45 degrees to it, to either side. All is computed from global
/// indices, so that pieces of a grid agree.
template <class Work>
class LabelBorderNormals
{
public:
  /// @param labels after makeMask; must outlive this
  /// @param isoValue labels below it are what is around the surface
  /// @param first the global index of the grid's first sample
  /// @param deviation the kernel's standard deviation along each axis, in samples; at least half of one
  /// counts
  LabelBorderNormals(
    const TileResampler<Work>& labels, double isoValue, const glm::ivec3& first, const glm::dvec3& deviation)
    : Labels(labels)
    , First(first)
    , IsoValue(isoValue)
    , Radius(std::sqrt(7.0) * glm::max(deviation, glm::dvec3(0.5)))
    , Blocks((labels.source().size() + blockSide - 1) / blockSide)
    , Ranges(static_cast<std::size_t>(this->Blocks.x) * this->Blocks.y * this->Blocks.z)
  {
    forEachRow(labels.source(),
      [&](int y, int z, const Work* row)
      {
        for (int x = 0; x < labels.source().size().x; ++x)
        {
          if (this->isInside(row[x]))
          {
            this->rangeAt({ x, y - labels.source().begin.y, z - labels.source().begin.z }).add(row[x]);
          }
        }
      });
  }

  struct Groove
  {
    glm::dvec3 gradient; ///< of the share of the own label, per sample step, up to a positive factor
    double weight;       ///< from 0, where other labels begin to count, to 1: how much of the normal is its
  };

  /// Nothing where only one label is near, or so many that they are none.
  /// @param index of a position, a global one
  std::optional<Groove> grooveAt(const glm::dvec3& index)
  {
    const SampleBox& all = this->Labels.source();
    const glm::ivec3 begin(glm::ceil(index - this->Radius));
    const glm::ivec3 last(glm::floor(index + this->Radius));
    const SampleBox box = { glm::max(begin - this->First, all.begin),
      glm::min(last + 1 - this->First, all.end) };
    if (!this->mayHaveSeveral(box))
    {
      return std::nullopt;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->weigh(axis, box, index[axis]);
    }
    this->Shares.clear();
    Share whole;
    forEachRow(box, [&](int y, int z, const Work* row) { this->addRow(box, y, z, row, whole); });
    if (this->Shares.size() < 2 || this->Shares.size() > mostLabels)
    {
      return std::nullopt;
    }
    Share inside;
    Share own;
    constexpr double leastDifference = 1e-6;
    for (const Share& one : this->Shares)
    {
      inside.add(one);
      const double more = one.weight - own.weight;
      const double tolerance = leastDifference * whole.weight;
      own = more > tolerance || (more > -tolerance && one.label < own.label) ? one : own;
    }
    // Half way to another label on a plane its share is half; at 1.15 deviations from there, this.
    constexpr double clearShare = 0.125;
    const double others = 1.0 - own.weight / inside.weight;
    // The gradient of own / whole: at the ends of the grid samples are missing.
    return Groove{ own.slope * whole.weight - own.weight * whole.slope, std::min(others / clearShare, 1.0) };
  }

private:
  /// Near a position; of measured values nearly all differ.
  static constexpr std::size_t mostLabels = 64;
  static constexpr int blockSide = 4;

  struct Share
  {
    Work label = 0;
    double weight = 0.0;
    glm::dvec3 slope = glm::dvec3(0.0); ///< the weight's gradient

    void add(const Share& other)
    {
      this->weight += other.weight;
      this->slope += other.slope;
    }
  };

  struct Range
  {
    Work least = std::numeric_limits<Work>::infinity();
    Work greatest = -std::numeric_limits<Work>::infinity();

    void add(Work label)
    {
      this->least = std::min(this->least, label);
      this->greatest = std::max(this->greatest, label);
    }
  };

  bool isInside(Work label) const { return static_cast<double>(label) >= this->IsoValue; }

  template <class Visit>
  void forEachRow(const SampleBox& box, const Visit& visit) const
  {
    for (int z = box.begin.z; z < box.end.z; ++z)
    {
      for (int y = box.begin.y; y < box.end.y; ++y)
      {
        visit(y, z, this->Labels.labelsFrom({ box.begin.x, y, z }));
      }
    }
  }

  /// @param sample counted from the first one that is there
  Range& rangeAt(const glm::ivec3& sample)
  {
    const glm::ivec3 block = sample / blockSide;
    return this->Ranges[block.x +
      static_cast<std::size_t>(this->Blocks.x) *
        (block.y + static_cast<std::size_t>(this->Blocks.y) * block.z)];
  }

  /// False only if there is one label in a box, or none.
  bool mayHaveSeveral(const SampleBox& box)
  {
    const glm::ivec3 first = this->Labels.source().begin;
    Range range;
    for (int z = box.begin.z - first.z; z < box.end.z - first.z + blockSide - 1; z += blockSide)
    {
      for (int y = box.begin.y - first.y; y < box.end.y - first.y + blockSide - 1; y += blockSide)
      {
        for (int x = box.begin.x - first.x; x < box.end.x - first.x + blockSide - 1; x += blockSide)
        {
          const Range& some = this->rangeAt(glm::min(glm::ivec3(x, y, z), box.end - first - 1));
          range.least = std::min(range.least, some.least);
          range.greatest = std::max(range.greatest, some.greatest);
        }
      }
    }
    return range.least < range.greatest;
  }

  /// The kernel and its derivative at the samples along an axis: along x, sums of those before each one.
  void weigh(int axis, const SampleBox& box, double position)
  {
    std::vector<glm::dvec2>& weights = this->Weights[static_cast<std::size_t>(axis)];
    weights.clear();
    glm::dvec2 sum(0.0);
    for (int n = box.begin[axis]; n < box.end[axis]; ++n)
    {
      const double t = (n + this->First[axis] - position) / this->Radius[axis];
      const double inner = std::max(1.0 - t * t, 0.0);
      const glm::dvec2 weight(inner * inner, 4.0 * t * inner / this->Radius[axis]);
      weights.push_back(axis == 0 ? sum : weight);
      sum += weight;
    }
    if (axis == 0)
    {
      weights.push_back(sum);
    }
  }

  /// Samples in a row mostly have one label.
  void addRow(const SampleBox& box, int y, int z, const Work* row, Share& whole)
  {
    if (this->Shares.size() > mostLabels)
    {
      return;
    }
    const glm::dvec2 alongY = this->Weights[1][static_cast<std::size_t>(y - box.begin.y)];
    const glm::dvec2 alongZ = this->Weights[2][static_cast<std::size_t>(z - box.begin.z)];
    const std::size_t size = this->Weights[0].size() - 1;
    for (std::size_t begin = 0, end = 0; begin < size; begin = end)
    {
      const Work label = row[begin];
      end = begin + 1;
      while (end < size && row[end] == label)
      {
        ++end;
      }
      if (std::isnan(label))
      {
        continue;
      }
      const glm::dvec2 alongX = this->Weights[0][end] - this->Weights[0][begin];
      const Share share = { label, alongX.x * alongY.x * alongZ.x,
        { alongX.y * alongY.x * alongZ.x, alongX.x * alongY.y * alongZ.x, alongX.x * alongY.x * alongZ.y } };
      whole.add(share);
      if (this->isInside(label) && this->Shares.size() <= mostLabels)
      {
        const auto same = std::find_if(
          this->Shares.begin(), this->Shares.end(), [&](const Share& one) { return one.label == label; });
        (same != this->Shares.end() ? *same : this->Shares.emplace_back(Share{ label })).add(share);
      }
    }
  }

  const TileResampler<Work>& Labels;
  glm::ivec3 First;
  double IsoValue;
  glm::dvec3 Radius;                              ///< of the kernel along each axis, in samples
  glm::ivec3 Blocks;                              ///< of the labels, along each axis
  std::vector<Range> Ranges;                      ///< of the labels inside each block
  std::array<std::vector<glm::dvec2>, 3> Weights; ///< of samples along each axis, and their derivatives
  std::vector<Share> Shares;                      ///< of the labels around a position
};

} // namespace ink
