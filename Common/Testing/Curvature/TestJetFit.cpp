// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/JetFit.h"

#include "MeshesWithCurvature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace ink;

/// Heights of a function at irregular points.
template <class Height>
TangentPoints pointsOf(std::size_t count, double size, const Height& height)
{
  TangentPoints points;
  points.start({});
  for (std::size_t i = 0; i < count; ++i)
  {
    const double u = i == 0 ? 0.0 : size * (2.0 * ink::testing::hashUniform(1, i) - 1.0);
    const double v = i == 0 ? 0.0 : size * (2.0 * ink::testing::hashUniform(2, i) - 1.0);
    points.add({ u, v, height(u, v) });
  }
  return points;
}

} // namespace

TEST(JetFit, PolynomialsOfItsDegreeAreExact)
{
  for (const double unit : { 1e-9, 1.0, 1e9 })
  {
    // Slopes of 0.3 and -0.2, so that the metric counts; curvature by the formulas for graphs.
    const double f[10] = { 0.05, 0.3, -0.2, 0.4, -0.3, -0.6, 0.5, 0.2, -0.4, 0.3 };
    for (const int degree : { 2, 3 })
    {
      const TangentPoints points = pointsOf(20, unit,
        [&](double u, double v)
        {
          const double a = u / unit;
          const double b = v / unit;
          const double cubic = f[6] * a * a * a + f[7] * a * a * b + f[8] * a * b * b + f[9] * b * b * b;
          return unit *
            (f[0] + f[1] * a + f[2] * b + f[3] * a * a + f[4] * a * b + f[5] * b * b +
              (degree == 3 ? cubic : 0.0));
        });
      const JetFit fit = fitJet(points, points.count, degree).value();
      const double w = std::sqrt(1.0 + 0.3 * 0.3 + 0.2 * 0.2);
      const double fuu = 2.0 * f[3];
      const double fvv = 2.0 * f[5];
      const double mean =
        -((1.0 + f[2] * f[2]) * fuu - 2.0 * f[1] * f[2] * f[4] + (1.0 + f[1] * f[1]) * fvv) /
        (2.0 * w * w * w);
      const double gauss = (fuu * fvv - f[4] * f[4]) / (w * w * w * w);
      EXPECT_NEAR(fit.curvature.mean() * unit, mean, 1e-9) << degree << ", unit " << unit;
      EXPECT_NEAR(fit.curvature.gauss() * unit * unit, gauss, 1e-9) << degree << ", unit " << unit;
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-f[1], -f[2], 1.0));
      EXPECT_NEAR(glm::dot(fit.curvature.normal(), normal), 1.0, 1e-12) << degree << ", unit " << unit;
      EXPECT_NEAR(glm::length(fit.curvature.direction1), 1.0, 1e-12);
      EXPECT_LT(fit.residual, 1e-7 * unit);
      EXPECT_EQ(fit.count, 20u);
    }
  }
}

TEST(JetFit, DerivativesOfATorusConvergeInFirstOrder)
{
  // k1 is constant; k2 = cos t / (R + r cos t) changes along direction 1, around the tube, only.
  const double radius = 1.0;
  const double tube = 0.4;
  const double t = 0.9;
  const double out = radius + tube * std::cos(t);
  const double exact = -radius * std::sin(t) / (out * out) / tube;
  double errors[2];
  for (int level = 0; level < 2; ++level)
  {
    const double size = 0.01 / (1 << level);
    // The frame is not quite the tangent plane.
    const double tilt = 0.05;
    const glm::dvec3 normal(std::cos(t + tilt), 0.0, std::sin(t + tilt));
    const glm::dvec3 axisU(0.0, 1.0, 0.0);
    TangentPoints points;
    points.start({ glm::dvec3(out, 0.0, tube * std::sin(t)), axisU, glm::cross(normal, axisU), normal });
    for (int i = -3; i <= 3; ++i)
    {
      for (int j = -3; j <= 3; ++j)
      {
        const double around = (i + 0.2 * j) * size / out;
        const double across = t + (j + 0.1 * i * i) * size / tube;
        const double here = radius + tube * std::cos(across);
        points.add({ here * std::cos(around), here * std::sin(around), tube * std::sin(across) });
      }
    }
    const JetFit fit = fitJet(points, points.count, 3).value();
    // Direction 1 may be the other way round.
    const double sign = glm::dot(fit.curvature.direction1, glm::dvec3(-std::sin(t), 0.0, std::cos(t)));
    errors[level] = std::abs(fit.derivative.c111) + std::abs(fit.derivative.c112) +
      std::abs(sign * fit.derivative.c122 - exact) + std::abs(fit.derivative.c222);
  }
  EXPECT_LT(errors[1], 0.1) << "of " << exact;
  EXPECT_GT(errors[0] / errors[1], 1.8);
}

TEST(JetFit, TheResidualIsTheNoise)
{
  // An average over fits, each of which knows it by some ten degrees of freedom only.
  double sum = 0.0;
  double curvature = 0.0;
  double predicted = 0.0;
  constexpr int fits = 400;
  for (int n = 0; n < fits; ++n)
  {
    TangentPoints points;
    points.start({});
    for (int i = -3; i <= 3; ++i)
    {
      for (int j = -3; j <= 3; ++j)
      {
        const double noise = ink::testing::hashNormal(
          100 + static_cast<unsigned>(n), static_cast<unsigned>(7 * (i + 3) + j + 3));
        points.add({ 0.1 * i, 0.1 * j, 1e-3 * noise });
      }
    }
    const JetFit fit = fitJet(points, points.count, 3).value();
    sum += fit.residual * fit.residual;
    curvature += 0.5 * (fit.curvature.k1 * fit.curvature.k1 + fit.curvature.k2 * fit.curvature.k2);
    predicted += fit.noise() * fit.noise();
  }
  EXPECT_NEAR(std::sqrt(sum / fits), 1e-3, 1e-4);
  // The factor was measured on rings; other outlines differ a little.
  EXPECT_NEAR(std::sqrt(predicted / curvature), 1.0, 0.4);
}

TEST(JetFit, TooFewOrCollinearPointsDetermineNone)
{
  const auto flat = [](double, double) { return 0.0; };
  TangentPoints points = pointsOf(9, 1.0, flat);
  EXPECT_FALSE(fitJet(points, 9, 3));
  EXPECT_TRUE(fitJet(points, 9, 2));
  EXPECT_FALSE(fitJet(points, 5, 2));
  points.start({});
  for (int i = 0; i < 40; ++i)
  {
    points.add({ 0.1 * i, 0.2 * i, 0.0 });
  }
  EXPECT_FALSE(fitJet(points, points.count, 2));
  points.start({});
  for (int i = 0; i < 40; ++i)
  {
    points.add(glm::dvec3(0.0));
  }
  EXPECT_FALSE(fitJet(points, points.count, 2));
  EXPECT_FALSE(fitPinnedQuadric(points));
}

TEST(JetFit, PinnedQuadricsOfSpheresAreExact)
{
  // The neighbors of an octahedron's and of a tetrahedron's corner.
  for (const int count : { 3, 4 })
  {
    TangentPoints points;
    points.start({});
    points.add(glm::dvec3(0.0));
    const double height = count == 3 ? -4.0 / 3.0 : -1.0;
    const double width = std::sqrt(1.0 - (1.0 + height) * (1.0 + height));
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * i / count;
      points.add({ width * std::cos(angle), width * std::sin(angle), height });
    }
    const PrincipalCurvature found = fitPinnedQuadric(points).value();
    EXPECT_NEAR(found.k1, 1.0, 1e-9) << count;
    EXPECT_NEAR(found.k2, 1.0, 1e-9) << count;
  }
}
