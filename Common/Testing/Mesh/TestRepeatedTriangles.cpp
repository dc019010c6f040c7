// SPDX-License-Identifier: BSD-3-Clause
// Triangles that a mesh has more than once: by ids and by positions, turned and reversed.

#include "Mesh/RepeatedTriangles.h"

#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

using Ids = std::vector<std::uint32_t>;

TEST(RepeatedTriangles, AreThoseOfTheSameCorners)
{
  const std::vector<Triangle> triangles = { { 0, 1, 2 }, { 1, 2, 3 }, { 1, 2, 0 }, { 2, 1, 0 }, { 0, 1, 3 },
    { 3, 1, 0 }, { 4, 4, 5 }, { 4, 5, 5 } };
  EXPECT_EQ(repeatedTriangles(triangles), (Ids{ 2, 3, 5 }));
  EXPECT_TRUE(repeatedTriangles(std::vector<Triangle>()).empty());
}

TEST(RepeatedTriangles, MayHavePointsOfTheirOwn)
{
  Mesh sheet = square(30);
  ASSERT_TRUE(repeatedTriangles(sheet.points, sheet.triangles).empty());
  const auto points = static_cast<std::uint32_t>(sheet.points.size());
  const auto triangles = static_cast<std::uint32_t>(sheet.triangles.size());
  Mesh both = sheet;
  Ids expected;
  for (std::uint32_t i = 0; i < points; ++i)
  {
    both.points.push_back(sheet.points[i] * glm::dvec3(1.0, 1.0, -1.0)); // -0 is 0
  }
  for (std::uint32_t t = 0; t < triangles; ++t)
  {
    const auto& [a, b, c] = sheet.triangles[t];
    both.triangles.push_back({ b + points, a + points, c + points });
    expected.push_back(triangles + t);
  }
  EXPECT_EQ(repeatedTriangles(both.points, both.triangles), expected);
  EXPECT_TRUE(repeatedTriangles(both.triangles).empty()) << "by ids";
  both.points[points].z = 1e-300;
  EXPECT_EQ(repeatedTriangles(both.points, both.triangles).size(), expected.size() - 2);
}

TEST(RepeatedTriangles, AreNoneWithoutNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<glm::dvec3> points = { { nan, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
    { std::numeric_limits<double>::infinity(), 0, 0 } };
  const std::vector<Triangle> triangles = { { 0, 1, 2 }, { 0, 1, 2 }, { 1, 2, 3 }, { 3, 2, 1 } };
  EXPECT_EQ(repeatedTriangles(points, triangles), Ids{ 3 });
}

TEST(RepeatedTriangles, AreErased)
{
  std::vector<int> values = { 0, 1, 2, 3, 4 };
  eraseIndices(values, Ids{ 0, 3, 4 });
  EXPECT_EQ(values, (std::vector<int>{ 1, 2 }));
  eraseIndices(values, Ids());
  EXPECT_EQ(values.size(), 2u);
}

} // namespace
