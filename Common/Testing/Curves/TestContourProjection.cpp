// SPDX-License-Identifier: BSD-3-Clause
#include "ContourTesting.h"

#include "Curves/Contours/FieldContours.h"
#include "Curves/Contours/GridContours.h"
#include "Curves/Contours/ProjectContour.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace
{

using namespace ink::testing;

const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(GridContours, ProjectedPointsLieOnTheContour)
{
  const Torus torus{ 14.0, 6.0 };
  const GridGeometry grid({ 48, 48, 24 }, { -23.5, -23.5, -11.5 });
  const auto scan = Volume<short>::from(
    grid, [&](const glm::dvec3& p) { return 4000.0 * std::erfc(torus.distance(p) / std::sqrt(2.0)); });
  const GridContours<short> finder(scan.field(), 4000.5);
  const double diagonal = std::sqrt(3.0);
  std::size_t others = 0;
  std::size_t count = 0;
  GridContourOptions options;
  options.projectionSteps = 20;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Eye eye = seed % 2 ? Eye::along(randomDirection(seed)) : Eye::at(60.0 * randomDirection(seed));
    const Contours before = finder.find(eye);
    const Contours after = finder.find(eye, {}, options);
    ASSERT_EQ(before.positions.size(), after.positions.size());
    for (std::size_t n = 0; n < after.positions.size(); ++n)
    {
      const ink::ContourResidual left = ink::contourResidual(scan.field(), 4000.5, eye, after.positions[n]);
      EXPECT_LE(glm::distance(before.positions[n], after.positions[n]), diagonal);
      if (std::abs(left.distance) > 1e-4 * diagonal || std::abs(left.sine) > 1e-4)
      {
        // Where the radial curvature all but vanishes; no farther away than before.
        const ink::ContourResidual was = ink::contourResidual(scan.field(), 4000.5, eye, before.positions[n]);
        EXPECT_LE(std::max(std::abs(left.distance) / diagonal, std::abs(left.sine)),
          std::max(std::abs(was.distance) / diagonal, std::abs(was.sine)));
        ++others;
      }
    }
    count += after.positions.size();
  }
  EXPECT_LT(others, count / 1000);
}

/// Dense inside.
template <class Shape>
struct Solid
{
  Shape shape;

  double value(const glm::dvec3& p) const { return -this->shape.value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return -this->shape.gradient(p); }
  glm::dmat3 hessian(const glm::dvec3& p) const { return -this->shape.hessian(p); }
};

TEST(FieldContours, LieOnTheFieldsOwnContour)
{
  const ink::FieldContours<Solid<Sphere>> ball({ Ball }, 0.0, cube(13, 2.5));
  for (const Eye& eye : BallEyes)
  {
    const Contours contours = ball.find(eye, all);
    ASSERT_EQ(contours.chains.size(), 1u);
    EXPECT_TRUE(contours.chains.closed[0]);
    EXPECT_LT(greatestDistance(Circle::of(Ball, eye), contours), 2e-4);
    for (const float curvature : contours.radialCurvature)
    {
      EXPECT_NEAR(curvature, 1.0, 1e-3);
    }
    expectFrontOnTheLeft(contours, eye);
  }
  const Torus torus{ 1.0, 0.4 };
  const ink::FieldContours<Solid<Torus>> ring({ torus }, 0.0, cube(33, 3.2));
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Eye eye = Eye::at(5.0 * randomDirection(seed));
    const Contours contours = ring.find(eye);
    for (const glm::dvec3& p : contours.positions)
    {
      const ink::ContourResidual left = ink::contourResidual(torus, 0.0, eye, p);
      EXPECT_LT(std::max(std::abs(left.distance), std::abs(left.sine)), 2e-4);
    }
  }
}

/// Not defined where x < 0.
struct HalfBall : Solid<Sphere>
{
  double value(const glm::dvec3& p) const { return p.x < 0.0 ? nan : Solid<Sphere>::value(p); }
};

TEST(FieldContours, EndWhereTheFieldDoes)
{
  const ink::FieldContours<HalfBall> half({ { Ball } }, 0.0, cube(25, 2.5));
  const Contours contours = half.find(Eye::along({ 0.0, 0.0, 1.0 }), all);
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_FALSE(contours.chains.closed[0]);
  EXPECT_NEAR(contours.arcLength.back(), pi, 0.2);
  for (const glm::dvec3& p : contours.positions)
  {
    EXPECT_GE(p.x, 0.0);
  }
}

} // namespace
