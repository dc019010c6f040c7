// SPDX-License-Identifier: BSD-3-Clause
#include "ContourTesting.h"

#include "Curves/Contours/DescribeContours.h"
#include "Curves/Contours/GridContours.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{

using namespace ink::testing;

const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(GridContours, SphereIsSeenAsACircle)
{
  for (const Eye& eye : BallEyes)
  {
    const Circle circle = Circle::of(Ball, eye);
    double before = 0.0;
    for (const int samples : { 17, 33, 65 })
    {
      SCOPED_TRACE(samples);
      const auto volume = sampled<float>(cube(samples, 2.5), Ball);
      const GridContours<float> finder(volume.field(), 0.0);
      const Contours contours = finder.find(eye, all);
      ASSERT_EQ(contours.chains.size(), 1u);
      EXPECT_TRUE(contours.chains.closed[0]);
      EXPECT_EQ(contours.kinds[0], ink::ContourKind::Silhouette);
      // Second order.
      const double distance = greatestDistance(circle, contours);
      EXPECT_LT(distance, before == 0.0 ? 0.05 : before / 3.0);
      before = distance;

      GridContourOptions projected;
      projected.projectionSteps = 8;
      EXPECT_LT(greatestDistance(circle, finder.find(eye, {}, projected)), distance);
    }
  }
}

TEST(GridContours, ArraysDescribeTheSurface)
{
  const auto volume = sampled<double>(cube(65, 2.5), Ball);
  for (const Eye& eye : BallEyes)
  {
    const Contours contours = GridContours<double>(volume.field(), 0.0).find(eye, all);
    const std::size_t count = contours.positions.size();
    ASSERT_EQ(contours.normals.size(), count);
    ASSERT_EQ(contours.radialCurvature.size(), count);
    ASSERT_EQ(contours.arcLength.size(), count);
    ASSERT_EQ(contours.elements.size(), count);
    for (std::size_t n = 0; n < count; ++n)
    {
      const glm::dvec3 p = contours.positions[n];
      const glm::dvec3 next = contours.positions[(n + 1) % count];
      EXPECT_GT(glm::dot(glm::dvec3(contours.normals[n]), Ball.gradient(p)), 0.999);
      EXPECT_NEAR(glm::length(contours.normals[n]), 1.0, 1e-6);
      EXPECT_NEAR(contours.radialCurvature[n], 1.0, 0.03);
      if (n > 0)
      {
        EXPECT_EQ(
          contours.arcLength[n], contours.arcLength[n - 1] + glm::distance(p, contours.positions[n - 1]));
      }
      // The cell of the segment to the next point.
      const int cells = 64;
      const auto element = static_cast<int>(contours.elements[n]);
      const glm::dvec3 cell(element % cells, element / cells % cells, element / (cells * cells));
      const glm::dvec3 in = volume.geometry.toIndex(0.5 * (p + next)) - cell - 0.5;
      EXPECT_LE(std::max({ std::abs(in.x), std::abs(in.y), std::abs(in.z) }), 0.5 + 1e-9);
    }
    EXPECT_EQ(contours.arcLength[0], 0.0);
    const double around =
      contours.arcLength.back() + glm::distance(contours.positions[0], contours.positions.back());
    EXPECT_NEAR(around, 2.0 * pi * Circle::of(Ball, eye).radius, 0.05);

    const Contours bare = GridContours<double>(volume.field(), 0.0).find(eye);
    EXPECT_TRUE(bare.normals.empty() && bare.radialCurvature.empty() && bare.arcLength.empty() &&
      bare.elements.empty());
    EXPECT_EQ(bare.positions, contours.positions);
  }
}

TEST(GridContours, RadialCurvatureTellsWhatHidesItself)
{
  // From far above its axis a torus has an outer circle, and an inner one: both are seen. From the side the
  // inner one of each tube end lies in a saddle.
  const Torus torus{ 1.0, 0.4 };
  const auto volume = sampled<float>(cube(65, 3.2), torus);
  const Contours above = GridContours<float>(volume.field(), 0.0).find(Eye::along({ 0.0, 0.0, -1.0 }), all);
  ASSERT_EQ(above.chains.size(), 2u);
  for (const float curvature : above.radialCurvature)
  {
    EXPECT_NEAR(curvature, 1.0 / torus.minor, 0.1 / torus.minor);
  }
  const Eye eye = Eye::along({ 1.0, 0.0, -0.3 });
  const Contours aside = GridContours<float>(volume.field(), 0.0).find(eye, all);
  int negative = 0;
  for (std::size_t n = 0; n < aside.positions.size(); ++n)
  {
    const double truth = -ink::radialCurvature(torus, eye, aside.positions[n]);
    EXPECT_NEAR(aside.radialCurvature[n], truth, 0.35);
    negative += truth < 0.0;
  }
  EXPECT_GT(negative, 10);
}

TEST(GridContours, AnyGrid)
{
  const glm::dmat3 turned(glm::dvec3(0.0, 0.8, 0.6), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.6, -0.8));
  const glm::dmat3 sheared(glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.3, 1.0, 0.0), glm::dvec3(0.0, -0.2, 1.0));
  for (const glm::dmat3& direction : { glm::dmat3(1.0), turned, sheared })
  {
    for (const glm::dvec3& spacing :
      { glm::dvec3(0.1, 0.1, 0.1), glm::dvec3(0.05, -0.1, 0.15), glm::dvec3(-0.08, -0.04, -0.1) })
    {
      const glm::ivec3 first(-7, 3, 100);
      const glm::ivec3 n(glm::ceil(3.4 / glm::abs(spacing)));
      const glm::dvec3 middle = glm::dvec3(first) + 0.5 * glm::dvec3(n - 1);
      const GridGeometry grid(n, Ball.center - direction * (spacing * middle), spacing, direction, first);
      const auto volume = sampled<float>(grid, Ball);
      for (const Eye& eye : BallEyes)
      {
        const Contours contours = GridContours<float>(volume.field(), 0.0).find(eye, all);
        ASSERT_EQ(contours.chains.size(), 1u);
        EXPECT_TRUE(contours.chains.closed[0]);
        EXPECT_LT(greatestDistance(Circle::of(Ball, eye), contours), 0.02);
        expectFrontOnTheLeft(contours, eye);
      }
    }
  }
}

TEST(GridContours, NeitherUnitNorOriginMatters)
{
  const auto plain = sampled<float>(cube(33, 2.5), Ball);
  const Contours expected = GridContours<float>(plain.field(), 0.0).find(BallEyes[0]);
  for (const double unit : { 1e-9, 1e9 })
  {
    Volume<float> scaled(GridGeometry(glm::ivec3(33), glm::dvec3(-1.25 * unit), glm::dvec3(2.5 / 32 * unit)));
    scaled.values = plain.values;
    const Contours contours =
      GridContours<float>(scaled.field(), 0.0).find(Eye::at(unit * BallEyes[0].position));
    ASSERT_EQ(contours.chains.offsets, expected.chains.offsets);
    for (std::size_t n = 0; n < expected.positions.size(); ++n)
    {
      EXPECT_LT(glm::distance(contours.positions[n] / unit, expected.positions[n]), 1e-9);
    }
  }
  const glm::dvec3 far(1e7, -1e7, 1e7);
  Volume<float> moved(GridGeometry(glm::ivec3(33), far + plain.geometry.origin(), plain.geometry.spacing()));
  moved.values = plain.values;
  const Contours contours = GridContours<float>(moved.field(), 0.0).find(Eye::at(far + BallEyes[0].position));
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_LT(
    greatestDistance(Circle::of({ far + Ball.center, 1.0 }, Eye::at(far + BallEyes[0].position)), contours),
    0.02);
}

TEST(GridContours, AThousandTimesAsThickAsWide)
{
  // A ball in steps of the grid: an ellipsoid, whose contour is what the projection says.
  const GridGeometry grid({ 33, 33, 33 }, glm::dvec3(0.0), { 1.0, 1.0, 1000.0 });
  const auto volume = Volume<double>::from(grid,
    [](const glm::dvec3& p)
    { return 12.0 - glm::distance(p / glm::dvec3(1.0, 1.0, 1000.0), glm::dvec3(16.1)); });
  const Eye eye = Eye::at({ 100.0, 120.0, 40000.0 });
  const Contours contours = GridContours<double>(volume.field(), 0.0).find(eye, all);
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_TRUE(contours.chains.closed[0]);
  for (const glm::dvec3& p : contours.positions)
  {
    // Straight lines stay straight lines: in steps of the grid the contour is a circle.
    const Circle circle = Circle::of({ glm::dvec3(16.1), 12.0 }, Eye::at(grid.toIndex(eye.position)));
    EXPECT_LT(circle.distance(grid.toIndex(p)), 0.15);
  }
}

template <class T>
void expectCircleOf(double inside, double scale)
{
  // Coarse enough that few values are equal to their neighbors'.
  const int samples = sizeof(T) == 1 ? 13 : 41;
  const double bound = sizeof(T) == 1 ? 0.2 : 0.03;
  const auto volume = sampled<T>(cube(samples, 2.5), Ball, scale, inside);
  for (const Eye& eye : BallEyes)
  {
    const Contours contours = GridContours<T>(volume.field(), inside + 0.25).find(eye);
    EXPECT_EQ(contours.chains.size(), 1u);
    EXPECT_LT(greatestDistance(Circle::of(Ball, eye), contours), bound);
  }
}

TEST(GridContours, AnyScalarType)
{
  expectCircleOf<char>(20.0, 50.0);
  expectCircleOf<signed char>(-20.0, 60.0);
  expectCircleOf<unsigned char>(150.0, 90.0);
  expectCircleOf<short>(-3000.0, 10000.0);
  expectCircleOf<unsigned short>(40000.0, 15000.0);
  expectCircleOf<int>(1e9, 1e8);
  expectCircleOf<unsigned int>(3e9, 1e8);
  expectCircleOf<long>(1e18, 1e17);
  expectCircleOf<unsigned long>(1e19, 1e18);
  expectCircleOf<long long>(-1e18, 1e17);
  expectCircleOf<unsigned long long>(1e19, 1e18);
  expectCircleOf<float>(0.0, 1e30);
  expectCircleOf<double>(0.0, 1e250);
}

TEST(GridContours, RejectsEyes)
{
  const auto volume = sampled<float>(cube(9, 2.5), Ball);
  const GridContours<float> finder(volume.field(), 0.0);
  EXPECT_THROW(finder.find(Eye::at({ 0.0, nan, 0.0 })), std::invalid_argument);
  EXPECT_THROW(
    finder.find(Eye::along({ 0.0, 0.0, std::numeric_limits<double>::infinity() })), std::invalid_argument);
  try
  {
    finder.find(Eye::along(glm::dvec3(0.0)));
    FAIL() << "a direction of length 0";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()), "the eye's direction is zero, expected a vector into the scene");
  }
}

} // namespace
