// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/FieldCurvatureDerivative.h"
#include "Curvature/SmoothedCurvature.h"

#include "AnalyticFields.h"
#include "Core/IsFinite.h"
#include "MeshesWithCurvature.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{

using namespace ink;

/// A torus around the z axis, greater inside.
struct Ring
{
  ink::testing::Torus outside{ 1.0, 0.4 };
  double value(const glm::dvec3& p) const { return -this->outside.value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return -this->outside.gradient(p); }
  glm::dmat3 hessian(const glm::dvec3& p) const { return -this->outside.hessian(p); }
};

/// The same torus, with a slope that changes along and across its surface.
struct UnevenRing
{
  Ring ring;
  glm::dvec3 change{ 0.3, 0.1, 0.2 };
  double slope(const glm::dvec3& p) const { return 1.0 + glm::dot(this->change, p); }
  double value(const glm::dvec3& p) const { return this->slope(p) * this->ring.value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const
  {
    return this->slope(p) * this->ring.gradient(p) + this->ring.value(p) * this->change;
  }
  glm::dmat3 hessian(const glm::dvec3& p) const
  {
    const glm::dmat3 mixed = glm::outerProduct(this->change, this->ring.gradient(p));
    return this->slope(p) * this->ring.hessian(p) + mixed + glm::transpose(mixed);
  }
};

/// z below 0.5 l x^2 + 0.5 n y^2 + a x^3 / 6 + b x^2 y / 2 + c x y^2 / 2 + d y^3 / 6.
struct Cubic
{
  double l, n, a, b, c, d;
  double value(const glm::dvec3& p) const
  {
    const auto [x, y] = std::pair(p.x, p.y);
    return 0.5 * (l * x * x + n * y * y + b * x * x * y + c * x * y * y) +
      (a * x * x * x + d * y * y * y) / 6.0 - p.z;
  }
  glm::dvec3 gradient(const glm::dvec3& p) const
  {
    const auto [x, y] = std::pair(p.x, p.y);
    return { l * x + 0.5 * a * x * x + b * x * y + 0.5 * c * y * y,
      n * y + 0.5 * b * x * x + c * x * y + 0.5 * d * y * y, -1.0 };
  }
  glm::dmat3 hessian(const glm::dvec3& p) const
  {
    const double xy = b * p.x + c * p.y;
    return { { l + a * p.x + b * p.y, xy, 0.0 }, { xy, n + c * p.x + d * p.y, 0.0 }, { 0.0, 0.0, 0.0 } };
  }
};

/// Between the spheres of radii 0.99 and 1.01.
struct Shell
{
  ink::testing::Sphere middle{ glm::dvec3(0.0), 1.0 };
  double sideOf(const glm::dvec3& p) const { return this->middle.value(p) > 0.0 ? -1.0 : 1.0; }
  double value(const glm::dvec3& p) const { return 0.01 - std::abs(this->middle.value(p)); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return this->sideOf(p) * this->middle.gradient(p); }
  glm::dmat3 hessian(const glm::dvec3& p) const { return this->sideOf(p) * this->middle.hessian(p); }
};

FieldDerivativeOptions everywhere(double step)
{
  return { step, [](const glm::dvec3& p) { return isFinite(p); } };
}

const test::MeshWithCurvature& ringMesh()
{
  static const test::MeshWithCurvature mesh = test::closedTorus(1.0, 0.4, 40, 30);
  return mesh;
}

/// The root mean square over the points of the ring; only c122 is not 0 there, see
/// MeshCurvature.DerivativesOfATorus.
double errorOn(const MeshCurvature& found)
{
  double squares = 0.0;
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    const glm::dvec3 p = ringMesh().mesh.points[i];
    const glm::dvec3 normal = ringMesh().exact[i].normal();
    const double out = std::hypot(p.x, p.y);
    const double exact = -normal.z / (out * out) / 0.4;
    // Around the tube.
    const glm::dvec3 along = glm::cross(glm::dvec3(p.y, -p.x, 0.0), normal);
    const double sign = glm::dot(found.points[i].direction1, along) > 0.0 ? 1.0 : -1.0;
    const CurvatureDerivative& d = found.derivatives[i];
    squares +=
      d.c111 * d.c111 + d.c112 * d.c112 + (sign * d.c122 - exact) * (sign * d.c122 - exact) + d.c222 * d.c222;
  }
  return std::sqrt(squares / static_cast<double>(found.points.size()));
}

} // namespace

TEST(FieldCurvatureDerivative, OfATorusConvergesInSecondOrder)
{
  const Ring ring;
  double errors[2];
  for (int level = 0; level < 2; ++level)
  {
    MeshCurvature found = fieldCurvatures(ring, ringMesh().mesh.points);
    addFieldDerivatives(ring, ringMesh().mesh.points, everywhere(0.05 / (1 << level)), found);
    errors[level] = errorOn(found);
  }
  MeshCurvature uneven = fieldCurvatures(UnevenRing(), ringMesh().mesh.points);
  addFieldDerivatives(UnevenRing(), ringMesh().mesh.points, everywhere(0.025), uneven);
  EXPECT_LT(errorOn(uneven), 0.004);
  // Measured: 0.0110 and 0.00278, of up to 2.9.
  EXPECT_LT(errors[1], 0.003);
  EXPECT_GT(errors[0] / errors[1], 3.8);
}

TEST(FieldCurvatureDerivative, OfATorusInAGridConverges)
{
  double errors[2];
  for (int level = 0; level < 2; ++level)
  {
    const int n = 40 << level;
    const auto volume = ink::testing::Volume<double>::from(
      GridGeometry(glm::ivec3(n + 1), glm::dvec3(-1.6), glm::dvec3(3.2 / n)),
      [](const glm::dvec3& p) { return Ring().value(p); });
    const MeshCurvature found =
      smoothedCurvatures(volume.field(), glm::dvec3(0.0), ringMesh().mesh.points, {}, true);
    errors[level] = errorOn(found);
  }
  // Measured: 0.159 and 0.049; between first and second order, as second derivatives are interpolated.
  EXPECT_LT(errors[1], 0.06);
  EXPECT_GT(errors[0] / errors[1], 2.5);
}

TEST(FieldCurvatureDerivative, HasTheCoefficientsOfACubic)
{
  // At its origin the axes are principal directions, and derivatives are those of the polynomial.
  const Cubic cubic{ -3.0, -1.0, 0.5, -0.8, 1.1, 0.7 };
  const glm::dvec3 origin(0.0);
  const PrincipalCurvature at = fieldCurvature(cubic, origin).value();
  ASSERT_EQ(at.k1, 3.0);
  ASSERT_EQ(at.k2, 1.0);
  const CurvatureDerivative found = fieldCurvatureDerivative(cubic, origin, at, everywhere(1e-3));
  const double s1 = at.direction1.x;
  const double s2 = at.direction2.y;
  ASSERT_EQ(std::abs(s1), 1.0);
  EXPECT_NEAR(s1 * found.c111, -0.5, 1e-4);
  EXPECT_NEAR(s2 * found.c112, 0.8, 1e-4);
  EXPECT_NEAR(s1 * found.c122, -1.1, 1e-4);
  EXPECT_NEAR(s2 * found.c222, -0.7, 1e-4);
}

TEST(FieldCurvatureDerivative, IsOneSidedWhereTheFieldEnds)
{
  const Cubic cubic{ -3.0, -1.0, 0.5, -0.8, 1.1, 0.7 };
  const glm::dvec3 origin(0.0);
  const PrincipalCurvature at = fieldCurvature(cubic, origin).value();
  FieldDerivativeOptions options = everywhere(1e-4);
  options.within = [](const glm::dvec3& p) { return p.x <= 1e-9 && p.y >= -1e-9; };
  const CurvatureDerivative found = fieldCurvatureDerivative(cubic, origin, at, options);
  EXPECT_NEAR(at.direction1.x * found.c111, -0.5, 5e-3);
  EXPECT_NEAR(at.direction2.y * found.c222, -0.7, 5e-3);
  options.within = [](const glm::dvec3&) { return false; };
  const CurvatureDerivative nothing = fieldCurvatureDerivative(cubic, origin, at, options);
  EXPECT_EQ(nothing.c111, 0.0);
  EXPECT_EQ(nothing.c112, 0.0);
  EXPECT_EQ(nothing.c122, 0.0);
  EXPECT_EQ(nothing.c222, 0.0);
}

TEST(FieldCurvatureDerivative, AnotherSheetDoesNotCount)
{
  // From the inside of a thin shell a step along it leads out of it, from where the gradient leads to the
  // outside.
  const Shell shell;
  const glm::dvec3 pole(0.0, 0.0, 0.99);
  const PrincipalCurvature at = fieldCurvature(shell, pole).value();
  FieldDerivativeOptions options = everywhere(0.3);
  options.within = [](const glm::dvec3& p) { return p.x >= 0.0 && p.y >= 0.0; };
  ASSERT_NEAR(at.k1, -1.0 / 0.99, 1e-12);
  const CurvatureDerivative found = fieldCurvatureDerivative(shell, pole, at, options);
  EXPECT_EQ(found.c111, 0.0);
  EXPECT_EQ(found.c222, 0.0);
}

TEST(FieldCurvatureDerivative, IsZeroWhereCurvatureIsNotDefinedAndStops)
{
  const Ring ring;
  std::vector<glm::dvec3> points(1000, glm::dvec3(1.0, 0.0, 0.4));
  points[1] = glm::dvec3(NAN);
  MeshCurvature found = fieldCurvatures(ring, points);
  addFieldDerivatives(ring, points, everywhere(0.01), found);
  ASSERT_EQ(found.derivatives.size(), points.size());
  EXPECT_NEAR(std::abs(found.derivatives[0].c122), 2.5, 0.01);
  EXPECT_EQ(found.derivatives[1].c122, 0.0);
  addFieldDerivatives(ring, points, everywhere(0.01), found, [](double) { return false; });
  EXPECT_TRUE(found.points.empty());
  EXPECT_TRUE(found.derivatives.empty());
}
