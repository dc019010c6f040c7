// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/ExponentialMapFit.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace
{

using namespace ink;

/// Points around the pole of a sphere of a radius, normals out of it.
std::vector<glm::dvec3> ringOnSphere(int count, double radius, double distance)
{
  std::vector<glm::dvec3> ring;
  for (int i = 0; i < count; ++i)
  {
    const double around = 2.0 * std::numbers::pi * i / count;
    const double down = distance / radius;
    ring.push_back(radius *
      glm::dvec3(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down) - 1.0));
  }
  return ring;
}

PrincipalCurvature fitted(const std::vector<glm::dvec3>& ring)
{
  std::vector<UnfoldedPoint> unfolded;
  PrincipalCurvature result;
  EXPECT_TRUE(fitExponentialMap(ring, unfolded, result));
  return result;
}

} // namespace

TEST(ExponentialMapFit, KeepsDistancesAndRatiosOfAngles)
{
  // Equations 1 and 2: a cone whose angles are 60, 60 and 30 degrees, stretched to 360.
  const double degree = std::numbers::pi / 180.0;
  const auto at = [degree](double angle, double length)
  { return length * glm::dvec3(std::cos(angle * degree), std::sin(angle * degree), 0.0); };
  const glm::dvec3 a = at(0.0, 1.0);
  const glm::dvec3 b = at(60.0, 2.0);
  const glm::dvec3 c(std::cos(30.0 * degree), std::sin(30.0 * degree) * 0.0, std::sin(30.0 * degree));
  const double bc = std::acos(glm::dot(b, c) / 2.0);
  const double ca = std::acos(glm::dot(c, a));
  std::vector<UnfoldedPoint> unfolded;
  unfoldRing(std::vector<glm::dvec3>{ a, b, c }, unfolded);
  const double flat = 2.0 * std::numbers::pi / (60.0 * degree + bc + ca);
  EXPECT_NEAR(unfolded[0].u, 1.0, 1e-14);
  EXPECT_NEAR(unfolded[0].v, 0.0, 1e-14);
  EXPECT_NEAR(std::hypot(unfolded[1].u, unfolded[1].v), 2.0, 1e-14);
  EXPECT_NEAR(unfolded[1].u, 2.0 * std::cos(flat * 60.0 * degree), 1e-14);
  EXPECT_NEAR(unfolded[2].u, std::cos(flat * (60.0 * degree + bc)), 1e-14);
  EXPECT_NEAR(unfolded[2].v, std::sin(flat * (60.0 * degree + bc)), 1e-14);
}

TEST(ExponentialMapFit, AllCasesOfEquationFive)
{
  // n < 5 (least norm), n = 5 and n > 5: spheres of all, in second order of the distance.
  for (const int count : { 3, 4, 5, 6, 7, 12, 40 })
  {
    for (const double radius : { 1e-6, 2.0, 1e8 })
    {
      const PrincipalCurvature found = fitted(ringOnSphere(count, radius, 0.01 * radius));
      // Three points determine five unknowns least: measured 4e-1 there, 2e-4 of the curvature at most
      // elsewhere.
      const double tolerance = count == 3 ? 0.5 : count == 4 ? 0.3 : 3e-4;
      EXPECT_NEAR(found.k1 * radius, 1.0, tolerance) << count << " points, radius " << radius;
      EXPECT_NEAR(found.k2 * radius, 1.0, tolerance) << count << " points, radius " << radius;
      EXPECT_NEAR(found.normal().z, 1.0, 1e-6) << count << " points, radius " << radius;
    }
  }
}

TEST(ExponentialMapFit, DirectionsOfASaddle)
{
  // z = (x'^2 - 2 y'^2) / 2 bends down along y' and up along x', which is 20 degrees from x.
  const double turn = std::numbers::pi / 9.0;
  const glm::dvec3 x(std::cos(turn), std::sin(turn), 0.0);
  const glm::dvec3 y(-x.y, x.x, 0.0);
  std::vector<glm::dvec3> ring;
  for (int i = 0; i < 8; ++i)
  {
    const double around = 2.0 * std::numbers::pi * i / 8;
    const double u = 0.01 * std::cos(around);
    const double v = 0.01 * std::sin(around);
    ring.push_back(u * x + v * y + glm::dvec3(0.0, 0.0, 0.5 * (u * u - 2.0 * v * v)));
  }
  const PrincipalCurvature found = fitted(ring);
  EXPECT_NEAR(found.k1, 2.0, 1e-3);
  EXPECT_NEAR(found.k2, -1.0, 1e-3);
  EXPECT_NEAR(std::abs(glm::dot(found.direction1, y)), 1.0, 1e-9);
  EXPECT_NEAR(glm::dot(found.direction1, found.direction2), 0.0, 1e-15);
}

TEST(ExponentialMapFit, RingsWithoutSizeHaveNone)
{
  std::vector<UnfoldedPoint> unfolded;
  PrincipalCurvature result;
  EXPECT_FALSE(fitExponentialMap({}, unfolded, result));
  const std::vector<glm::dvec3> nothing(5, glm::dvec3(0.0));
  EXPECT_FALSE(fitExponentialMap(nothing, unfolded, result));
  const std::vector<glm::dvec3> line(5, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_FALSE(fitExponentialMap(line, unfolded, result));
}
