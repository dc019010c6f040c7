// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceStretch.h"

#include "Core/Hash.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace ink::test;

} // namespace

TEST(SurfaceStretch, IsTheLargerSingularValue)
{
  // Scaled by 3 and by 0.5 along two axes at right angles, then turned: from any triangle.
  const glm::dvec3 first(0.6, 0.8, 0.0);
  const glm::dvec3 second(-0.8, 0.6, 0.0);
  const glm::dvec3 firstNow(0.0, 3.0, 0.0);
  const glm::dvec3 secondNow(0.0, 0.0, 0.5);
  for (std::uint64_t i = 0; i < 50; ++i)
  {
    glm::dvec3 before[3];
    glm::dvec3 now[3];
    for (std::uint64_t corner = 0; corner < 3; ++corner)
    {
      const double s = ink::unitFloat(ink::hash(3 * i + corner, 1));
      const double t = ink::unitFloat(ink::hash(3 * i + corner, 2));
      before[corner] = s * first + t * second;
      now[corner] = s * firstNow + t * secondNow + glm::dvec3(5.0, 6.0, 7.0);
    }
    EXPECT_NEAR(ink::largestStretch(before, now), 3.0, 1e-9);
  }
}

TEST(SurfaceStretch, OfExtremes)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 one[3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const glm::dvec3 line[3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  const glm::dvec3 longer[3] = { { 0, 0, 0 }, { 3, 0, 0 }, { 6, 0, 0 } };
  const glm::dvec3 point[3] = { { 2, 2, 2 }, { 2, 2, 2 }, { 2, 2, 2 } };
  const glm::dvec3 broken[3] = { { 0, 0, 0 }, { nan, 0, 0 }, { 0, 1, 0 } };
  EXPECT_DOUBLE_EQ(ink::largestStretch(one, one), 1.0);
  EXPECT_DOUBLE_EQ(ink::largestStretch(line, longer), 3.0);
  EXPECT_DOUBLE_EQ(ink::largestStretch(one, point), 0.0);
  EXPECT_DOUBLE_EQ(ink::largestStretch(point, one), 1.0);
  EXPECT_DOUBLE_EQ(ink::largestStretch(one, broken), 1.0);
  EXPECT_DOUBLE_EQ(ink::largestStretch(broken, one), 1.0);
}

TEST(SurfaceStretch, IsLocalAndReachesAsFarAsIsAsked)
{
  const Mesh before = square(20);
  Mesh now = before;
  for (glm::dvec3& point : now.points)
  {
    point.x = point.x <= 0.5 ? point.x : 0.5 + 4.0 * (point.x - 0.5);
  }
  for (const int rounds : { 0, 3 })
  {
    const auto stretch = ink::pointStretch(before.points, now.points, before.triangles, rounds);
    for (std::size_t i = 0; i < before.points.size(); ++i)
    {
      const double x = before.points[i].x;
      const bool stretched = x > 0.5 - 0.05 * rounds - 1e-9;
      EXPECT_NEAR(stretch[i], stretched ? 4.0f : 1.0f, 1e-5f) << x << " in " << rounds << " rounds";
    }
  }
}
