// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/CurveVisibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace
{

using ink::CurvePoint;
using ink::CurveRun;

/// What lies before a parallel camera that looks along -z, distances 0 to 1000 in pixels.
struct View
{
  explicit View(const std::function<double(double, double)>& distance, int pixels = 200)
    : size(pixels)
  {
    for (int y = 0; y < this->size; ++y)
    {
      for (int x = 0; x < this->size; ++x)
      {
        this->depths.push_back(static_cast<float>(distance(x + 0.5, y + 0.5) / 1000.0));
      }
    }
  }

  ink::CurveOccluders occluders() const
  {
    return { { this->depths, this->size, this->size }, { -2.0 / 1000.0, -1.0, 0.0, 1.0 }, 1.0 };
  }

  CurvePoint at(double x, double y, double distance, double curvature = 0.0) const
  {
    return { { 2.0 * x / this->size - 1.0, 2.0 * y / this->size - 1.0, 2.0 * distance / 1000.0 - 1.0, 1.0 },
      curvature };
  }

  std::vector<float> depths;
  int size;
};

constexpr double nothing = 1000.0;

double hiddenShare(const std::vector<CurveRun>& runs)
{
  double hidden = 0.0;
  double all = 0.0;
  for (const CurveRun& run : runs)
  {
    hidden += run.hidden ? run.to - run.from : 0.0;
    all += run.to - run.from;
  }
  return hidden / all;
}

/// A wall over the left half.
double wall(double x, double)
{
  return x < 100.0 ? 300.0 : nothing;
}

/// A ring behind a broad bar and a narrow one: wherever it begins, the broad one alone hides it.
TEST(CurveVisibility, AShortPartBesideTheLongestRunJoinsIt)
{
  const View view(
    [](double x, double y) {
      return (x > 150 && std::abs(y - 100) < 20) || (x < 100 && std::abs(y - 130) < 1.5) ? 100.0 : nothing;
    });
  constexpr int count = 90;
  for (int shift = 0; shift < count; shift += 10)
  {
    for (const int direction : { -1, 1 })
    {
      std::vector<CurvePoint> ring;
      for (int i = 0; i < count; ++i)
      {
        const double angle = 2.0 * std::numbers::pi * (direction * i + shift) / count;
        ring.push_back(view.at(100 + 80 * std::cos(angle), 100 + 80 * std::sin(angle), 500));
      }
      const double share = hiddenShare(ink::findVisibleRuns(ring, true, view.occluders(), 8.0));
      EXPECT_NEAR(share, 2.0 * std::asin(20.0 / 80.0) / (2.0 * std::numbers::pi), 0.01)
        << shift << ' ' << direction;
    }
  }
}

/// Whether the run that holds a position is hidden.
bool isHiddenAt(const std::vector<CurveRun>& runs, double position, std::size_t segments)
{
  const auto holds = [&](const CurveRun& run)
  {
    const double next = position + static_cast<double>(segments);
    return (run.from <= position && position < run.to) || (run.from <= next && next < run.to);
  };
  const auto run = std::find_if(runs.begin(), runs.end(), holds);
  EXPECT_NE(run, runs.end());
  return run != runs.end() && run->hidden;
}

/// Of two long parts, one behind a wall, the image's corner shows five pixels of the other: no neighbor takes
/// them, as they go on beyond it.
TEST(CurveVisibility, WhatGoesOnBeyondTheImageIsNotShort)
{
  for (const bool hiddenCorner : { false, true })
  {
    const View view([&](double x, double) { return (x < 100.0) != hiddenCorner ? 300.0 : nothing; });
    for (const bool closed : { false, true })
    {
      std::vector<CurvePoint> line{ view.at(20, 50, 500), view.at(80, 50, 500), view.at(80, -50, 500),
        view.at(197, -50, 500), view.at(197, 3, 500), view.at(300, 3, 500) };
      if (closed)
      {
        line.push_back(view.at(300, -60, 500));
        line.push_back(view.at(20, -60, 500));
      }
      for (int turn = 0; turn < (closed ? static_cast<int>(line.size()) : 1); ++turn)
      {
        const auto runs = findVisibleRuns(line, closed, view.occluders(), 8.0);
        const auto positionOf = [&](double position)
        {
          const double turned = position - turn;
          return turned < 0.0 ? turned + static_cast<double>(line.size()) : turned;
        };
        EXPECT_EQ(isHiddenAt(runs, positionOf(0.5), line.size()), !hiddenCorner) << closed << ' ' << turn;
        EXPECT_EQ(isHiddenAt(runs, positionOf(3.99), line.size()), hiddenCorner) << closed << ' ' << turn;
        std::rotate(line.begin(), line.begin() + 1, line.end());
      }
    }
  }
}

TEST(CurveVisibility, WhatLiesBehindByLessThanTheToleranceIsVisible)
{
  const View view([](double, double) { return 400.0; });
  ink::CurveOccluders occluders = view.occluders();
  for (const double behind : { 5.0, 100.0 }) // near and far, by pixels
  {
    const std::vector<CurvePoint> line{ view.at(20, 100, 400.0 + behind), view.at(180, 100, 400.0 + behind) };
    occluders.tolerance = 1.1 * behind;
    EXPECT_EQ(hiddenShare(ink::findVisibleRuns(line, false, occluders, 4.0)), 0.0) << behind;
    occluders.tolerance = 0.9 * behind - 1.0;
    EXPECT_EQ(hiddenShare(ink::findVisibleRuns(line, false, occluders, 4.0)), 1.0) << behind;
  }
}

} // namespace

TEST(CurveVisibility, BehindAWall)
{
  const View view(wall);
  for (const double shift : { 0.0, 0.3, 0.9 })
  {
    const std::vector<CurvePoint> line{ view.at(20.0 + shift, 50.0, 500.0),
      view.at(180.0 + shift, 50.0, 500.0) };
    const auto runs = findVisibleRuns(line, false, view.occluders(), 4.0);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_TRUE(runs[0].hidden && !runs[1].hidden);
    EXPECT_EQ(runs[0].from, 0.0);
    EXPECT_EQ(runs[0].to, runs[1].from);
    EXPECT_EQ(runs[1].to, 1.0);
    EXPECT_NEAR(runs[0].to, (80.0 - shift) / 160.0, 1.0 / 160.0) << "within a pixel of the wall's edge";
  }
  const std::vector<CurvePoint> before{ view.at(20.0, 50.0, 200.0), view.at(180.0, 50.0, 200.0) };
  EXPECT_EQ(hiddenShare(findVisibleRuns(before, false, view.occluders(), 4.0)), 0.0);
}

/// Half steps of the picture are not half the way where a line comes closer.
TEST(CurveVisibility, Perspective)
{
  View view(wall);
  const double near = 1.0;
  const double far = 1000.0;
  ink::CurveOccluders occluders = view.occluders();
  const double m[4] = { -(far + near) / (far - near), -2.0 * far * near / (far - near), -1.0, 0.0 };
  std::copy_n(m, 4, occluders.depthToClip);
  occluders.pixel = 2.0 / view.size;
  for (float& depth : view.depths)
  {
    const double distance = 1000.0 * depth < 999.0 ? 2.0 : far;
    depth = static_cast<float>(0.5 * (m[0] * -distance + m[1]) / distance + 0.5);
  }
  occluders.image.depths = view.depths;
  const auto at = [&](double x, double distance) -> CurvePoint {
    return { { x, 0.0, m[0] * -distance + m[1], distance } };
  };
  // From x = -2 to x = 4: a third of the way to the wall's edge at x = 0.
  const std::vector<CurvePoint> line{ at(-2.0, 4.0), at(4.0, 40.0) };
  const auto runs = findVisibleRuns(line, false, occluders, 4.0);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_NEAR(runs[0].to, 1.0 / 3.0, 0.1 / 3.0);
}

/// The outline of a sphere lies on it, and is not hidden by it, wherever the pixels are.
TEST(CurveVisibility, OwnSurface)
{
  for (const double radius : { 20.0, 60.0, 90.0 })
  {
    const double middle = 100.0 + radius / 300.0;
    const View view(
      [&](double x, double y)
      {
        const double square = radius * radius - (x - middle) * (x - middle) - (y - middle) * (y - middle);
        return square > 0.0 ? 500.0 - std::sqrt(square) : nothing;
      });
    std::vector<CurvePoint> outline;
    std::vector<CurvePoint> equator;
    for (int i = 0; i < 500; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * i / 500;
      const double c = radius * std::cos(angle);
      const double s = radius * std::sin(angle);
      outline.push_back(view.at(middle + c, middle + s, 500.0));
      equator.push_back(view.at(middle + c, middle, 500.0 - s));
    }
    EXPECT_EQ(hiddenShare(findVisibleRuns(outline, true, view.occluders(), 4.0)), 0.0) << radius;
    for (CurvePoint& point : outline)
    {
      point.radialCurvature = -1.0;
    }
    EXPECT_EQ(hiddenShare(findVisibleRuns(outline, true, view.occluders(), 4.0)), 1.0) << radius;
    const auto runs = findVisibleRuns(equator, true, view.occluders(), 4.0);
    ASSERT_EQ(runs.size(), 2u) << radius;
    EXPECT_NEAR(hiddenShare(runs), 0.5, std::acos(1.0 - 2.0 / radius) / std::numbers::pi)
      << radius << ": within two pixels of the outline";
  }
}

/// Of a surface that is nearly flat across its outline, with normals that are two degrees off: the silhouette
/// lies more than a pixel within the outline, and far behind it.
TEST(CurveVisibility, FlatSurface)
{
  constexpr double radius = 3000.0;
  constexpr double outline = 150.0;
  constexpr double middle = 600.0;
  const double angle = 2.0 * std::numbers::pi / 180.0;
  const double x = outline - radius * (1.0 - std::cos(angle));
  const double distance = middle + radius * std::sin(angle);
  ASSERT_LT(x, outline - 1.5);
  const auto surface = [&](double at)
  {
    const double inside = outline - at;
    return inside > 0.0 ? std::max(middle - std::sqrt((2.0 * radius - inside) * inside), 0.0) : nothing;
  };
  const auto share = [&](const View& view, const glm::dvec2& normal)
  {
    std::vector<CurvePoint> line{ view.at(x, 20.0, distance), view.at(x, 180.0, distance) };
    line[0].normal = line[1].normal = normal;
    return hiddenShare(findVisibleRuns(line, false, view.occluders(), 4.0));
  };
  const View alone([&](double at, double) { return surface(at); });
  const View behindABar(
    [&](double at, double y) { return y < 100.0 && std::abs(at - x) < 5.0 ? 100.0 : surface(at); });
  // Whichever way normals point.
  for (const glm::dvec2& normal : { glm::dvec2(1.0, 0.0), glm::dvec2(-1.0, 0.0) })
  {
    EXPECT_EQ(share(alone, normal), 0.0) << normal.x;
    EXPECT_NEAR(share(behindABar, normal), 0.5, 1.0 / 80.0) << normal.x;
  }
  EXPECT_EQ(share(alone, { 0.0, 1.0 }), 1.0) << "along the outline";
  EXPECT_EQ(share(alone, { 0.0, 0.0 }), 1.0) << "not known";
}

/// Of the same surface, whose normals are smoothed more than it is: what goes along within its outline is
/// meant for that, what goes below it is not.
TEST(CurveVisibility, WithinTheOutlineOfARougherSurface)
{
  constexpr double outline = 150.0;
  const View view([](double x, double)
    { return x < outline ? 600.0 - std::sqrt((6000.0 - (outline - x)) * (outline - x)) : nothing; });
  ink::CurveOccluders occluders = view.occluders();
  occluders.withinOutline = 100.0;
  const auto share = [&](const std::vector<CurvePoint>& line)
  { return hiddenShare(findVisibleRuns(line, false, occluders, 4.0)); };
  const auto along = [&](double x, double distance, const glm::dvec2& normal)
  {
    std::vector<CurvePoint> line{ view.at(x, 20.0, distance), view.at(x, 180.0, distance) };
    line[0].normal = line[1].normal = normal;
    return line;
  };
  const glm::dvec2 outwards(1.0, 0.0);
  EXPECT_EQ(share(along(144.0, 600.0, outwards)), 1.0) << "its normals are its own";
  occluders.tolerance = 70.0;
  EXPECT_EQ(share(along(144.0, 600.0, outwards)), 0.0);
  EXPECT_EQ(share(along(144.0, 600.0, {})), 0.0) << "a border";
  EXPECT_EQ(share(along(144.0, 600.0, { 0.0, 1.0 })), 1.0) << "not its outline";
  EXPECT_EQ(share(along(144.0, 600.0, -outwards)), 0.0) << "whichever way normals point";
  EXPECT_EQ(share(along(144.0, 610.0, outwards)), 0.0);
  EXPECT_EQ(share(along(144.0, 635.0, outwards)), 1.0) << "too far behind";
  std::vector<CurvePoint> away = along(144.0, 600.0, outwards);
  away[0].radialCurvature = away[1].radialCurvature = -1.0;
  EXPECT_EQ(share(away), 1.0) << "the surface hides its own side";
  occluders.withinOutline = 4.0;
  EXPECT_EQ(share(along(144.0, 600.0, outwards)), 1.0) << "too far within";
  occluders.withinOutline = 7.0;
  EXPECT_EQ(share(along(144.0, 600.0, outwards)), 0.0);
  occluders.withinOutline = 100.0;
  EXPECT_EQ(ink::outlineMargin(10.0), 50.0);
  const std::vector<CurvePoint> ends{ view.at(144.0, 50.0, 600.0), view.at(144.0, 80.0, 600.0) };
  EXPECT_EQ(share(ends), 0.0) << "nothing is known of what is before and behind";
  const std::vector<CurvePoint> entering{ view.at(144.0, -20.0, 600.0), view.at(144.0, 30.0, 600.0) };
  EXPECT_LT(share(entering), 0.5) << "nor of what is beyond the image";
  const std::vector<CurvePoint> below{ view.at(190.0, 20.0, 600.0), view.at(90.0, 120.0, 600.0) };
  EXPECT_NEAR(share(below), 0.6, 0.03);
  const std::vector<CurvePoint> dips{ view.at(160.0, 20.0, 600.0), view.at(145.0, 60.0, 600.0),
    view.at(160.0, 100.0, 600.0) };
  EXPECT_EQ(share(dips), 0.0) << "seen before and behind";
  // A closed one, wherever it begins: a side within the outline.
  const std::vector<glm::dvec2> corners{ { 144.0, 20.0 }, { 144.0, 180.0 }, { 60.0, 180.0 }, { 60.0, 20.0 } };
  std::vector<CurvePoint> square;
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    for (const double t : { 0.0, 0.25, 0.5, 0.75 })
    {
      const glm::dvec2 at = glm::mix(corners[corner], corners[(corner + 1) % 4], t);
      square.push_back(view.at(at.x, at.y, 600.0));
    }
  }
  for (std::size_t begin = 0; begin < square.size(); ++begin)
  {
    EXPECT_NEAR(hiddenShare(findVisibleRuns(square, true, occluders, 4.0)), 0.75, 0.04) << begin;
    std::rotate(square.begin(), square.begin() + 1, square.end());
  }
}

/// The same runs wherever a closed curve begins.
TEST(CurveVisibility, ClosedCurve)
{
  const View view(wall);
  for (int first = 0; first < 40; first += 3)
  {
    std::vector<CurvePoint> circle;
    for (int i = 0; i < 40; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * (i + first) / 40;
      circle.push_back(view.at(100.0 + 50.0 * std::cos(angle), 100.0 + 50.0 * std::sin(angle), 400.0));
    }
    const auto runs = findVisibleRuns(circle, true, view.occluders(), 4.0);
    ASSERT_EQ(runs.size(), 2u) << first;
    EXPECT_NE(runs[0].hidden, runs[1].hidden);
    EXPECT_NEAR(hiddenShare(runs), 0.5, 0.01) << first;
    EXPECT_NEAR(std::remainder(runs[0].to - runs[1].from, 40.0), 0.0, 1e-12);
    EXPECT_NEAR(std::remainder(runs[1].to - runs[0].from, 40.0), 0.0, 1e-12);
    for (const CurveRun& run : runs)
    {
      EXPECT_TRUE(run.from >= 0.0 && run.from < 40.0 && run.to > run.from) << run.from << " to " << run.to;
    }
  }
}

/// A fence of narrow posts: no dotted line behind it, and one behind wide posts.
TEST(CurveVisibility, ShortRuns)
{
  const auto fence = [](double width)
  { return View([=](double x, double) { return std::fmod(x, 40.0) < width ? 300.0 : nothing; }); };
  for (const double width : { 5.0, 20.0 })
  {
    const View view = fence(width);
    const std::vector<CurvePoint> line{ view.at(21.0, 50.0, 500.0), view.at(179.0, 50.0, 500.0) };
    const auto runs = findVisibleRuns(line, false, view.occluders(), 8.0);
    EXPECT_EQ(runs.size(), width < 8.0 ? 1u : 9u - 1u) << width;
    EXPECT_FALSE(runs.back().hidden && width < 8.0);
  }
}

TEST(CurveVisibility, DegenerateInput)
{
  const View view(wall);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto runs = [&](std::vector<CurvePoint> points, bool closed)
  { return findVisibleRuns(points, closed, view.occluders(), 4.0); };
  EXPECT_TRUE(runs({}, false).empty());
  EXPECT_TRUE(runs({ view.at(1.0, 1.0, 1.0) }, true).empty());
  for (const auto& odd : { view.at(nan, 1.0, 1.0), view.at(900.0, -900.0, 500.0), view.at(10.0, 10.0, -50.0),
         CurvePoint{ { 0.0, 0.0, 0.0, 0.0 } }, CurvePoint{ { 1.0, 0.0, -2.0, -1.0 } } })
  {
    const auto found = runs({ odd, odd, view.at(150.0, 50.0, 500.0) }, false);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().from, 0.0);
    EXPECT_EQ(found.back().to, 2.0);
    EXPECT_FALSE(found.back().hidden);
  }
  const ink::CurveOccluders wrong{ { view.depths, 3, 3 } };
  EXPECT_THROW(findVisibleRuns({}, false, wrong, 4.0), std::invalid_argument);
}
