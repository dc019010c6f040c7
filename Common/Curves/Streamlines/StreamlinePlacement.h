// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Hash.h"
#include "Core/ParallelFor.h"
#include "Core/ParallelSort.h"
#include "Core/Progress.h"
#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/LineSampleGrid.h"
#include "Curves/Streamlines/LineSurface.h"
#include "Curves/Streamlines/SpacedTracer.h"
#include "Curves/Streamlines/Streamlines.h"
#include "PointSampling/ProgressiveOrder.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace ink
{

/// Places evenly spaced lines on a surface: those made so far, and how more are made.
///
/// Candidates are traced in parallel against the lines that there were before, and then accepted one by one,
/// cut where they meet those accepted meanwhile: the result is that of one thread, for any number of them.
template <LineSurface Surface>
class StreamlinePlacement
{
public:
  using Point = typename Surface::Point;

  /// The arguments are viewed and have to live as long.
  StreamlinePlacement(const Surface& surface, const EvenStreamlineOptions& options, const Progress& progress)
    : On(surface)
    , Options(options)
    , Report(progress)
    , Tracer(surface, options)
  {
  }

  /// @return the lines; none when stopped
  StreamlinesOn<Point> run()
  {
    const double widest = 0.25 * std::sqrt(this->On.area()) / this->Options.spacing;
    const int levels = widest > 1.0 ? static_cast<int>(std::log2(widest)) : 0;
    for (int level = 0; level <= levels; ++level)
    {
      if (!this->fill(levels - level))
      {
        return {};
      }
    }
    return joinLines<Point>(this->Lines, this->Order);
  }

private:
  using Candidate = StreamlineCandidate<Point>;

  /// From which umbilic measure on it means little which of two directions is called which.
  static constexpr float leastUmbilic = 0.5f;
  static constexpr std::size_t fewCandidates = 256;

  /// Which way a line beside another one starts: that of the field's name, or where names mean little, that
  /// of the other line.
  glm::dvec3 headingAt(const Point& at, const glm::dvec3& other) const
  {
    const SurfaceDirection own = this->On.ownDirection(at);
    return own.umbilic > leastUmbilic || own.direction == glm::dvec3(0.0) ? other : own.direction;
  }

  /// Fills the surface with lines at 2^halvings spacings.
  /// @return false when stopped
  bool fill(int halvings)
  {
    this->Tracer.setGap(std::ldexp(1.0, halvings));
    this->Grid = LineSampleGrid(static_cast<float>(this->Tracer.gap()));
    const std::size_t first = this->Lines.size();
    std::vector<std::vector<LineSample>> samples(first);
    parallelFor(first,
      [&](std::size_t n)
      {
        const std::vector<TracedPointOn<Point>>& points = this->Lines[n].points;
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
  std::vector<Candidate> besideLines(std::size_t begin, std::size_t end) const
  {
    std::vector<std::vector<Candidate>> found(end - begin);
    const double gap = this->Tracer.gap() * this->Options.spacing;
    parallelFor(end - begin,
      [&](std::size_t n)
      {
        const std::vector<TracedPointOn<Point>>& points = this->Lines[begin + n].points;
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
          const glm::dvec3 across = glm::cross(this->On.planeNormal(points[i].at), along);
          for (std::uint64_t side = 0; side < 2; ++side)
          {
            const auto reached = this->On.walk(points[i].at, side == 0 ? across : -across, gap);
            if (reached && this->hasRoom(reached->at))
            {
              const glm::dvec3 heading = glm::cross(this->On.planeNormal(reached->at), reached->heading);
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
    const double gap = this->Tracer.gap() * this->Options.spacing;
    const auto count = static_cast<std::size_t>(std::ceil(4.0 * this->On.area() / (gap * gap)));
    const auto seed = static_cast<std::uint64_t>(level);
    const auto samples = this->On.scatter(count, hash(this->Options.seed, seed));
    std::vector<Candidate> result;
    std::vector<std::optional<Candidate>> found;
    // Most have no room.
    constexpr std::size_t most = 1 << 18;
    for (std::size_t first = 0; first < samples.size(); first += most)
    {
      found.assign(std::min(most, samples.size() - first), std::nullopt);
      parallelFor(found.size(),
        [&](std::size_t n)
        {
          const std::size_t i = first + n;
          const std::optional<Point> at = this->On.pointOf(samples[i]);
          if (!at || !this->hasRoom(*at))
          {
            return;
          }
          const SurfaceDirection own = this->On.ownDirection(*at);
          const auto undefined = static_cast<std::uint64_t>(15.0f * std::clamp(own.umbilic, 0.0f, 1.0f));
          found[n] = { undefined << 60 | hash(this->Options.seed, seed, i) >> 4, *at, own.direction };
        });
      for (const std::optional<Candidate>& candidate : found)
      {
        if (candidate)
        {
          result.push_back(*candidate);
        }
      }
    }
    return result;
  }

  /// Whether a line may start at a point.
  bool hasRoom(const Point& at) const
  {
    return !this->Grid.isNear(this->Tracer.sampleOf(at, this->On.position(at)), this->Tracer.startDistance());
  }

  /// Makes the lines of all candidates that have room, in their order.
  /// @return false when stopped
  bool tryAll(std::vector<Candidate> candidates)
  {
    parallelSort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b)
      { return a.order != b.order ? a.order < b.order : Surface::isBefore(a.at, b.at); });
    LineSampleGrid batch(static_cast<float>(this->Tracer.gap()));
    std::vector<std::optional<SpacedLine<Point>>> attempts;
    std::vector<std::size_t> open;
    for (std::size_t begin = 0; begin < candidates.size();)
    {
      // Lines that are this far apart fill the surface when they are about as long in all as here.
      const double full = this->On.area() / this->Options.spacing;
      if (this->Report && !this->Report(std::min(this->Length / full, 1.0)))
      {
        return false;
      }
      // Few at first, when lines are long and most candidates are beside the same ones.
      const std::size_t size =
        std::min(std::clamp<std::size_t>(this->Lines.size() / 8, 16, 2048), candidates.size() - begin);
      open.clear();
      for (std::size_t i = begin; i < begin + size; ++i)
      {
        // Of a few candidates most have no room: to look takes less than to wake threads.
        if (size > fewCandidates || this->hasRoom(candidates[i].at))
        {
          open.push_back(i);
        }
      }
      attempts.assign(open.size(), std::nullopt);
      parallelFor(open.size(),
        [&](std::size_t n) { attempts[n] = this->Tracer.trace(candidates[open[n]], this->Grid); });
      const std::size_t first = this->Lines.size();
      for (std::optional<SpacedLine<Point>>& attempt : attempts)
      {
        if (attempt && (batch.isEmpty() || this->Tracer.cut(*attempt, batch)))
        {
          for (const LineSample& sample : attempt->samples)
          {
            batch.insert(sample);
            this->Grid.insert(sample);
          }
          this->Length += attempt->line.points.back().arc - attempt->line.points.front().arc;
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
      const std::vector<TracedPointOn<Point>>& points = this->Lines[n].points;
      const double half = 0.5 * (points.front().arc + points.back().arc);
      const auto middle = std::partition_point(points.begin(), points.end() - 1,
        [&](const TracedPointOn<Point>& point) { return point.arc < half; });
      const LineSample sample = this->Tracer.sampleOf(middle->at, middle->position);
      middles.push_back(sample.position);
      normals.push_back(sample.normal);
    }
    for (const std::uint32_t n : progressiveOrder(middles, normals, {}, this->Options.seed))
    {
      this->Order.push_back(static_cast<std::uint32_t>(first + n));
    }
  }

  const Surface& On;
  const EvenStreamlineOptions& Options;
  const Progress& Report;
  SpacedTracer<Surface> Tracer;
  std::vector<TracedLineOn<Point>> Lines;
  std::vector<std::uint32_t> Order;
  LineSampleGrid Grid{ 1.0f };
  double Length = 0.0; ///< of all lines
};

} // namespace ink
