// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/SurfaceRings.h"

#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

namespace
{

using namespace ink;

/// Points around point 0, and triangles of it with two of these each.
test::Mesh fan(std::uint32_t points, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges)
{
  test::Mesh mesh;
  for (std::uint32_t i = 0; i <= points; ++i)
  {
    mesh.points.emplace_back(i, i * i, 0.0);
  }
  for (const auto& [a, b] : edges)
  {
    mesh.triangles.push_back({ a, b, 0 });
  }
  return mesh;
}

RingShape shapeOf(const test::Mesh& mesh)
{
  return SurfaceRings(mesh.view()).shape(0);
}

std::vector<std::uint32_t> ringOf(const test::Mesh& mesh)
{
  const SurfaceRings rings(mesh.view());
  return { rings.ring(0).begin(), rings.ring(0).end() };
}

} // namespace

TEST(SurfaceRings, ShapesOfFans)
{
  EXPECT_EQ(shapeOf(fan(4, { { 1, 2 }, { 3, 4 }, { 2, 3 }, { 4, 1 } })), RingShape::Closed);
  EXPECT_EQ(shapeOf(fan(4, { { 1, 2 }, { 3, 4 }, { 2, 3 } })), RingShape::Open);
  EXPECT_EQ(shapeOf(fan(2, { { 1, 2 } })), RingShape::Open);
  EXPECT_EQ(shapeOf(fan(4, { { 1, 2 }, { 3, 4 } })), RingShape::NonManifold) << "two open fans";
  EXPECT_EQ(
    shapeOf(fan(6, { { 1, 2 }, { 2, 3 }, { 3, 1 }, { 4, 5 }, { 5, 6 }, { 6, 4 } })), RingShape::NonManifold)
    << "two closed fans";
  EXPECT_EQ(shapeOf(fan(5, { { 1, 2 }, { 2, 3 }, { 3, 1 }, { 4, 5 } })), RingShape::NonManifold)
    << "one closed, one open";
  EXPECT_EQ(shapeOf(fan(4, { { 1, 2 }, { 1, 3 }, { 1, 4 } })), RingShape::NonManifold) << "three at an edge";
  EXPECT_EQ(shapeOf(fan(2, { { 1, 2 }, { 1, 2 } })), RingShape::Open) << "the same twice";
  EXPECT_EQ(shapeOf(fan(2, { { 1, 2 }, { 2, 1 } })), RingShape::Open) << "the same, and turned";
  EXPECT_EQ(shapeOf(fan(2, {})), RingShape::Isolated);
  EXPECT_EQ(shapeOf(fan(2, { { 1, 1 }, { 0, 2 } })), RingShape::Isolated) << "degenerate";
}

TEST(SurfaceRings, ClosedRingsAreInOrder)
{
  EXPECT_EQ(
    ringOf(fan(4, { { 1, 2 }, { 3, 4 }, { 2, 3 }, { 4, 1 } })), (std::vector<std::uint32_t>{ 1, 2, 3, 4 }));
  // One triangle turned: the others decide as the first one does.
  EXPECT_EQ(
    ringOf(fan(4, { { 1, 2 }, { 4, 3 }, { 2, 3 }, { 4, 1 } })), (std::vector<std::uint32_t>{ 1, 2, 3, 4 }));
  // More than are searched through one by one.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    const std::uint32_t from = 7 * i % 1000;
    edges.emplace_back(from + 1, (from + 1) % 1000 + 1);
    expected.push_back(i + 1);
  }
  EXPECT_EQ(ringOf(fan(1000, edges)), expected);
}

TEST(SurfaceRings, OthersHaveEachNeighborOnce)
{
  for (const auto& mesh : { fan(4, { { 1, 2 }, { 3, 4 }, { 2, 3 } }),
         fan(4, { { 1, 2 }, { 1, 3 }, { 1, 4 } }), fan(4, { { 1, 2 }, { 3, 4 } }) })
  {
    EXPECT_EQ(ringOf(mesh), (std::vector<std::uint32_t>{ 1, 2, 3, 4 }));
  }
}

TEST(SurfaceRings, SeamsAreJoined)
{
  const test::Mesh torus = test::torus(1.0, 0.4, 20, 10); // open along two circles but for positions
  const SurfaceRings rings(torus.view());
  std::set<std::uint32_t> sites;
  for (std::size_t point = 0; point < rings.size(); ++point)
  {
    const std::uint32_t site = rings.site(point);
    sites.insert(site);
    EXPECT_LE(site, point);
    EXPECT_EQ(torus.points[site], torus.points[point]);
    EXPECT_EQ(rings.shape(site), RingShape::Closed);
    EXPECT_EQ(rings.ring(site).size(), 6u);
  }
  EXPECT_EQ(sites.size(), 200u);
}

TEST(SurfaceRings, PointsThatAreNotFiniteAreLeftOut)
{
  test::Mesh mesh = fan(4, { { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 1 } });
  mesh.points[3].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(shapeOf(mesh), RingShape::Open);
  EXPECT_EQ(SurfaceRings(mesh.view()).shape(3), RingShape::Isolated);
}

TEST(SurfaceRings, PointsThatDoNotExistAreRefused)
{
  test::Mesh mesh = fan(2, { { 1, 2 } });
  mesh.triangles.push_back({ 0, 1, 9 });
  try
  {
    const SurfaceRings rings(mesh.view());
    FAIL() << "expected an exception";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(), "a triangle names point 9; expected less than 3, the number of points");
  }
}
