// SPDX-License-Identifier: BSD-3-Clause
// One calm family of directions: where curvature says little, and along lines of curvature where it says
// much.

#include "Curves/Streamlines/CombDirections.h"

#include "Curvature/MeshCurvature.h"
#include "Curvature/TurnedTangent.h"
#include "Curves/Streamlines/FormDirections.h"
#include "Curves/Streamlines/SmoothCrossField.h"
#include "MeshesWithCurvature.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// A mesh with what is known of its form.
struct Formed
{
  Mesh mesh;
  std::vector<glm::vec3> normals;
  FormDirections form;

  /// @param distance of lines; a bend of .06 over it is negligible
  Formed(const Mesh& own, double distance)
    : mesh(own)
  {
    const std::vector<PrincipalCurvature> points = estimateCurvature(own.view(), {}, {}).points;
    std::transform(points.begin(), points.end(), std::back_inserter(this->normals),
      [](const PrincipalCurvature& at) { return glm::vec3(at.normal()); });
    this->form = formDirections(own.view(), this->normals, points, 0.06 / distance, distance);
  }
  std::vector<glm::dvec3> comb(double distance, const Progress& progress = {}) const
  {
    return combDirections(this->mesh.view(), this->normals, this->form.directions[0], this->form.umbilics,
      this->form.preferences, distance, progress);
  }
  /// The direction at another point, turned into the tangent plane of a point.
  glm::dvec3 turned(const std::vector<glm::dvec3>& directions, std::uint32_t from, std::uint32_t to) const
  {
    return turnedTangent(directions[from], glm::dvec3(this->normals[from]), glm::dvec3(this->normals[to]));
  }
  /// The share of edges whose ends differ by more than 45 degrees.
  double shareApart(const std::vector<glm::dvec3>& directions) const
  {
    double apart = 0.0;
    for (const Triangle& triangle : this->mesh.triangles)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t to = triangle[i];
        const double cosine = glm::dot(directions[to], this->turned(directions, triangle[(i + 1) % 3], to));
        apart += cosine * cosine < 0.5 ? 1.0 : 0.0;
      }
    }
    return apart / (3.0 * static_cast<double>(this->mesh.triangles.size()));
  }
  /// Triangles around which directions turn by half a turn.
  int singularities(const std::vector<glm::dvec3>& directions) const
  {
    return static_cast<int>(std::count_if(this->mesh.triangles.begin(), this->mesh.triangles.end(),
      [&](const Triangle& triangle)
      {
        double sign = 1.0;
        for (std::size_t i = 0; i < 3; ++i)
        {
          const std::uint32_t to = triangle[i];
          sign *= glm::dot(directions[to], this->turned(directions, triangle[(i + 1) % 3], to));
        }
        return sign < 0.0;
      }));
  }
};

/// Closed, hardly different from a sphere, with dents that bend it more than it is bent itself.
Mesh dentedBall()
{
  Mesh mesh = icosphere(5);
  for (glm::dvec3& p : mesh.points)
  {
    const double dent = std::sin(23.0 * p.x) * std::sin(19.0 * p.y) * std::sin(21.0 * p.z);
    p *= glm::dvec3(1.1, 1.0, 0.95) * (1.0 + 0.006 * dent);
  }
  return mesh;
}

constexpr double distance = 0.04;

} // namespace

TEST(CombDirections, OneFamilyWhereCurvatureSaysLittle)
{
  const Formed ball(dentedBall(), distance);
  const std::vector<glm::dvec3> combed = ball.comb(distance);
  // Before, by the sign of curvatures, smoothed as a cross field.
  const std::vector<glm::dvec3> crosses =
    smoothCrossField(ball.mesh.view(), ball.normals, ball.form.directions[0], ball.form.umbilics, 200);
  EXPECT_GT(ball.shareApart(crosses), 0.05);
  EXPECT_LT(ball.shareApart(combed), 0.002);
  // Their indices add up to 2 on any closed surface without handles: at least four of a half.
  EXPECT_GE(ball.singularities(combed), 4);
  EXPECT_LE(ball.singularities(combed), 12);
}

TEST(CombDirections, FollowLinesOfCurvature)
{
  // Around the tube, which bends most, also where it bends inwards along it.
  const MeshWithCurvature torus = closedTorus(1.0, 0.4, 120, 60);
  const Formed formed(torus.mesh, 0.02);
  const std::vector<glm::dvec3> combed = formed.comb(0.02);
  for (std::size_t i = 0; i < combed.size(); ++i)
  {
    ASSERT_GT(std::abs(glm::dot(combed[i], torus.exact[i].direction1)), 0.999) << i;
    ASSERT_NEAR(glm::length(combed[i]), 1.0, 1e-12);
    ASSERT_NEAR(glm::dot(combed[i], glm::dvec3(formed.normals[i])), 0.0, 1e-6);
  }
}

/// A bulge around a cylinder bends it more along its axis than it is bent around it. The family is the one
/// that most of the surface prefers: around it.
TEST(CombDirections, AFamilyGoesOnOverWhatBendsTheOtherWay)
{
  Mesh mesh;
  mesh.addPatch(120, 140,
    [](double u, double v)
    {
      const double along = 7.0 * (v - 0.5);
      const double radius = 1.0 + 0.72 * std::exp(-along * along / 0.36);
      const double angle = 1.8 * std::numbers::pi * (u - 0.5);
      return glm::dvec3(radius * std::sin(angle), along, radius * std::cos(angle));
    });
  const double lines = 0.04;
  const Formed formed(mesh, lines);
  const std::vector<glm::dvec3> combed = formed.comb(lines);
  int otherWay = 0;
  for (std::size_t i = 0; i < combed.size(); ++i)
  {
    const bool isAlong = std::abs(formed.form.directions[0][i].y) > 0.7;
    otherWay += (isAlong ? 1.0f : -1.0f) * formed.form.preferences[i] > 0.2f ? 1 : 0;
    ASSERT_LT(std::abs(combed[i].y), 0.15) << i;
  }
  EXPECT_GT(otherWay, 300);
}

TEST(CombDirections, TellsProgressStopsAndChecks)
{
  const Formed ball(icosphere(3), 0.1);
  double last = 0.0;
  const std::vector<glm::dvec3> combed = ball.comb(0.1,
    [&](double done)
    {
      EXPECT_GE(done, last);
      last = done;
      return true;
    });
  EXPECT_GE(last, 0.5);
  EXPECT_LE(last, 1.0);
  EXPECT_TRUE(combed == ball.comb(0.1));
  EXPECT_TRUE(ball.comb(0.1, [](double) { return false; }) == ball.form.directions[0]);
  EXPECT_THROW(
    combDirections(ball.mesh.view(), ball.normals, ball.form.directions[0], {}, ball.form.preferences, 0.1),
    std::invalid_argument);
}
