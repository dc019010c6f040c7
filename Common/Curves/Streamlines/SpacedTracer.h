// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/LineSampleGrid.h"
#include "Curves/Streamlines/LineSurface.h"
#include "Curves/Streamlines/TracedLine.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace ink
{

/// Where a line may start, and which way.
template <class Point>
struct StreamlineCandidate
{
  std::uint64_t order; ///< lower ones come first
  Point at;
  glm::dvec3 heading;
};

/// A line that has been traced, with its samples and their points.
template <class Point>
struct SpacedLine
{
  TracedLineOn<Point> line;
  std::vector<LineSample> samples;
  std::vector<std::size_t> points;
};

/// Traces lines that keep a distance from others and from themselves. Positions of samples are in spacings,
/// from the center of the surface.
template <LineSurface Surface>
class SpacedTracer
{
public:
  using Point = typename Surface::Point;
  using Line = TracedLineOn<Point>;

  /// The arguments are viewed and have to live as long.
  SpacedTracer(const Surface& surface, const EvenStreamlineOptions& options);

  /// Sets the gap between the lines that are made, in spacings.
  void setGap(double gap);
  double gap() const { return this->Gap; }
  /// How close to other lines one may start, in spacings. Less than the gap: chords are shorter than the
  /// walks by which starts are found.
  float startDistance() const { return this->Start; }

  LineSample sampleOf(const Point& at, const glm::dvec3& position) const;
  /// The points of a line at which it is sampled: with its ends.
  std::vector<std::size_t> samplePoints(const Line& line) const;
  /// The line of a candidate, up to where it comes close to other lines or to itself; nothing if that leaves
  /// no line.
  std::optional<SpacedLine<Point>> trace(
    const StreamlineCandidate<Point>& candidate, const LineSampleGrid& others) const;
  /// Cuts a line where it meets other ones.
  /// @return whether something is left
  bool cut(SpacedLine<Point>& spaced, const LineSampleGrid& others) const;

private:
  /// Samples with their arc lengths, in their order along a line.
  using ArcSamples = std::vector<std::pair<double, LineSample>>;

  bool isLongEnough(const Line& line) const;
  /// Whether a sample is near one of the same line that is far from it along the line.
  bool meetsItself(const ArcSamples& own, double arc, const LineSample& sample) const;

  // Of the spacing between lines that are made:
  static constexpr double sampleDistance = 0.25;
  static constexpr double testDistance = 0.0625; ///< between points that are tested against other lines
  static constexpr double startShare = 0.9; ///< chords are shorter than the walks that starts are found by

  const Surface& On;
  const EvenStreamlineOptions& Options;
  glm::dvec3 Center;
  double Gap = 1.0;
  float Stop = 0.0f; ///< how close lines come to each other, in spacings
  float Start = 0.0f;
};

template <LineSurface Surface>
SpacedTracer<Surface>::SpacedTracer(const Surface& surface, const EvenStreamlineOptions& options)
  : On(surface)
  , Options(options)
  , Center(surface.center())
{
  this->setGap(1.0);
}

template <LineSurface Surface>
void SpacedTracer<Surface>::setGap(double gap)
{
  this->Gap = gap;
  this->Stop = static_cast<float>(this->Options.stopDistance * gap);
  this->Start = static_cast<float>(startShare * gap);
}

template <LineSurface Surface>
LineSample SpacedTracer<Surface>::sampleOf(const Point& at, const glm::dvec3& position) const
{
  return { glm::vec3((position - this->Center) / this->Options.spacing), this->On.normal(at) };
}

template <LineSurface Surface>
std::vector<std::size_t> SpacedTracer<Surface>::samplePoints(const Line& line) const
{
  const double distance = sampleDistance * this->Gap * this->Options.spacing;
  std::vector<std::size_t> result = { 0 };
  for (std::size_t i = 1; i < line.points.size(); ++i)
  {
    if (line.points[i].arc - line.points[result.back()].arc >= distance || i + 1 == line.points.size())
    {
      result.push_back(i);
    }
  }
  return result;
}

template <LineSurface Surface>
std::optional<SpacedLine<typename Surface::Point>> SpacedTracer<Surface>::trace(
  const StreamlineCandidate<Point>& candidate, const LineSampleGrid& others) const
{
  const glm::dvec3 start = this->On.position(candidate.at);
  const LineSample startSample = this->sampleOf(candidate.at, start);
  if (others.isNear(startSample, this->Start))
  {
    return std::nullopt;
  }
  const glm::dvec3 forward = this->On.direction(candidate.at, candidate.heading);
  const double gap = this->Gap * this->Options.spacing;
  const double stop = this->Options.stopDistance * this->Options.spacing;
  std::array<ArcSamples, 2> own; // of each half
  own.fill({ { 0.0, startSample } });
  double tested = 0.0;
  double sampled = 0.0;
  double overlap = 0.0; // from where on the line runs into its own start
  SpacedLine<Point> result;
  result.line = this->On.trace(candidate.at, candidate.heading,
    [&](const TracedPointOn<Point>& point)
    {
      if (point.arc < 0.0 && tested > 0.0)
      {
        tested = sampled = 0.0; // the other half begins
      }
      if (std::abs(point.arc - tested) < testDistance * gap)
      {
        return true;
      }
      tested = point.arc;
      const LineSample sample = this->sampleOf(point.at, point.position);
      if (others.isNear(sample, this->Stop))
      {
        return false;
      }
      if (this->meetsItself(own[0], point.arc, sample) || this->meetsItself(own[1], point.arc, sample))
      {
        // A line that is about to close may go on: it comes from behind, straight towards its start.
        const glm::dvec3 offset = point.position - start;
        const double ahead = glm::dot(offset, forward);
        const double aside = glm::length(offset - ahead * forward);
        const double bend = ahead * ahead / gap;
        if (point.arc < 0.0 || ahead > 0.0 || aside > 0.5 * this->Options.spacing + bend ||
          (ahead > -stop && aside > 2.0 * this->Options.trace.closeDistance + bend))
        {
          return false;
        }
        overlap = ahead > -stop && overlap == 0.0 ? point.arc : overlap;
      }
      if (std::abs(point.arc - sampled) >= sampleDistance * gap)
      {
        sampled = point.arc;
        own[point.arc < 0.0 ? 1 : 0].emplace_back(point.arc, sample);
      }
      return true;
    });
  if (overlap > 0.0 && !result.line.closed)
  {
    const double behind = result.line.points[result.line.seed].arc;
    while (result.line.points.back().arc > overlap + behind)
    {
      result.line.points.pop_back();
    }
  }
  if (!this->isLongEnough(result.line))
  {
    return std::nullopt;
  }
  result.points = this->samplePoints(result.line);
  for (const std::size_t point : result.points)
  {
    result.samples.push_back(
      this->sampleOf(result.line.points[point].at, result.line.points[point].position));
  }
  return result;
}

template <LineSurface Surface>
bool SpacedTracer<Surface>::isLongEnough(const Line& line) const
{
  return line.points.size() > 1 &&
    line.points.back().arc - line.points.front().arc >= this->Options.minimumLength * this->Options.spacing;
}

template <LineSurface Surface>
bool SpacedTracer<Surface>::meetsItself(const ArcSamples& own, double arc, const LineSample& sample) const
{
  // In spacings. Neighboring samples are no farther apart, so a distant one lets as many be left out: a
  // sample is the first point that is tested beyond the distance of samples, and points are steps apart.
  const double most =
    (sampleDistance + testDistance) * this->Gap + this->Options.trace.maximumStep / this->Options.spacing;
  const double least = 3.0 * this->Options.stopDistance * this->Gap * this->Options.spacing;
  for (std::size_t i = 0; i < own.size();)
  {
    const double distance = glm::distance(own[i].second.position, sample.position);
    if (distance < static_cast<double>(this->Stop) && std::abs(own[i].first - arc) > least &&
      areNear(own[i].second, sample, this->Stop))
    {
      return true;
    }
    i += static_cast<std::size_t>(std::max(1.0, (distance - static_cast<double>(this->Stop)) / most));
  }
  return false;
}

template <LineSurface Surface>
bool SpacedTracer<Surface>::cut(SpacedLine<Point>& spaced, const LineSampleGrid& others) const
{
  Line& line = spaced.line;
  if (others.isNear(this->sampleOf(line.points[line.seed].at, line.points[line.seed].position), this->Start))
  {
    return false;
  }
  const std::size_t count = spaced.points.size();
  std::size_t middle = 0;
  while (middle + 1 < count && spaced.points[middle + 1] <= line.seed)
  {
    ++middle;
  }
  std::size_t last = middle;
  while (last + 1 < count && !others.isNear(spaced.samples[last + 1], this->Stop))
  {
    ++last;
  }
  std::size_t first = middle + 1;
  while (first > 0 && !others.isNear(spaced.samples[first - 1], this->Stop))
  {
    --first;
  }
  if (first > last)
  {
    return false;
  }
  if (first == 0 && last + 1 == count)
  {
    return true;
  }
  if (line.closed)
  {
    line.closed = false;
    line.ends = { LineEnd::Stopped, LineEnd::Stopped };
  }
  using Step = std::ptrdiff_t;
  const std::size_t begin = spaced.points[first];
  line.points.erase(line.points.begin() + static_cast<Step>(spaced.points[last] + 1), line.points.end());
  line.points.erase(line.points.begin(), line.points.begin() + static_cast<Step>(begin));
  line.seed -= std::min(begin, line.seed);
  spaced.samples.erase(spaced.samples.begin() + static_cast<Step>(last + 1), spaced.samples.end());
  spaced.samples.erase(spaced.samples.begin(), spaced.samples.begin() + static_cast<Step>(first));
  return this->isLongEnough(line);
}

} // namespace ink
