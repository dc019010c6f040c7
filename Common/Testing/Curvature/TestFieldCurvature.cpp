// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/FieldCurvature.h"
#include "Curvature/SmoothedCurvature.h"

#include "AnalyticFields.h"
#include "Curves/Contours/DescribeContours.h"
#include "Fields/Grid/GridField.h"
#include "HashNoise.h"
#include "MeshesWithCurvature.h"
#include "SampledVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;

/// The negative of a field: what was denser outside is so inside.
template <class F>
struct Negative
{
  F field;
  double value(const glm::dvec3& p) const { return -this->field.value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return -this->field.gradient(p); }
  glm::dmat3 hessian(const glm::dvec3& p) const { return -this->field.hessian(p); }
};

/// Distances from a torus, positive inside, with noise in world units, of cubes of 3.2 / n.
ink::testing::Volume<double> distances(int n, double noise)
{
  std::uint64_t index = 0;
  return ink::testing::Volume<double>::from(
    GridGeometry(glm::ivec3(n + 1), glm::dvec3(-1.6), glm::dvec3(3.2 / n)),
    [&](const glm::dvec3& p) {
      return -ink::testing::Torus{ 1.0, 0.4 }.value(p) + noise * ink::testing::hashNormal(1, index++);
    });
}

} // namespace

TEST(FieldCurvature, OfATorus)
{
  const test::MeshWithCurvature torus = test::closedTorus(1.0, 0.4, 30, 20);
  const ink::testing::Torus outside{ 1.0, 0.4 };
  const Negative<ink::testing::Torus> inside{ outside };
  for (std::size_t i = 0; i < torus.exact.size(); ++i)
  {
    const PrincipalCurvature& exact = torus.exact[i];
    const PrincipalCurvature found = fieldCurvature(inside, torus.mesh.points[i]).value();
    ASSERT_NEAR(found.k1, exact.k1, 1e-12) << i;
    ASSERT_NEAR(found.k2, exact.k2, 1e-12) << i;
    ASSERT_NEAR(std::abs(glm::dot(found.direction1, exact.direction1)), 1.0, 1e-12) << i;
    ASSERT_NEAR(glm::dot(found.normal(), exact.normal()), 1.0, 1e-12) << i;
    // Denser outside: the normals point into the tube, and k1 and k2 change roles.
    const PrincipalCurvature turned = fieldCurvature(outside, torus.mesh.points[i]).value();
    ASSERT_NEAR(turned.k1, -exact.k2, 1e-12) << i;
    ASSERT_NEAR(turned.k2, -exact.k1, 1e-12) << i;
    ASSERT_NEAR(glm::dot(turned.normal(), exact.normal()), -1.0, 1e-12) << i;
  }
}

TEST(FieldCurvature, HasTheSignOfRadialCurvature)
{
  const test::MeshWithCurvature mesh = test::ellipsoid({ 1.0, 0.7, 0.5 }, 2);
  const test::EllipsoidField field{ { 1.0, 0.7, 0.5 } };
  const Eye eye = Eye::at({ 3.0, 4.0, 2.0 });
  for (const glm::dvec3& point : mesh.mesh.points)
  {
    const PrincipalCurvature found = fieldCurvature(field, point).value();
    const glm::dvec3 view = eye.from(point);
    const glm::dvec3 tangent = view - glm::dot(view, found.normal()) * found.normal();
    ASSERT_NEAR(found.along(tangent), radialCurvature(field, eye, point), 1e-12);
    ASSERT_GT(found.k2, 0.0); // of a convex surface
  }
}

TEST(FieldCurvature, IsNotDefinedWithoutAGradient)
{
  const ink::testing::Plane flat{ glm::dvec3(0.0), glm::dvec3(0.0) };
  EXPECT_FALSE(fieldCurvature(flat, glm::dvec3(1.0)));
  const ink::testing::Plane plane{ glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 2.0) };
  const PrincipalCurvature found = fieldCurvature(plane, glm::dvec3(1.0)).value();
  EXPECT_EQ(found.k1, 0.0);
  EXPECT_EQ(found.k2, 0.0);
  EXPECT_EQ(found.normal(), glm::dvec3(0.0, 0.0, -1.0));
}

TEST(FieldCurvature, OfAGridConvergesInSecondOrder)
{
  const test::MeshWithCurvature torus = test::closedTorus(1.0, 0.4, 40, 30);
  double errors[2];
  for (int level = 0; level < 2; ++level)
  {
    const ink::testing::Volume<double> volume = distances(40 << level, 0.0);
    const MeshCurvature found = fieldCurvatures(volume.field(), torus.mesh.points);
    errors[level] = test::curvatureErrors(torus.exact, found.points).curvature;
  }
  // Measured: 0.0463 and 0.0121.
  EXPECT_LT(errors[1], 0.02);
  EXPECT_GT(errors[0] / errors[1], 3.0);
}

TEST(SmoothedCurvature, RemovesNoise)
{
  const test::MeshWithCurvature torus = test::closedTorus(1.0, 0.4, 40, 30);
  const ink::testing::Volume<double> noisy = distances(60, 0.002);
  const auto error = [&](double deviation)
  {
    const MeshCurvature found = smoothedCurvatures(noisy.field(), glm::dvec3(deviation), torus.mesh.points);
    return test::curvatureErrors(torus.exact, found.points).curvature;
  };
  const double plain = error(0.0);
  EXPECT_EQ(plain,
    test::curvatureErrors(torus.exact, fieldCurvatures(noisy.field(), torus.mesh.points).points).curvature);
  EXPECT_GT(plain, 0.6);
  EXPECT_LT(error(2.0), 0.2 * plain);
}

TEST(SmoothedCurvature, IsUndefinedWhereNothingIsKnown)
{
  ink::testing::Volume<double> half = distances(30, 0.0);
  for (std::size_t i = 0; i < half.values.size() / 2; ++i)
  {
    half.values[i] = NAN;
  }
  const std::vector<glm::dvec3> points = { { 1.0, 0.0, -0.4 }, { 1.0, 0.0, 0.4 } };
  const MeshCurvature found = smoothedCurvatures(half.field(), glm::dvec3(1.0), points);
  EXPECT_EQ(found.sources[0], CurvatureSource::None);
  EXPECT_EQ(found.points[0].k1, 0.0);
  EXPECT_EQ(found.sources[1], CurvatureSource::Surface);
  EXPECT_NEAR(found.points[1].k1, 2.5, 0.4);
  EXPECT_THROW(smoothedCurvatures(half.field(), glm::dvec3(-1.0), points), std::invalid_argument);
}

TEST(SmoothedCurvature, TellsItsProgressAndStops)
{
  const ink::testing::Volume<double> volume = distances(30, 0.0);
  const std::vector<glm::dvec3> points(1000, glm::dvec3(1.0, 0.0, 0.4));
  double last = 0.0;
  bool rises = true;
  smoothedCurvatures(volume.field(), glm::dvec3(1.0), points,
    [&](double share)
    {
      rises = rises && share >= last;
      last = share;
      return true;
    });
  EXPECT_TRUE(rises);
  EXPECT_GT(last, 0.5);
  EXPECT_TRUE(
    smoothedCurvatures(volume.field(), glm::dvec3(1.0), points, [](double) { return false; }).points.empty());
}
