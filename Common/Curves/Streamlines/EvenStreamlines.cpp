// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/EvenStreamlines.h"

#include "Core/Hash.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "Curves/Streamlines/LineSampleGrid.h"
#include "Curves/Streamlines/SpacedTracer.h"
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

// Of the spacing:
constexpr double longestStep = 0.25;
constexpr double closeDistance = 0.1;

/// From which umbilic measure on it means little which of two directions is called which.
constexpr float leastUmbilic = 0.5f;

/// The lines made so far, and how more are made.
class Placement
{
public:
  Placement(const MeshNavigation& mesh, std::span<const glm::vec3> normals, const LineField& field,
    const EvenStreamlineOptions& options, const Progress& progress)
    : Mesh(mesh)
    , Field(field)
    , Options(options)
    , Report(progress)
    , Areas(cumulateArea(mesh.mesh()))
    , Tracer(mesh, normals, field, options)
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
  /// Which way a line beside another one starts: that of the field's name, or where names mean little, that
  /// of the other line.
  glm::dvec3 headingAt(const MeshPoint& at, const glm::dvec3& other) const
  {
    const std::uint32_t point = this->Mesh.nearestPoint(at);
    const glm::dvec3& own = this->Field.directions[point];
    const bool isUmbilic = !this->Field.umbilics.empty() && this->Field.umbilics[point] > leastUmbilic;
    return isUmbilic || own == glm::dvec3(0.0) ? other : own;
  }

  /// Fills the surface with lines at 2^halvings spacings.
  /// @return false when stopped
  bool fill(int halvings)
  {
    this->Tracer.setGap(std::ldexp(1.0, halvings));
    this->Done = 1.0 / this->Tracer.gap();
    this->Grid = LineSampleGrid(static_cast<float>(this->Tracer.gap()));
    const std::size_t first = this->Lines.size();
    std::vector<std::vector<LineSample>> samples(first);
    parallelFor(first,
      [&](std::size_t n)
      {
        const std::vector<TracedPoint>& points = this->Lines[n].points;
        for (const std::size_t i : this->Tracer.samplePoints(this->Lines[n]))
        {
          samples[n].push_back(this->Tracer.sampleOf(points[i].at, points[i].position));
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

  /// Candidates at the gap's distance to both sides of lines.
  std::vector<StreamlineCandidate> besideLines(std::size_t begin, std::size_t end) const
  {
    std::vector<std::vector<StreamlineCandidate>> found(end - begin);
    const double gap = this->Tracer.gap() * this->Options.spacing;
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
              !this->Grid.isNear(this->Tracer.sampleOf(reached->at, this->Mesh.position(reached->at)),
                this->Tracer.startDistance()))
            {
              const glm::dvec3 heading =
                glm::cross(this->Mesh.chart(reached->at.triangle).normal(), reached->heading);
              found[n].push_back({ hash(this->Options.seed, begin + n, 2 * i + side), reached->at,
                this->headingAt(reached->at, heading) });
            }
          }
        }
      });
    std::vector<StreamlineCandidate> result;
    for (const std::vector<StreamlineCandidate>& some : found)
    {
      result.insert(result.end(), some.begin(), some.end());
    }
    return result;
  }

  /// Candidates by chance, four in a square of the gap, those first where directions are defined best.
  std::vector<StreamlineCandidate> scattered(int level) const
  {
    const double gap = this->Tracer.gap() * this->Options.spacing;
    const auto count = static_cast<std::size_t>(std::ceil(4.0 * this->Mesh.area() / (gap * gap)));
    const std::vector<SurfaceSample> samples = sampleWhiteNoise(
      this->Mesh.mesh(), this->Areas, count, hash(this->Options.seed, static_cast<std::uint64_t>(level)));
    std::vector<StreamlineCandidate> result;
    std::vector<std::optional<StreamlineCandidate>> found;
    // Most have no room.
    constexpr std::size_t most = 1 << 18;
    for (std::size_t first = 0; first < samples.size(); first += most)
    {
      found.assign(std::min(most, samples.size() - first), std::nullopt);
      parallelFor(found.size(),
        [&](std::size_t n)
        {
          const std::size_t i = first + n;
          const SurfaceSample& sample = samples[i];
          const MeshPoint at{ sample.triangle,
            { 1.0 - static_cast<double>(sample.b1) - static_cast<double>(sample.b2), sample.b1, sample.b2 } };
          if (!this->Mesh.isUsable(at.triangle))
          {
            return;
          }
          const std::uint32_t point = this->Mesh.nearestPoint(at);
          if (this->Grid.isNear(
                this->Tracer.sampleOf(at, this->Mesh.position(at)), this->Tracer.startDistance()))
          {
            return;
          }
          const float umbilic = this->Field.umbilics.empty() ? 0.0f : this->Field.umbilics[point];
          const auto undefined = static_cast<std::uint64_t>(15.0f * std::clamp(umbilic, 0.0f, 1.0f));
          found[n] = { undefined << 60 | hash(this->Options.seed, static_cast<std::uint64_t>(level), i) >> 4,
            at, this->Field.directions[point] };
        });
      for (const std::optional<StreamlineCandidate>& candidate : found)
      {
        if (candidate)
        {
          result.push_back(*candidate);
        }
      }
    }
    return result;
  }

  /// Makes the lines of all candidates that have room, in their order.
  /// @return false when stopped
  bool tryAll(std::vector<StreamlineCandidate> candidates)
  {
    parallelSort(candidates.begin(), candidates.end(),
      [](const StreamlineCandidate& a, const StreamlineCandidate& b)
      { return a.order != b.order ? a.order < b.order : a.at.triangle < b.at.triangle; });
    LineSampleGrid batch(static_cast<float>(this->Tracer.gap()));
    std::vector<std::optional<SpacedLine>> attempts;
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
      parallelFor(
        size, [&](std::size_t i) { attempts[i] = this->Tracer.trace(candidates[begin + i], this->Grid); });
      const std::size_t first = this->Lines.size();
      for (std::optional<SpacedLine>& attempt : attempts)
      {
        if (attempt && (batch.isEmpty() || this->Tracer.cut(*attempt, batch)))
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
      const LineSample sample = this->Tracer.sampleOf(middle->at, middle->position);
      middles.push_back(sample.position);
      normals.push_back(sample.normal);
    }
    for (const std::uint32_t n : progressiveOrder(middles, normals, {}, this->Options.seed))
    {
      this->Order.push_back(static_cast<std::uint32_t>(first + n));
    }
  }

  const MeshNavigation& Mesh;
  const LineField& Field;
  const EvenStreamlineOptions& Options;
  const Progress& Report;
  CumulativeArea Areas;
  SpacedTracer Tracer;
  std::vector<TracedLine> Lines;
  std::vector<std::uint32_t> Order;
  LineSampleGrid Grid{ 1.0f };
  double Done = 0.0; ///< about the share of all work up to this gap
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
  const double samples = mesh.area() / options.spacing / options.spacing / longestStep;
  check(samples < 0x1p28,
    "the surface needs " + std::to_string(samples) + " samples of lines at a spacing of " +
      std::to_string(options.spacing) + ", expected fewer than 268435456, so a larger spacing");
  if (!(mesh.area() > 0.0))
  {
    return {};
  }
  EvenStreamlineOptions own = options;
  own.trace.maximumStep = std::min(own.trace.maximumStep, longestStep * options.spacing);
  own.trace.closeDistance =
    own.trace.closeDistance > 0.0 ? own.trace.closeDistance : closeDistance * options.spacing;
  return Placement(mesh, normals, field, own, progress).run();
}

} // namespace ink
