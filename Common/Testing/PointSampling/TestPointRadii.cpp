// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "PointSampling/PointCloud/PointRadii.h"
#include "PointSampling/PointCloud/PointSpacing.h"
#include "PointSampling/PoissonDisk.h"
#include "PointSampling/WhiteNoise.h"
#include "SampledMeshes.h"

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace
{

using namespace ink::test;

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

std::vector<float> radiiOf(const std::vector<glm::vec3>& points)
{
  return ink::pointRadii(points, {}).radius;
}

std::vector<glm::vec3> grid(int columns, int rows, float dx, float dy)
{
  std::vector<glm::vec3> points;
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < columns; ++x)
    {
      points.emplace_back(dx * static_cast<float>(x), dy * static_cast<float>(y), 3.0f);
    }
  }
  return points;
}

/// Independent points on the unit square: `count` candidates, each kept with the probability at its position.
std::vector<glm::vec3> scatter(std::size_t count, const std::function<float(glm::vec2)>& density)
{
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::vec2 position(ink::unitFloat(ink::hash(1, i)), ink::unitFloat(ink::hash(2, i)));
    if (ink::unitFloat(ink::hash(3, i)) < density(position))
    {
      points.emplace_back(position, 0.0f);
    }
  }
  return points;
}

// Twenty times as dense on the left as on the right, all at once and little by little.
float step(glm::vec2 position)
{
  return position.x < 0.5f ? 1.0f : 0.05f;
}
float slope(glm::vec2 position)
{
  return std::pow(0.05f, position.x);
}

/// The number of grid positions in the square, at least `border` from its boundary, that no disc covers.
int holes(const std::vector<glm::vec3>& points, const std::vector<float>& radii, float border)
{
  int found = 0;
  const int side = 90;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const glm::vec2 share = (glm::vec2(x, y) + 0.5f) / static_cast<float>(side);
      const glm::vec3 position(border + (1.0f - 2.0f * border) * share, 0.0f);
      bool covered = false;
      for (std::size_t i = 0; i < points.size() && !covered; ++i)
      {
        covered = glm::distance(points[i], position) <= radii[i];
      }
      found += covered ? 0 : 1;
    }
  }
  return found;
}

float meanOver(const std::vector<glm::vec3>& points, const std::vector<float>& radii, float low, float high)
{
  float sum = 0.0f;
  float number = 0.0f;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].x >= low && points[i].x < high)
    {
      sum += radii[i];
      number += 1.0f;
    }
  }
  return sum / number;
}

} // namespace

TEST(PointRadii, OfAGridAreItsHalfDiagonalAndAQuarterAlsoOnTheRim)
{
  for (const float spacing : { 1e-20f, 1e-6f, 0.5f, 1e6f, 1e20f })
  {
    for (const float radius : radiiOf(grid(20, 15, spacing, spacing)))
    {
      EXPECT_NEAR(radius / spacing, 1.25f * std::sqrt(0.5f), 1e-2f);
    }
  }
}

TEST(PointRadii, CoverScanLinesThatAreFartherApartThanTheirPoints)
{
  for (const float radius : radiiOf(grid(120, 20, 1.0f, 5.0f)))
  {
    EXPECT_NEAR(radius, 1.25f * std::hypot(0.5f, 2.5f), 0.05f);
  }
}

TEST(PointRadii, LeaveNoHolesWherePointsAreDenseOrSparse)
{
  for (const auto& density : { step, slope })
  {
    const auto points = scatter(12000, density);
    const auto radii = radiiOf(points);
    EXPECT_EQ(holes(points, radii, 0.04f), 0);
    EXPECT_EQ(std::count(radii.begin(), radii.end(), 0.0f), 0) << "taken for isolated";
    const float dense = meanOver(points, radii, 0.0f, 0.15f);
    const float sparse = meanOver(points, radii, 0.85f, 1.0f);
    EXPECT_GT(sparse, 2.5f * dense);
    // One radius for all has to be as wide as the sparse part needs it.
    const float one = ink::discRadiusFromSpacing(points);
    EXPECT_GT(holes(points, std::vector<float>(points.size(), one), 0.04f), 20);
    EXPECT_LT(dense, 1.6f * one);
  }
}

TEST(PointRadii, ChangeSlowlyFromPointToPoint)
{
  const auto points = scatter(6000, [](glm::vec2) { return 1.0f; });
  const auto radii = radiiOf(points);
  const float mean = meanOver(points, radii, 0.0f, 1.0f);
  double spread = 0.0;
  double between = 0.0;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    spread += std::pow(radii[i] / mean - 1.0f, 2) / static_cast<double>(radii.size());
    for (std::size_t j = 0; j < i; ++j)
    {
      if (glm::distance(points[i], points[j]) < 0.5f * mean)
      {
        between += std::abs(radii[i] - radii[j]) / mean;
        ++pairs;
      }
    }
  }
  EXPECT_LT(std::sqrt(spread), 0.25);
  EXPECT_LT(between / static_cast<double>(pairs), 0.06);
}

TEST(PointRadii, LeaveHolesOpen)
{
  const float hole = 0.2f;
  const glm::vec3 middle(0.5f, 0.5f, 0.0f);
  for (const auto& density : { step, slope })
  {
    const auto points = scatter(12000,
      [&](glm::vec2 position)
      { return glm::distance(glm::vec3(position, 0.0f), middle) < hole ? 0.0f : density(position); });
    const auto result = ink::pointRadii(points, {});
    EXPECT_EQ(result.isolatedCount, 0u);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const float out = glm::distance(points[i], middle);
      EXPECT_GT(out - result.radius[i], 0.3f * hole) << "reaches into the hole";
    }
    // Of the points to the left of the hole, those on its border are as those behind them.
    std::vector<float> border;
    std::vector<float> behind;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const float out = glm::distance(points[i], middle);
      if (std::abs(points[i].y - 0.5f) < 0.15f && points[i].x < 0.5f)
      {
        if (out < hole + 0.06f)
        {
          (out < hole + 0.01f ? border : behind).push_back(result.radius[i]);
        }
      }
    }
    ASSERT_GT(border.size(), 10u);
    const auto mean = [](const std::vector<float>& values)
    { return std::accumulate(values.begin(), values.end(), 0.0f) / static_cast<float>(values.size()); };
    EXPECT_LT(mean(border), 1.5f * mean(behind));
  }
}

TEST(PointRadii, OfACurvedSurfaceCoverIt)
{
  const Mesh mesh = torus(1.0, 0.4, 120, 60);
  const auto areas = ink::cumulateArea(mesh.view());
  const auto exact = positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), areas, 6000, 3));
  const std::vector<glm::vec3> points(exact.begin(), exact.end());
  const auto radii = radiiOf(points);
  for (const glm::dvec3& position :
    positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), areas, 4000, 99)))
  {
    bool covered = false;
    for (std::size_t i = 0; i < points.size() && !covered; ++i)
    {
      covered = glm::distance(points[i], glm::vec3(position)) <= radii[i];
    }
    EXPECT_TRUE(covered);
  }
}

TEST(PointRadii, DoNotDependOnCopiesOrOnOtherUnits)
{
  const auto points = scatter(1500, slope);
  const auto radii = radiiOf(points);
  std::vector<glm::vec3> copies;
  for (const glm::vec3& point : points)
  {
    copies.insert(copies.end(), 40, point);
  }
  const auto ofCopies = radiiOf(copies);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(ofCopies[40 * i], radii[i]);
    EXPECT_EQ(ofCopies[40 * i + 39], radii[i]);
  }
}

TEST(PointRadii, OfThinSheetsAreThoseOfEachSide)
{
  const auto front = scatter(1500, [](glm::vec2) { return 1.0f; });
  const std::vector<float> alone =
    ink::pointRadii(front, std::vector<glm::vec3>(front.size(), { 0, 0, 1 })).radius;
  std::vector<glm::vec3> both = front;
  std::vector<glm::vec3> normals(front.size(), { 0, 0, 1 });
  for (const glm::vec3& point : front)
  {
    both.emplace_back(1.0f - point.y, point.x, -1e-3f);
    normals.emplace_back(0, 0, -1);
  }
  const auto radii = ink::pointRadii(both, normals).radius;
  EXPECT_EQ(
    holes(front, { radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(front.size()) }, 0.04f), 0);
  float ratio = 0.0f;
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    ratio += radii[i] / alone[i] / static_cast<float>(front.size());
  }
  EXPECT_NEAR(ratio, 1.0f, 0.1f);
}

TEST(PointRadii, AreZeroForPointsOfNoSurface)
{
  auto points = scatter(8000, step);
  const std::size_t surface = points.size();
  for (int i = 0; i < 5; ++i)
  {
    const auto x = static_cast<float>(i);
    // One, copies of one, and three together, on all sides of the surface.
    points.emplace_back(0.25f * x, std::fmod(0.6f * x, 1.0f), 0.3f);
    points.insert(points.end(), 50, glm::vec3(std::cos(x), std::sin(x), -0.5f));
    const glm::vec3 far(2.0f * std::sin(x), 0.2f * x, 2.0f * std::cos(x));
    points.push_back(far);
    points.push_back(far + glm::vec3(1e-3f, 0, 0));
    points.push_back(far - glm::vec3(0, 1e-3f, 0));
  }
  const auto result = ink::pointRadii(points, {});
  EXPECT_EQ(result.isolatedCount, points.size() - surface);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(result.isolated[i] != 0, i >= surface);
    EXPECT_EQ(result.radius[i] > 0.0f, i < surface);
  }
}

TEST(PointRadii, OfExtremes)
{
  EXPECT_TRUE(radiiOf({}).empty());
  EXPECT_EQ(radiiOf({ { 1, 2, 3 } }), std::vector<float>{ 0.0f });
  EXPECT_EQ(radiiOf(std::vector<glm::vec3>(40, glm::vec3(5.0f))), std::vector<float>(40, 0.0f));
  EXPECT_EQ(radiiOf({ { notANumber, 0, 0 }, { 1, 0, 0 } }), std::vector<float>(2, 0.0f));
  EXPECT_EQ(radiiOf({ { 1, 0, 0 }, { 3, 0, 0 } }), std::vector<float>(2, 2.5f));
  EXPECT_EQ(radiiOf({ { 1, 0, 0 }, { notANumber, 0, 0 }, { 3, 0, 0 } })[1], 0.0f);
  std::vector<glm::vec3> line;
  for (int i = 0; i < 60; ++i)
  {
    line.emplace_back(i, 2 * i, 3 * i);
  }
  for (const float radius : radiiOf(line))
  {
    EXPECT_TRUE(std::isfinite(radius));
    EXPECT_GT(radius, std::sqrt(14.0f));
  }
  const float most = std::numeric_limits<float>::max();
  for (const float radius : radiiOf({ { -most, 0, 0 }, { most, 0, 0 }, { 0, most, 0 } }))
  {
    EXPECT_TRUE(radius >= 0.0f);
  }
}

TEST(PointRadii, AreTheSameOnAnyNumberOfThreads)
{
  const auto points = scatter(6000, step);
  const auto run = [&] { return radiiOf(points); };
  EXPECT_EQ(onThreads(1, run), onThreads(2, run));
}

TEST(PointRadii, CanBeStopped)
{
  const auto points = scatter(4000, step);
  EXPECT_TRUE(ink::pointRadii(points, {}, [](double) { return false; }).radius.empty());
}
