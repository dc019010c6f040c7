// SPDX-License-Identifier: BSD-3-Clause
// Contours of sparse grids.
#include "ContourTesting.h"
#include "VdbVolumes.h"

#include "Curves/Contours/FieldContours.h"
#include "Fields/Vdb/VdbField.h"

#include <openvdb/tools/LevelSetSphere.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace ink::testing;
using ink::FieldContours;
using ink::VdbField;

/// Of a narrow band, which is missing everywhere else; finer and coarser than its voxels.
TEST(VdbContours, OfALevelSetAreTheCircleOfItsBall)
{
  const Sphere ball{ { 0.5, 1.0, 2.0 }, 10.0 };
  const ink::VdbGrid grid = readBack<openvdb::FloatGrid>(
    openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(10.0f, { 0.5f, 1.0f, 2.0f }, 0.5f, 4.0f));
  const VdbField field(grid);
  for (const double step : { 0.4, 0.8 })
  {
    const int samples = static_cast<int>(24.0 / step);
    const GridGeometry box(glm::ivec3(samples), ball.center - 0.5 * step * (samples - 1), glm::dvec3(step));
    const FieldContours<VdbField> finder(field, 0.0, box);
    for (const Eye& eye : { Eye::at({ 30.0, 40.0, 50.0 }), Eye::along({ 1.0, 2.0, -20.0 }) })
    {
      const Contours contours = finder.find(eye, all);
      ASSERT_EQ(contours.chains.size(), 1u) << step;
      EXPECT_TRUE(contours.chains.closed[0]);
      // Of a field of voxels of half a unit: h^2 / (8 R), and as much for gradients.
      EXPECT_LT(greatestDistance(Circle::of(ball, eye), contours), 0.02) << step;
      EXPECT_NEAR(contours.arcLength.back(), 2.0 * pi * Circle::of(ball, eye).radius, 2.0 * step);
      for (std::size_t n = 0; n < contours.positions.size(); ++n)
      {
        // Values grow outwards, so that the outside is the denser side.
        EXPECT_LT(glm::dot(glm::dvec3(contours.normals[n]), ball.gradient(contours.positions[n])), -0.999);
        EXPECT_NEAR(contours.radialCurvature[n], -0.1, 0.01);
      }
    }
  }
}

/// A volume as a sparse grid has the contours that it has itself.
TEST(VdbContours, AreThoseOfTheVolumeThatTheGridHolds)
{
  const Torus torus{ 1.0, 0.4 };
  const auto volume = sampled<float>(cube(33, 3.2), torus);
  const VdbField sparse(ink::makeVdbGrid(volume.field(), {}), VdbField::Inactive::Background);
  // No sample lies on the surface, where rounding would tell on which side.
  const GridGeometry box(glm::ivec3(41), { -1.503, -1.517, -1.529 }, glm::dvec3(0.0757));
  const Eye eye = Eye::at({ 2.0, -3.0, 2.5 });
  const Contours expected = FieldContours<ink::GridField<float>>(volume.field(), 0.0, box).find(eye, all);
  const Contours found = FieldContours<VdbField>(sparse, 0.0, box).find(eye, all);
  EXPECT_GE(expected.chains.size(), 1u);
  ASSERT_EQ(found.positions.size(), expected.positions.size());
  EXPECT_EQ(found.chains.closed, expected.chains.closed);
  EXPECT_EQ(found.elements, expected.elements);
  for (std::size_t n = 0; n < found.positions.size(); ++n)
  {
    EXPECT_LT(glm::distance(found.positions[n], expected.positions[n]), 1e-6);
    EXPECT_NEAR(found.radialCurvature[n], expected.radialCurvature[n], 1e-3);
  }
}

} // namespace
