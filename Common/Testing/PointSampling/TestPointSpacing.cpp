// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PointCloud/PointSpacing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

std::vector<glm::vec3> grid(int side, float spacing)
{
  std::vector<glm::vec3> points;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      points.emplace_back(spacing * x, spacing * y, 3.0f);
    }
  }
  return points;
}

} // namespace

TEST(PointSpacing, OfAGridIsItsDiagonal)
{
  for (float spacing : { 1e-6f, 0.5f, 1e6f })
  {
    EXPECT_NEAR(ink::discRadiusFromSpacing(grid(100, spacing)) / spacing, std::sqrt(2.0f), 1e-3f);
  }
}

TEST(PointSpacing, DoesNotDependOnTheNumberOfThreads)
{
  const auto points = grid(57, 0.3f);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const float one = ink::discRadiusFromSpacing(points);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  EXPECT_EQ(ink::discRadiusFromSpacing(points), one);
  unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(PointSpacing, PassesOverPointsThatAreNotFinite)
{
  auto points = grid(50, 1.0f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < points.size(); i += 39)
  {
    points[i] = i % 2 ? glm::vec3(nan, 0.0f, 0.0f) : glm::vec3(0.0f, infinite, 0.0f);
  }
  EXPECT_NEAR(ink::discRadiusFromSpacing(points), std::sqrt(2.0f), 0.6f);
}

/// As a mesh whose triangles share no vertices has them.
TEST(PointSpacing, PassesOverCopies)
{
  std::vector<glm::vec3> copies;
  for (const glm::vec3& point : grid(30, 0.5f))
  {
    copies.insert(copies.end(), 8, point);
  }
  const float radius = ink::discRadiusFromSpacing(copies);
  EXPECT_GE(radius, 0.5f);
  EXPECT_LE(radius, 0.5f * std::sqrt(2.0f) + 1e-3f);
}

TEST(PointSpacing, OfFewPoints)
{
  EXPECT_EQ(ink::discRadiusFromSpacing({}), 0.0f);
  const std::vector<glm::vec3> one{ { 1, 2, 3 } };
  EXPECT_EQ(ink::discRadiusFromSpacing(one), 0.0f);
  const std::vector<glm::vec3> two{ { 1, 2, 3 }, { 1, 2, 5 } };
  EXPECT_EQ(ink::discRadiusFromSpacing(two), 2.0f);
  const std::vector<glm::vec3> same(20, glm::vec3(4.0f));
  EXPECT_EQ(ink::discRadiusFromSpacing(same), 0.0f);
}
