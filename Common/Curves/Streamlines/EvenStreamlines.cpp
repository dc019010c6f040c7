// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/EvenStreamlines.h"

#include "Core/Hash.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "Curves/Streamlines/LineSampleGrid.h"
#include "PointSampling/ProgressiveOrder.h"
#include "PointSampling/WhiteNoise.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace ink
{

namespace
{

// Of the spacing between lines that are made:
constexpr double sampleDistance = 0.25;
constexpr double testDistance = 0.0625; ///< between points that are tested against other lines
constexpr double startDistance = 0.9;   ///< chords are shorter than the walks that starts are found by
constexpr double closeDistance = 0.1;

/// From which umbilic measure on it means little which of two directions is called which.
constexpr float leastUmbilic = 0.5f;

/// Where a line may start, and which way.
struct Candidate
{
  std::uint64_t order;
  MeshPoint at;
  glm::dvec3 heading;
};

/// A line that has been traced, with its samples by their points.
struct Attempt
{
  TracedLine line;
  std::vector<LineSample> samples;
  std::vector<std::size_t> points;
};

/// The lines made so far, and how more are made. Positions of samples are in spacings, from the center of the
/// mesh.
class Placement
{
public:
  Placement(const MeshNavigation& mesh, std::span<const glm::vec3> normals, const LineField& field,
    const EvenStreamlineOptions& options, const Progress& progress)
    : Mesh(mesh)
    , Normals(normals)
    , Field(field)
    , Options(options)
    , Report(progress)
    , Areas(cumulateArea(mesh.mesh()))
    , Center(0.5 * mesh.lower() + 0.5 * mesh.upper())
    , Tracer(mesh, field, this->Options.trace)
  {
  }

  Streamlines run()
  {
    const double widest = 0.25 * std::sqrt(this->Mesh.area()) / this->Options.spacing;
    const int levels = widest > 1.0 ? static_cast<int>(std::log2(widest)) : 0;
    for (int level = 0; level <= levels; ++level)
    {
      if (!this->fill(levels - level))
      {
        return {};
      }
    }
    return joinLines(this->Lines, this->Order);
  }

private:
  LineSample sampleOf(const MeshPoint& at, const glm::dvec3& position) const
  {
    return { glm::vec3((position - this->Center) / this->Options.spacing),
      normalAt(this->Mesh, this->Normals, at) };
  }

  /// The mesh's point at the corner of a triangle with the largest weight.
  std::uint32_t nearestPoint(const MeshPoint& at) const
  {
    const glm::dvec3& w = at.weights;
    const std::size_t corner = w.x >= w.y ? (w.x >= w.z ? 0 : 2) : (w.y >= w.z ? 1 : 2);
    return this->Mesh.mesh().triangles[at.triangle][corner];
  }

  /// Which way a line beside another one starts: that of the field's name, or where names mean little, that
  /// of the other line.
  glm::dvec3 headingAt(const MeshPoint& at, const glm::dvec3& other) const
  {
    const std::uint32_t point = this->nearestPoint(at);
    const glm::dvec3& own = this->Field.directions[point];
    const bool isUmbilic = !this->Field.umbilics.empty() && this->Field.umbilics[point] > leastUmbilic;
    return isUmbilic || own == glm::dvec3(0.0) ? other : own;
  }

  /// Fills the surface with lines at 2^halvings spacings.
  /// @return false when stopped
  bool fill(int halvings)
  {
    this->Gap = std::ldexp(1.0, halvings);
    this->Stop = static_cast<float>(this->Options.stopDistance * this->Gap);
    this->Start = static_cast<float>(startDistance * this->Gap);
    this->Done = 1.0 / this->Gap;
    this->Grid = LineSampleGrid(static_cast<float>(this->Gap));
    const std::size_t first = this->Lines.size();
    std::vector<std::vector<LineSample>> samples(first);
    parallelFor(first,
      [&](std::size_t n)
      {
        const std::vector<TracedPoint>& points = this->Lines[n].points;
        for (const std::size_t i : this->samplePoints(this->Lines[n]))
        {
          samples[n].push_back(this->sampleOf(points[i].at, points[i].position));
        }
      });
    for (const std::vector<LineSample>& ofLine : samples)
    {
      for (const LineSample& sample : ofLine)
      {
        this->Grid.insert(sample);
      }
    }
    std::size_t next = 0;
    const auto besideLines = [&]
    {
      while (next < this->Lines.size())
      {
        const std::size_t end = this->Lines.size();
        if (!this->tryAll(this->besideLines(next, end)))
        {
          return false;
        }
        next = end;
      }
      return true;
    };
    if (!besideLines() || !this->tryAll(this->scattered(halvings)) || !besideLines())
    {
      return false;
    }
    this->orderFrom(first);
    return true;
  }

  /// The points of a line at which it is sampled: with its ends.
  std::vector<std::size_t> samplePoints(const TracedLine& line) const
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

  /// Candidates at the gap's distance to both sides of lines.
  std::vector<Candidate> besideLines(std::size_t begin, std::size_t end) const
  {
    std::vector<std::vector<Candidate>> found(end - begin);
    const double gap = this->Gap * this->Options.spacing;
    parallelFor(end - begin,
      [&](std::size_t n)
      {
        const std::vector<TracedPoint>& points = this->Lines[begin + n].points;
        double arc = -gap;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          if (points[i].arc - arc < gap)
          {
            continue;
          }
          arc = points[i].arc;
          const glm::dvec3 along =
            points[std::min(i + 1, points.size() - 1)].position - points[i > 0 ? i - 1 : 0].position;
          const glm::dvec3 across = glm::cross(this->Mesh.chart(points[i].at.triangle).normal(), along);
          for (std::uint64_t side = 0; side < 2; ++side)
          {
            const auto reached = this->Mesh.walk(points[i].at, side == 0 ? across : -across, gap);
            if (reached &&
              !this->Grid.isNear(this->sampleOf(reached->at, this->Mesh.position(reached->at)), this->Start))
            {
              const glm::dvec3 heading =
                glm::cross(this->Mesh.chart(reached->at.triangle).normal(), reached->heading);
              found[n].push_back({ hash(this->Options.seed, begin + n, 2 * i + side), reached->at,
                this->headingAt(reached->at, heading) });
            }
          }
        }
      });
    std::vector<Candidate> result;
    for (const std::vector<Candidate>& some : found)
    {
      result.insert(result.end(), some.begin(), some.end());
    }
    return result;
  }

  /// Candidates by chance, four in a square of the gap, those first where directions are defined best.
  std::vector<Candidate> scattered(int level) const
  {
    const double gap = this->Gap * this->Options.spacing;
    const auto count = static_cast<std::size_t>(std::ceil(4.0 * this->Mesh.area() / (gap * gap)));
    const std::vector<SurfaceSample> samples = sampleWhiteNoise(
      this->Mesh.mesh(), this->Areas, count, hash(this->Options.seed, static_cast<std::uint64_t>(level)));
    std::vector<std::optional<Candidate>> found(samples.size());
    parallelFor(samples.size(),
      [&](std::size_t i)
      {
        const SurfaceSample& sample = samples[i];
        const MeshPoint at{ sample.triangle,
          { 1.0 - static_cast<double>(sample.b1) - static_cast<double>(sample.b2), sample.b1, sample.b2 } };
        if (!this->Mesh.isUsable(at.triangle))
        {
          return;
        }
        const std::uint32_t point = this->nearestPoint(at);
        if (this->Grid.isNear(this->sampleOf(at, this->Mesh.position(at)), this->Start))
        {
          return;
        }
        const float umbilic = this->Field.umbilics.empty() ? 0.0f : this->Field.umbilics[point];
        const auto undefined = static_cast<std::uint64_t>(15.0f * std::clamp(umbilic, 0.0f, 1.0f));
        found[i] = { undefined << 60 | hash(this->Options.seed, static_cast<std::uint64_t>(level), i) >> 4,
          at, this->Field.directions[point] };
      });
    std::vector<Candidate> result;
    for (const std::optional<Candidate>& candidate : found)
    {
      if (candidate)
      {
        result.push_back(*candidate);
      }
    }
    return result;
  }

  /// Makes the lines of all candidates that have room, in their order.
  /// @return false when stopped
  bool tryAll(std::vector<Candidate> candidates)
  {
    parallelSort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b)
      { return a.order != b.order ? a.order < b.order : a.at.triangle < b.at.triangle; });
    LineSampleGrid batch(static_cast<float>(this->Gap));
    std::vector<std::optional<Attempt>> attempts;
    for (std::size_t begin = 0; begin < candidates.size();)
    {
      if (this->Report &&
        !this->Report(
          this->Done * (0.5 + 0.5 * static_cast<double>(begin) / static_cast<double>(candidates.size()))))
      {
        return false;
      }
      // Few at first, when lines are long and most candidates are beside the same ones.
      const std::size_t size =
        std::min(std::clamp<std::size_t>(this->Lines.size() / 8, 16, 2048), candidates.size() - begin);
      attempts.assign(size, std::nullopt);
      parallelFor(size, [&](std::size_t i) { attempts[i] = this->attempt(candidates[begin + i]); });
      const std::size_t first = this->Lines.size();
      for (std::optional<Attempt>& attempt : attempts)
      {
        if (attempt && (batch.isEmpty() || this->cut(*attempt, batch)))
        {
          for (const LineSample& sample : attempt->samples)
          {
            batch.insert(sample);
            this->Grid.insert(sample);
          }
          this->Lines.push_back(std::move(attempt->line));
        }
      }
      if (this->Lines.size() > first)
      {
        batch.clear();
      }
      begin += size;
    }
    return true;
  }

  /// The line of a candidate, up to where it comes close to the lines so far or to itself.
  std::optional<Attempt> attempt(const Candidate& candidate) const
  {
    const glm::dvec3 start = this->Mesh.position(candidate.at);
    const LineSample startSample = this->sampleOf(candidate.at, start);
    if (this->Grid.isNear(startSample, this->Start))
    {
      return std::nullopt;
    }
    const glm::dvec3 forward = this->Tracer.direction(candidate.at, candidate.heading);
    const double gap = this->Gap * this->Options.spacing;
    const double stop = this->Options.stopDistance * this->Options.spacing;
    std::vector<std::pair<double, LineSample>> own = { { 0.0, startSample } };
    double tested = 0.0;
    double sampled = 0.0;
    double overlap = 0.0; // from where on the line runs into its own start
    Attempt result;
    result.line = this->Tracer.trace(candidate.at, candidate.heading,
      [&](const TracedPoint& point)
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
        if (this->Grid.isNear(sample, this->Stop))
        {
          return false;
        }
        if (this->meetsItself(own, point.arc, sample))
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
          own.emplace_back(point.arc, sample);
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

  bool isLongEnough(const TracedLine& line) const
  {
    return line.points.size() > 1 &&
      line.points.back().arc - line.points.front().arc >= this->Options.minimumLength * this->Options.spacing;
  }

  /// Whether a sample is near one of the same line that is far from it along the line.
  bool meetsItself(
    const std::vector<std::pair<double, LineSample>>& own, double arc, const LineSample& sample) const
  {
    // Neighboring samples are no farther apart, so a distant one lets as many be left out.
    const double most = (sampleDistance * this->Gap + sampleDistance);
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

  /// Cuts a line where it meets those accepted since it was traced.
  /// @return whether something is left
  bool cut(Attempt& attempt, const LineSampleGrid& batch) const
  {
    TracedLine& line = attempt.line;
    if (batch.isNear(this->sampleOf(line.points[line.seed].at, line.points[line.seed].position), this->Start))
    {
      return false;
    }
    const std::size_t count = attempt.points.size();
    std::size_t middle = 0;
    while (middle + 1 < count && attempt.points[middle + 1] <= line.seed)
    {
      ++middle;
    }
    std::size_t last = middle;
    while (last + 1 < count && !batch.isNear(attempt.samples[last + 1], this->Stop))
    {
      ++last;
    }
    std::size_t first = middle + 1;
    while (first > 0 && !batch.isNear(attempt.samples[first - 1], this->Stop))
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
    const std::size_t begin = attempt.points[first];
    line.points.erase(line.points.begin() + static_cast<Step>(attempt.points[last] + 1), line.points.end());
    line.points.erase(line.points.begin(), line.points.begin() + static_cast<Step>(begin));
    line.seed -= std::min(begin, line.seed);
    attempt.samples.erase(attempt.samples.begin() + static_cast<Step>(last + 1), attempt.samples.end());
    attempt.samples.erase(attempt.samples.begin(), attempt.samples.begin() + static_cast<Step>(first));
    return this->isLongEnough(line);
  }

  /// Appends the lines since one to the order, so that each prefix is spread over the surface.
  void orderFrom(std::size_t first)
  {
    std::vector<glm::vec3> middles;
    std::vector<glm::vec3> normals;
    for (std::size_t n = first; n < this->Lines.size(); ++n)
    {
      const std::vector<TracedPoint>& points = this->Lines[n].points;
      const double half = 0.5 * (points.front().arc + points.back().arc);
      const auto middle = std::partition_point(
        points.begin(), points.end() - 1, [&](const TracedPoint& point) { return point.arc < half; });
      const LineSample sample = this->sampleOf(middle->at, middle->position);
      middles.push_back(sample.position);
      normals.push_back(sample.normal);
    }
    for (const std::uint32_t n : progressiveOrder(middles, normals, {}, this->Options.seed))
    {
      this->Order.push_back(static_cast<std::uint32_t>(first + n));
    }
  }

  const MeshNavigation& Mesh;
  std::span<const glm::vec3> Normals;
  const LineField& Field;
  const EvenStreamlineOptions& Options;
  const Progress& Report;
  CumulativeArea Areas;
  glm::dvec3 Center;
  StreamlineTracer Tracer;
  std::vector<TracedLine> Lines;
  std::vector<std::uint32_t> Order;
  LineSampleGrid Grid{ 1.0f };
  double Gap = 1.0;   ///< between the lines that are being made, in spacings
  float Stop = 0.0f;  ///< how close lines come to each other, in spacings
  float Start = 0.0f; ///< how close to other lines they start, in spacings
  double Done = 0.0;  ///< about the share of all work up to this gap
};

void check(bool isRight, const std::string& message)
{
  if (!isRight)
  {
    throw std::invalid_argument(message);
  }
}

} // namespace

Streamlines evenStreamlines(const MeshNavigation& mesh, std::span<const glm::vec3> normals,
  const LineField& field, const EvenStreamlineOptions& options, const Progress& progress)
{
  const std::size_t count = mesh.mesh().points.size();
  check(field.directions.size() == count,
    "there are " + std::to_string(field.directions.size()) + " directions for " + std::to_string(count) +
      " points, expected one per point");
  check((normals.empty() || normals.size() == count) &&
      (field.others.empty() || field.others.size() == count) &&
      (field.umbilics.empty() || field.umbilics.size() == count),
    "normals, other directions and umbilic measures: expected none or one per point");
  check(options.spacing > 0.0 && std::isfinite(options.spacing),
    "the spacing is " + std::to_string(options.spacing) + ", expected more than 0");
  check(options.stopDistance > 0.0 && options.stopDistance <= 0.9,
    "the stop distance is " + std::to_string(options.stopDistance) +
      ", expected more than 0 and no more than 0.9");
  const double samples = mesh.area() / options.spacing / options.spacing / sampleDistance;
  check(samples < 0x1p28,
    "the surface needs " + std::to_string(samples) + " samples of lines at a spacing of " +
      std::to_string(options.spacing) + ", expected fewer than 268435456, so a larger spacing");
  if (!(mesh.area() > 0.0))
  {
    return {};
  }
  EvenStreamlineOptions own = options;
  own.trace.maximumStep = std::min(own.trace.maximumStep, sampleDistance * options.spacing);
  own.trace.closeDistance =
    own.trace.closeDistance > 0.0 ? own.trace.closeDistance : closeDistance * options.spacing;
  return Placement(mesh, normals, field, own, progress).run();
}

} // namespace ink
