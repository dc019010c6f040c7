// SPDX-License-Identifier: BSD-3-Clause
// Curvature of meshes with sharp edges, which are cut open there first: that of each side.

#include "Curvature/MeshCurvature.h"

#include "MachineParts.h"
#include "Mesh/FeatureSplit.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace ink;
using namespace ink::test;

/// What a mesh has once it is cut open.
struct Sharp
{
  Mesh mesh;
  MeshCurvature curvature;

  explicit Sharp(const Mesh& whole)
  {
    MeshNavigation navigation(whole.view(), 180.0);
    cutFeatures(navigation);
    const FeatureSplit split = splitAtFeatures(navigation);
    this->mesh.points = split.spread<glm::dvec3>(whole.points);
    this->mesh.triangles = split.triangles;
    CurvatureOptions options;
    options.seams = Seams::Apart;
    this->curvature = estimateCurvature(this->mesh.view(), {}, options);
  }
};

void expectFrame(const PrincipalCurvature& c)
{
  EXPECT_NEAR(glm::length(c.direction1), 1.0, 1e-9);
  EXPECT_NEAR(glm::length(c.direction2), 1.0, 1e-9);
  EXPECT_NEAR(glm::dot(c.direction1, c.direction2), 0.0, 1e-9);
}

} // namespace

TEST(SharpCurvature, BoxesAreFlatUpToTheirEdges)
{
  for (const int cells : { 1, 2, 8 })
  {
    for (const bool welded : { true, false })
    {
      const Sharp sharp(box({ 2.0, 1.0, 0.5 }, cells, welded));
      for (std::size_t i = 0; i < sharp.mesh.points.size(); ++i)
      {
        const PrincipalCurvature& c = sharp.curvature.points[i];
        EXPECT_NEAR(c.k1, 0.0, 1e-9) << i << " of " << cells;
        EXPECT_NEAR(c.k2, 0.0, 1e-9) << i << " of " << cells;
        EXPECT_NE(sharp.curvature.sources[i], CurvatureSource::None);
        expectFrame(c);
        // In the plane of a face: a normal along an axis.
        const glm::dvec3 n = glm::abs(c.normal());
        EXPECT_NEAR(std::max({ n.x, n.y, n.z }), 1.0, 1e-9) << i;
      }
    }
  }
  // Whole, the corners of a welded box are as curved as a ball.
  const Mesh whole = box({ 1.0, 1.0, 1.0 }, 4, true);
  const MeshCurvature found = estimateCurvature(whole.view(), {});
  EXPECT_GT(std::max_element(found.points.begin(), found.points.end(),
              [](const auto& a, const auto& b) { return a.k1 < b.k1; })
              ->k1,
    1.0);
}

TEST(SharpCurvature, CylindersAreRoundOnTheSideAndFlatOnCaps)
{
  for (const int columns : { 48, 96 })
  {
    // Of second order up to the rims: .039 measured at 48 columns.
    const double tolerance = 0.045 * (48.0 / columns) * (48.0 / columns);
    for (const int rows : { 1, columns / 4 })
    {
      for (const bool welded : { true, false })
      {
        const Sharp sharp(cylinder(columns, rows, 2.0, welded));
        int caps = 0;
        for (std::size_t i = 0; i < sharp.mesh.points.size(); ++i)
        {
          const PrincipalCurvature& c = sharp.curvature.points[i];
          expectFrame(c);
          const bool isCap = std::abs(c.normal().z) > 0.5;
          caps += isCap ? 1 : 0;
          EXPECT_NEAR(c.k1, isCap ? 0.0 : 1.0, isCap ? 1e-9 : tolerance) << i << " of " << rows << welded;
          EXPECT_NEAR(c.k2, 0.0, isCap ? 1e-9 : tolerance) << i << " of " << rows << welded;
          EXPECT_LT(isCap ? 0.0 : std::abs(c.direction1.z), 0.02) << i << " of " << rows << welded;
        }
        EXPECT_EQ(caps, 2 * columns);
      }
    }
  }
}

TEST(SharpCurvature, SmoothSurfacesAreAsBefore)
{
  for (const double noise : { 0.0, 0.004 })
  {
    const MeshWithCurvature ball = ellipsoid({ 1.0, 0.8, 0.6 }, 5, noise);
    const Sharp sharp(ball.mesh);
    const MeshCurvature before = estimateCurvature(ball.mesh.view(), {});
    ASSERT_EQ(sharp.mesh.points, ball.mesh.points);
    for (std::size_t i = 0; i < before.points.size(); ++i)
    {
      EXPECT_EQ(sharp.curvature.points[i].k1, before.points[i].k1);
      EXPECT_EQ(sharp.curvature.points[i].direction1, before.points[i].direction1);
    }
  }
}
