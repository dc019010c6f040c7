// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/LongestBorder.h"

#include "MeshesWithCurvature.h"
#include "SampledMeshes.h"

#include "Mesh/BorderEdges.h"
#include "Mesh/WeldedTriangles.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace
{

using namespace ink;
using namespace ink::test;

double borderOf(const Mesh& mesh)
{
  const WeldedTriangles welded(mesh.view());
  return longestBorder(welded.mesh());
}

} // namespace

TEST(LongestBorder, IsTheSumOfItsEdges)
{
  EXPECT_EQ(borderOf(icosphere(3)), 0.0);
  EXPECT_EQ(borderOf({}), 0.0);
  const Mesh sheet = square(4);
  const double around = 4.0 * glm::distance(sheet.points.front(), sheet.points.back()) / std::sqrt(2.0);
  EXPECT_NEAR(borderOf(sheet), around, 1e-12 * around);
}

TEST(BorderEdges, ArePairedWhereThereIsNone)
{
  Mesh ball = icosphere(3);
  EXPECT_TRUE(hasPairedEdges(ball.view()));
  EXPECT_TRUE(hasPairedEdges({}));
  ball.triangles.pop_back();
  EXPECT_FALSE(hasPairedEdges(ball.view()));
  EXPECT_FALSE(hasPairedEdges(square(3).view()));
}

TEST(LongestBorder, IsThatOfOneOfSeveral)
{
  // Far from its border, a sheet lacks a triangle.
  Mesh sheet = square(8);
  const double around = borderOf(sheet);
  sheet.triangles.erase(
    sheet.triangles.begin() + static_cast<std::ptrdiff_t>(sheet.triangles.size() / 2 + 8));
  EXPECT_EQ(borderOf(sheet), around);
}

TEST(WeldedTriangles, CloseSeamsAndLeaveOutWhatIsNotFinite)
{
  Mesh apart = soupOf(icosphere(2));
  EXPECT_EQ(borderOf(apart), 0.0);
  EXPECT_GT(longestBorder(apart.view()), 0.0);
  apart.points[0].x = std::numeric_limits<double>::quiet_NaN();
  const WeldedTriangles welded(apart.view());
  ASSERT_EQ(welded.triangles.size(), apart.triangles.size() - 1);
  EXPECT_EQ(welded.source.front(), 1U);
  EXPECT_NEAR(welded.diagonal(), 2.0 * std::sqrt(3.0), 0.2);
  EXPECT_GT(longestBorder(welded.mesh()), 0.0);
}
