// SPDX-License-Identifier: BSD-3-Clause
// Parts of meshes: the triangles that reach into a region, and moving about on them.

#include "Mesh/TrianglesWithin.h"

#include "Mesh/MeshNavigation.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

const std::vector<HalfSpace> strip = { { { 1.0, 0.0, 0.0 }, 0.52 }, { { -1.0, 0.0, 0.0 }, -0.31 } };

} // namespace

TEST(TrianglesWithin, ThoseThatReachIntoTheRegion)
{
  const Mesh mesh = square(10);
  const std::vector<std::uint32_t> found = trianglesWithin(mesh.view(), strip);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  // Columns from .3 to .6, in each of ten rows two triangles.
  ASSERT_EQ(found.size(), 60u);
  for (const std::uint32_t t : found)
  {
    for (const std::uint32_t point : mesh.triangles[t])
    {
      EXPECT_GE(mesh.points[point].x, 0.3 - 1e-9);
      EXPECT_LE(mesh.points[point].x, 0.6 + 1e-9);
    }
  }
  EXPECT_EQ(trianglesWithin(mesh.view(), {}).size(), mesh.triangles.size());
  EXPECT_TRUE(areContaining({}, glm::dvec3(7.0)));
  EXPECT_TRUE(areContaining(strip, { 0.4, 9.0, 9.0 }));
  EXPECT_FALSE(areContaining(strip, { 0.6, 0.0, 0.0 }));
}

TEST(TrianglesWithin, NavigationOfAPart)
{
  const Mesh mesh = square(10);
  const MeshNavigation whole(mesh.view(), 180.0);
  const std::vector<std::uint32_t> ids = trianglesWithin(mesh.view(), strip);
  std::vector<Triangle> triangles;
  for (const std::uint32_t t : ids)
  {
    triangles.push_back(mesh.triangles[t]);
  }
  const TriangleMesh own{ mesh.points, triangles, {}, {} };
  const MeshNavigation part = whole.part(own, ids);
  EXPECT_NEAR(part.area(), 0.3, 1e-12);
  EXPECT_NEAR(part.lower().x, 0.3, 1e-12);
  EXPECT_NEAR(part.upper().x, 0.6, 1e-12);
  // As on the whole, up to the border.
  for (std::uint32_t n = 0; n < ids.size(); ++n)
  {
    const MeshPoint from{ n, { 0.3, 0.3, 0.4 } };
    const glm::dvec3 start = part.position(from);
    const auto along = part.walk(from, { 0.0, 1.0, 0.0 }, 0.95 - start.y);
    ASSERT_TRUE(along.has_value());
    EXPECT_NEAR(part.position(along->at).y, 0.95, 1e-9);
    EXPECT_EQ(part.walk(from, { 1.0, 0.0, 0.0 }, 0.59 - start.x).has_value(), true);
    EXPECT_FALSE(part.walk(from, { 1.0, 0.0, 0.0 }, 0.61 - start.x).has_value());
    EXPECT_TRUE(whole.walk({ ids[n], from.weights }, { 1.0, 0.0, 0.0 }, 0.61 - start.x).has_value());
  }
}
