// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/PrincipalCurvature.h"

#include "HashNoise.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace
{

using namespace ink;

/// Rössl et al. 2000, equation 8: the normal curvature in the direction (1, lambda).
double normalCurvature(const TangentForm& f, double lambda)
{
  return (f.l + 2.0 * f.m * lambda + f.n * lambda * lambda) / (1.0 + lambda * lambda);
}

/// Equation 9 with the term under the root that is given.
double rootOfEquation9(const TangentForm& f, double term, double sign)
{
  return ((f.n - f.l) + sign * std::sqrt((f.n - f.l) * (f.n - f.l) + term)) / (2.0 * f.m);
}

} // namespace

TEST(PrincipalCurvature, EigenvectorsOfRandomForms)
{
  for (std::uint64_t i = 0; i < 1000; ++i)
  {
    const auto random = [i](std::uint64_t n) { return 2.0 * ink::testing::hashUniform(n, i) - 1.0; };
    const glm::dvec3 normal = glm::normalize(glm::dvec3(random(1), random(2), random(3)));
    const auto [u, v] = tangentAxes(normal);
    ASSERT_NEAR(glm::length(glm::cross(u, v) - normal), 0.0, 1e-14) << i;
    // Every third form is nearly diagonal, every fifth nearly umbilic.
    const double m = (i % 3 == 0 ? 1e-9 : 1.0) * random(4);
    const double l = random(5);
    const TangentForm form{ l, m, i % 5 == 0 ? l + 1e-9 * random(6) : random(6) };
    const PrincipalCurvature c = principalCurvature(form, u, v);
    ASSERT_GE(c.k1, c.k2) << i;
    for (const auto& [k, d] : { std::pair(c.k1, c.direction1), std::pair(c.k2, c.direction2) })
    {
      const double a = glm::dot(d, u);
      const double b = glm::dot(d, v);
      ASSERT_NEAR(form.l * a + form.m * b, k * a, 1e-14) << i;
      ASSERT_NEAR(form.m * a + form.n * b, k * b, 1e-14) << i;
      ASSERT_NEAR(glm::length(d), 1.0, 1e-14) << i;
    }
    ASSERT_NEAR(glm::length(c.normal() - normal), 0.0, 1e-14) << i;
    ASSERT_NEAR(c.along(u), form.l, 1e-14) << i;
    ASSERT_NEAR(c.along(3.0 * v), form.n, 1e-14) << i;
  }
}

TEST(PrincipalCurvature, EquationNineNeedsTheSquareOfM)
{
  // A cylinder of radius 1/2 whose axis is 30 degrees from the u axis: curvature 2 across it.
  const double angle = std::acos(-1.0) / 6.0;
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const TangentForm form{ 2.0 * s * s, -2.0 * s * c, 2.0 * c * c };
  const PrincipalCurvature found =
    principalCurvature(form, glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_NEAR(found.k1, 2.0, 1e-15);
  EXPECT_NEAR(found.k2, 0.0, 1e-15);
  EXPECT_NEAR(std::abs(found.direction2.x), c, 1e-15);
  // With 4 m^2, its roots are these directions.
  const double across = rootOfEquation9(form, 4.0 * form.m * form.m, 1.0);
  const double alongAxis = rootOfEquation9(form, 4.0 * form.m * form.m, -1.0);
  EXPECT_NEAR(normalCurvature(form, across), 2.0, 1e-14);
  EXPECT_NEAR(normalCurvature(form, alongAxis), 0.0, 1e-14);
  EXPECT_NEAR(across, found.direction1.y / found.direction1.x, 1e-14);
  // As printed, with 4 m, the root is of a negative number here, and its directions are no extrema elsewhere.
  EXPECT_TRUE(std::isnan(rootOfEquation9(form, 4.0 * form.m, 1.0)));
  const TangentForm other{ 1.0, 3.0, 2.0 };
  const double largest = principalCurvature(other, glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)).k1;
  EXPECT_NEAR(normalCurvature(other, rootOfEquation9(other, 4.0 * 3.0 * 3.0, 1.0)), largest, 1e-14);
  EXPECT_LT(normalCurvature(other, rootOfEquation9(other, 4.0 * 3.0, 1.0)), largest - 0.2);
}

TEST(PrincipalCurvature, EquationNineHasNoCaseForDirectionsAlongTheAxes)
{
  const TangentForm form{ 1.0, 0.0, 3.0 };
  EXPECT_FALSE(std::isfinite(rootOfEquation9(form, 4.0 * form.m * form.m, -1.0)));
  const PrincipalCurvature found =
    principalCurvature(form, glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_EQ(found.k1, 3.0);
  EXPECT_EQ(found.k2, 1.0);
  EXPECT_EQ(std::abs(found.direction1.y), 1.0);
  EXPECT_EQ(std::abs(found.direction2.x), 1.0);
}

TEST(PrincipalCurvature, UmbilicMeasure)
{
  EXPECT_EQ(umbilicMeasure(2.0, 2.0), 1.0);
  EXPECT_EQ(umbilicMeasure(-2.0, -2.0), 1.0);
  EXPECT_EQ(umbilicMeasure(0.0, 0.0), 1.0);
  EXPECT_EQ(umbilicMeasure(2.0, 0.0), 0.0);
  EXPECT_EQ(umbilicMeasure(0.0, -2.0), 0.0);
  EXPECT_EQ(umbilicMeasure(1.0, -3.0), 0.0);
  EXPECT_DOUBLE_EQ(umbilicMeasure(3.0, 1.0), 0.5);
  // What is noise only is a plane.
  EXPECT_EQ(umbilicMeasure(1e-12, -1e-12), 0.0);
  EXPECT_EQ(umbilicMeasure(1e-12, -1e-12, 1e-9), 1.0);
  EXPECT_NEAR(umbilicMeasure(3.0, 1.0, 1e-9), 0.5, 1e-8);
}
