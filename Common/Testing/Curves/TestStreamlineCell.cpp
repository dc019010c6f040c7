// SPDX-License-Identifier: BSD-3-Clause
// What a line knows of a triangle: the step of equation 15 by hand, and which way directions are turned.

#include "Curves/Streamlines/StreamlineCell.h"

#include "SampledMeshes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace
{

using namespace ink;

constexpr double degree = std::numbers::pi / 180.0;

glm::dvec3 at(double degrees)
{
  return { std::cos(degrees * degree), std::sin(degrees * degree), 0.0 };
}

/// A right triangle of sides 3, 4 and 5.
test::Mesh rightTriangle()
{
  test::Mesh mesh;
  mesh.points = { { 0.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 } };
  mesh.triangles = { { 0, 1, 2 } };
  return mesh;
}

double stepOf(const std::vector<glm::dvec3>& directions)
{
  const test::Mesh mesh = rightTriangle();
  const MeshNavigation navigation(mesh.view(), 180.0);
  return StreamlineCell(navigation, LineField{ directions, {}, {} }, 0, at(0.0)).adaptiveStep;
}

} // namespace

/// h = c / (2 (1 + sum of the three angles)^2), with angles of lines, in radians.
TEST(StreamlineCell, StepOfEquation15)
{
  EXPECT_NEAR(stepOf({ at(0.0), at(0.0), at(0.0) }), 6.0, 1e-12);
  // 20, 30 and 50 degrees, together 1.745329 radians: 12 / (2 * 2.745329^2).
  EXPECT_NEAR(stepOf({ at(0.0), at(20.0), at(50.0) }), 0.796090, 1e-6);
  // The same lines, whichever way their directions point.
  EXPECT_NEAR(stepOf({ at(180.0), at(20.0), at(230.0) }), 0.796090, 1e-6);
}

/// Section 2.2: directions are flipped when they enclose more than a right angle with the line. Printed is an
/// angle of more than pi, which there is none of: lines would turn back.
TEST(StreamlineCell, DirectionsAreFlippedBeyondARightAngle)
{
  for (int degrees = 0; degrees <= 180; degrees += 10)
  {
    const std::vector<glm::dvec3> directions = { at(degrees) };
    const LineField field{ directions, {}, {} };
    const glm::dvec3 heading = at(0.0);
    const glm::dvec3 turned = field.along(0, heading);
    const glm::dvec3 expected = degrees <= 90 ? at(degrees) : at(degrees - 180.0);
    EXPECT_LT(glm::distance(turned, expected), 1e-12) << degrees;
    const bool asPrinted = std::acos(glm::dot(directions[0], heading)) > std::numbers::pi;
    const glm::dvec3 printed = asPrinted ? -directions[0] : directions[0];
    EXPECT_EQ(glm::dot(printed, heading) < -1e-12, degrees > 90) << degrees << ": backwards";
  }
}
