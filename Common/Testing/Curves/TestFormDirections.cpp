// SPDX-License-Identifier: BSD-3-Clause
// Directions of a form at large: around a dented cylinder, along parallels of a sphere, as they are
// elsewhere.

#include "Curves/Streamlines/FormDirections.h"

#include "Curvature/MeshCurvature.h"
#include "MeshesWithCurvature.h"
#include "SampledMeshes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

constexpr double bend = 0.06;

std::vector<glm::vec3> normalsOf(const std::vector<PrincipalCurvature>& points)
{
  std::vector<glm::vec3> normals;
  std::transform(points.begin(), points.end(), std::back_inserter(normals),
    [](const PrincipalCurvature& at) { return glm::vec3(at.normal()); });
  return normals;
}

/// A cylinder around z of radius 1, with dents that bend it more than it is bent itself.
Mesh dentedCylinder()
{
  Mesh mesh;
  mesh.addPatch(300, 200,
    [](double u, double v)
    {
      const double angle = 2.0 * std::numbers::pi * u;
      const double z = 4.0 * v - 2.0;
      const double radius = 1.0 + 0.004 * std::sin(20.0 * angle) * std::sin(20.0 * z);
      return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
    });
  return mesh;
}

} // namespace

TEST(FormDirections, AroundADentedCylinder)
{
  const Mesh mesh = dentedCylinder();
  const std::vector<PrincipalCurvature> local = estimateCurvature(mesh.view(), {}, {}).points;
  constexpr double distance = 0.03;
  const FormDirections form = formDirections(mesh.view(), normalsOf(local), local, bend / distance, distance);
  int count = 0;
  int astray = 0;
  int astrayBefore = 0;
  for (std::size_t i = 0; i < local.size(); ++i)
  {
    const glm::dvec3& p = mesh.points[i];
    if (std::abs(p.z) > 1.5)
    {
      continue;
    }
    const glm::dvec3 around = glm::normalize(glm::dvec3(-p.y, p.x, 0.0));
    const double cosine = std::cos(15.0 * std::numbers::pi / 180.0);
    ++count;
    astray += std::abs(glm::dot(form.directions[0][i], around)) < cosine ? 1 : 0;
    astrayBefore += std::abs(glm::dot(local[i].direction1, around)) < cosine ? 1 : 0;
    EXPECT_GT(form.preferences[i], 0.0f);
    EXPECT_LE(form.umbilics[i], 0.5f);
  }
  EXPECT_GT(astrayBefore, count / 4);
  EXPECT_EQ(astray, 0) << "of " << count;
}

TEST(FormDirections, ParallelsOfASphere)
{
  const MeshWithCurvature sphere = ellipsoid({ 1.0, 1.0, 1.0 }, 4);
  const FormDirections form =
    formDirections(sphere.mesh.view(), normalsOf(sphere.exact), sphere.exact, 0.01, 0.02);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(-1.0, -1.0, 1.0));
  for (std::size_t i = 0; i < sphere.exact.size(); ++i)
  {
    EXPECT_NEAR(glm::dot(form.directions[0][i], axis), 0.0, 1e-6);
    EXPECT_NEAR(glm::dot(form.directions[0][i], sphere.mesh.points[i]), 0.0, 1e-6);
    EXPECT_NEAR(glm::length(form.directions[1][i]), 1.0, 1e-6);
    EXPECT_GT(form.umbilics[i], 0.9f);
    EXPECT_LT(form.umbilics[i], 1.0f);
  }
}

TEST(FormDirections, AsTheyAreWhereCurvatureHasThem)
{
  const MeshWithCurvature torus = closedTorus(1.0, 0.25, 120, 60);
  const FormDirections form =
    formDirections(torus.mesh.view(), normalsOf(torus.exact), torus.exact, 0.01, 0.02);
  for (std::size_t i = 0; i < torus.exact.size(); ++i)
  {
    EXPECT_NEAR(glm::distance(form.directions[0][i], torus.exact[i].direction1), 0.0, 1e-12);
    EXPECT_EQ(form.umbilics[i], static_cast<float>(torus.exact[i].umbilicMeasure(0.01)));
  }
}

TEST(FormDirections, Input)
{
  const MeshWithCurvature torus = closedTorus(1.0, 0.25, 12, 6);
  const std::vector<glm::vec3> normals = normalsOf(torus.exact);
  EXPECT_THROW(formDirections(torus.mesh.view(), {}, torus.exact, 0.01, 0.02), std::invalid_argument);
  EXPECT_THROW(formDirections(torus.mesh.view(), normals, {}, 0.01, 0.02), std::invalid_argument);
  const FormDirections empty = formDirections({}, {}, {}, 0.01, 0.02);
  EXPECT_TRUE(empty.umbilics.empty());
  std::vector<PrincipalCurvature> unknown(torus.exact.size());
  for (PrincipalCurvature& at : unknown)
  {
    at.k1 = std::numeric_limits<double>::quiet_NaN();
  }
  const FormDirections form =
    formDirections(torus.mesh.view(), std::vector<glm::vec3>(normals.size()), unknown, 0.01, 0.02);
  for (const float umbilic : form.umbilics)
  {
    EXPECT_EQ(umbilic, 1.0f);
  }
}

TEST(FormDirections, PlanesHaveNone)
{
  const Mesh plane = square(30);
  std::vector<PrincipalCurvature> flat(plane.points.size());
  const FormDirections form = formDirections(
    plane.view(), std::vector<glm::vec3>(flat.size(), glm::vec3(0.0f, 0.0f, 1.0f)), flat, 1.0, 0.01);
  for (const float umbilic : form.umbilics)
  {
    EXPECT_EQ(umbilic, 1.0f);
  }
}
