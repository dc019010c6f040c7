// SPDX-License-Identifier: BSD-3-Clause
// One direction for each flat face: along its border and its length, for any triangles, with noise, too.

#include "Curves/Streamlines/FlatDirections.h"

#include "HashNoise.h"
#include "MachineParts.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace ink;
using namespace ink::test;

/// An L of 2 x 1.6, .5 wide, in a plane turned about the x axis.
Mesh bracket(double turn)
{
  Mesh mesh;
  for (const glm::dvec2 p : { glm::dvec2(0, 0), glm::dvec2(2, 0), glm::dvec2(2, .5), glm::dvec2(.5, .5),
         glm::dvec2(.5, 1.6), glm::dvec2(0, 1.6) })
  {
    mesh.points.emplace_back(p.x, p.y * std::cos(turn), p.y * std::sin(turn));
  }
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 5 }, { 3, 4, 5 } };
  return mesh;
}

} // namespace

TEST(FlatDirections, AlongTheLongerSidesOfEachFace)
{
  for (const int cells : { 1, 5 })
  {
    const Mesh mesh = box({ 3.0, 2.0, 1.0 }, cells, false);
    const std::vector<glm::dvec3> found = flatDirections(mesh.view());
    const std::size_t perFace = mesh.points.size() / 6;
    // Across x: 2 x 1 in y and z; across y and z: 3 in x.
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const glm::dvec3 wanted = i < 2 * perFace ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
      EXPECT_NEAR(std::abs(glm::dot(found[i], wanted)), 1.0, 1e-9) << i;
    }
  }
}

TEST(FlatDirections, BordersDirectWhereTheExtentIsOblique)
{
  for (const double turn : { 0.0, 0.7, 2.0 })
  {
    for (const glm::dvec3& d : flatDirections(bracket(turn).view()))
    {
      EXPECT_NEAR(std::abs(d.x), 1.0, 1e-9) << turn;
    }
  }
}

TEST(FlatDirections, DiscsAndSquaresFollowAnAxis)
{
  const Mesh drum = cylinder(48, 4, 1.0, false);
  const std::vector<glm::dvec3> found = flatDirections(drum.view());
  std::size_t caps = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i] != glm::dvec3(0.0))
    {
      EXPECT_NEAR(found[i].x, 1.0, 1e-9);
      ++caps;
    }
  }
  EXPECT_EQ(caps, 2 * 48u); // the side is not flat
  const std::vector<glm::dvec3> cube = flatDirections(box({ 1.0, 1.0, 1.0 }, 3, false).view());
  for (std::size_t i = 0; i < cube.size(); ++i)
  {
    EXPECT_NEAR(std::abs(i < cube.size() / 3 ? cube[i].y : cube[i].x), 1.0, 1e-9) << i;
  }
}

TEST(FlatDirections, NoiseLeavesAFaceFlat)
{
  Mesh mesh;
  mesh.addPatch(40, 20, [](double u, double v) { return glm::dvec3(2.0 * u, v, 0.0); });
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    mesh.points[i].z += 0.01 * (2.0 * ink::testing::hashUniform(7, i) - 1.0);
  }
  for (const glm::dvec3& d : flatDirections(mesh.view()))
  {
    EXPECT_GT(std::abs(d.x), 0.999);
  }
  // A sheet folded in two faces to both sides.
  Mesh folded;
  folded.addPatch(8, 8, [](double u, double v) { return glm::dvec3(std::abs(2.0 * u - 1.0), v, 1e-3 * u); });
  for (const glm::dvec3& d : flatDirections(folded.view()))
  {
    EXPECT_EQ(d, glm::dvec3(0.0));
  }
}

TEST(FlatDirections, DegenerateMeshes)
{
  EXPECT_TRUE(flatDirections({}).empty());
  Mesh mesh;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { nan, 0, 0 }, { 5, 5, 5 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 0, 0 }, { 3, 3, 3 } };
  for (const glm::dvec3& d : flatDirections(mesh.view()))
  {
    EXPECT_EQ(d, glm::dvec3(0.0));
  }
}
