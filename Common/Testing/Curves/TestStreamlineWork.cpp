// SPDX-License-Identifier: BSD-3-Clause
// The work of evenly spaced lines is in proportion to the squares of the spacing that cover the surface,
// however rough it is: tries, walks and steps are counted, not timed.

#include "Curves/Streamlines/StreamlinePlacement.h"

#include "Core/Hash.h"
#include "SampledMeshes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// The unit square with a direction and a normal for each of its cells, both by chance: neighbors have
/// nothing in common. It counts what it is asked for.
class RoughSquare
{
public:
  using Point = glm::dvec2;

  struct Roughness
  {
    std::string name;
    double cells;    ///< along a side
    double turn;     ///< of directions to either side, as a share of half a turn
    double inclined; ///< of normals to either side, as a share of half a turn
  };

  struct Work
  {
    std::atomic<std::size_t> walks = 0;
    std::atomic<std::size_t> lines = 0; ///< that were traced, kept or not
    std::atomic<std::size_t> steps = 0; ///< of these
  };

  RoughSquare(const Roughness& roughness, double step, Work& work)
    : Rough(roughness)
    , Step(step)
    , Done(work)
  {
  }

  double area() const { return 1.0; }
  glm::dvec3 center() const { return { 0.5, 0.5, 0.0 }; }
  glm::dvec3 position(const Point& at) const { return { at, 0.0 }; }
  glm::vec3 normal(const Point& at) const
  {
    const double angle = this->Rough.inclined * std::numbers::pi * this->chance(at, 1);
    return { static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(std::cos(angle)) };
  }
  glm::dvec3 planeNormal(const Point&) const { return { 0.0, 0.0, 1.0 }; }
  SurfaceDirection ownDirection(const Point& at) const
  {
    const double angle = this->Rough.turn * std::numbers::pi * this->chance(at, 2);
    return { { std::cos(angle), std::sin(angle), 0.0 }, 0.0f };
  }
  glm::dvec3 direction(const Point& at, const glm::dvec3& heading) const
  {
    const glm::dvec3 own = this->ownDirection(at).direction;
    return glm::dot(own, heading) < 0.0 ? -own : own;
  }
  std::optional<SurfaceArrival<Point>> walk(
    const Point& from, const glm::dvec3& direction, double distance) const
  {
    ++this->Done.walks;
    const glm::dvec3 heading = glm::normalize(direction);
    const Point to = from + distance * glm::dvec2(heading);
    return isInside(to) ? std::optional<SurfaceArrival<Point>>({ to, heading }) : std::nullopt;
  }
  TracedLineOn<Point> trace(
    const Point& seed, const glm::dvec3& heading, const AcceptPoint<Point>& accept) const
  {
    ++this->Done.lines;
    return traceHalves(seed, this->position(seed), this->direction(seed, heading), 0.0, accept,
      [&](const glm::dvec3& along, const AcceptPoint<Point>& go)
      {
        Point at = seed;
        glm::dvec3 ahead = along;
        for (double arc = this->Step;; arc += this->Step)
        {
          ++this->Done.steps;
          ahead = this->direction(at, ahead);
          at += this->Step * glm::dvec2(ahead);
          if (!isInside(at))
          {
            return LineEnd::Border;
          }
          if (!go({ at, this->position(at), arc }))
          {
            return LineEnd::Stopped;
          }
        }
      });
  }
  std::vector<std::uint64_t> scatter(std::size_t count, std::uint64_t seed) const
  {
    std::vector<std::uint64_t> result;
    for (std::size_t i = 0; i < count; ++i)
    {
      result.push_back(hash(seed, i));
    }
    return result;
  }
  std::optional<Point> pointOf(std::uint64_t random) const
  {
    return Point(unitDouble(hash(random, 1)), unitDouble(hash(random, 2)));
  }
  static bool isBefore(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

private:
  static bool isInside(const Point& at) { return at.x >= 0.0 && at.x <= 1.0 && at.y >= 0.0 && at.y <= 1.0; }
  /// In (-1, 1), the same in all of a cell.
  double chance(const Point& at, std::uint64_t id) const
  {
    const glm::dvec2 cell = glm::floor(at * this->Rough.cells);
    return 2.0 *
      unitDouble(hash(static_cast<std::uint64_t>(cell.x), static_cast<std::uint64_t>(cell.y), id)) -
      1.0;
  }

  const Roughness& Rough;
  double Step;
  Work& Done;
};

StreamlinesOn<glm::dvec2> linesOn(
  const RoughSquare::Roughness& roughness, double spacing, RoughSquare::Work& work)
{
  EvenStreamlineOptions options;
  options.spacing = spacing;
  options = completeOptions(options, 1.0);
  const RoughSquare square(roughness, options.trace.maximumStep, work);
  return StreamlinePlacement<RoughSquare>(square, options, {}).run();
}

struct Scene
{
  RoughSquare::Roughness roughness;
  double walks; ///< in a square of the spacing, at most
  double lines;
  double steps;
};

// Cells of 1/2, 2 and 5 spacings of 1/160. Directions by chance take no more work than none. Normals that lie
// in the plane tell lines side by side apart as if they were on sheets, so there are up to three times as
// many.
const Scene scenes[] = {
  { { "smooth", 1.0, 0.0, 0.0 }, 4.0, 0.1, 12.0 },
  { { "fine directions", 320.0, 1.0, 0.0 }, 4.0, 0.6, 9.0 },
  { { "directions", 80.0, 1.0, 0.0 }, 4.0, 0.6, 9.0 },
  { { "coarse directions", 32.0, 1.0, 0.0 }, 4.0, 0.6, 9.0 },
  { { "normals", 80.0, 0.0, 1.0 }, 10.0, 2.0, 40.0 },
  { { "coarse normals", 32.0, 0.0, 1.0 }, 10.0, 2.0, 40.0 },
  { { "both", 80.0, 1.0, 1.0 }, 5.0, 0.8, 12.0 },
};

} // namespace

TEST(StreamlineWork, IsBoundedByTheSquaresOfTheSpacing)
{
  for (const auto& [roughness, walks, lines, steps] : scenes)
  {
    for (const double across : { 40.0, 160.0 })
    {
      RoughSquare::Work work;
      const StreamlinesOn<glm::dvec2> made = linesOn(roughness, 1.0 / across, work);
      const std::string where = roughness.name + ", " + std::to_string(across) + " spacings across";
      const auto inASquare = [&](std::size_t count)
      { return static_cast<double>(count) / (across * across); };
      EXPECT_GT(made.lines.size(), 30u) << where;
      EXPECT_LT(inASquare(work.walks), walks) << where;
      EXPECT_LT(inASquare(work.lines), lines) << where;
      EXPECT_LT(inASquare(work.steps), steps) << where;
    }
  }
}

TEST(StreamlineWork, IsTheSameForAnyNumberOfThreads)
{
  for (const Scene& scene : scenes)
  {
    RoughSquare::Work works[2];
    const auto run = [&](int threads)
    { return onThreads(threads, [&] { return linesOn(scene.roughness, 1.0 / 80.0, works[threads - 1]); }); };
    const StreamlinesOn<glm::dvec2> one = run(1);
    const StreamlinesOn<glm::dvec2> two = run(2);
    EXPECT_EQ(one.positions, two.positions) << scene.roughness.name;
    EXPECT_EQ(works[0].walks, works[1].walks) << scene.roughness.name;
    EXPECT_EQ(works[0].steps, works[1].steps) << scene.roughness.name;
  }
}
