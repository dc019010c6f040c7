// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/InsideOut.h"

#include "MeshesWithCurvature.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

Mesh turned(Mesh mesh)
{
  for (Triangle& triangle : mesh.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

} // namespace

TEST(InsideOut, ClosedMeshesBothWays)
{
  // Far from the origin, too, and with a point that is not finite.
  for (const glm::dvec3& center : { glm::dvec3(0.0), glm::dvec3(1e6, -1e6, 1e6) })
  {
    for (Mesh mesh : { icosphere(2), torus(2.0, 0.7, 30, 20) })
    {
      for (glm::dvec3& p : mesh.points)
      {
        p += center;
      }
      mesh.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
      mesh.triangles.push_back({ 0, 1, static_cast<std::uint32_t>(mesh.points.size() - 1) });
      EXPECT_FALSE(isInsideOut(mesh.view()));
      EXPECT_TRUE(isInsideOut(turned(mesh).view()));
    }
  }
}

TEST(InsideOut, HolesAreAllowedAndOpenMeshesKeepTheirSides)
{
  Mesh holed = turned(icosphere(2));
  holed.triangles.resize(holed.triangles.size() - 10); // of 320
  EXPECT_TRUE(isInsideOut(holed.view()));
  holed.triangles.resize(holed.triangles.size() / 2);
  EXPECT_FALSE(isInsideOut(holed.view()));
  EXPECT_FALSE(isInsideOut(square(4).view()));
  EXPECT_FALSE(isInsideOut(turned(square(4)).view()));
  EXPECT_FALSE(isInsideOut(Mesh().view()));
}

TEST(InsideOut, NormalsOfClosedAndOpenSurfaces)
{
  for (const glm::dvec3& center : { glm::dvec3(0.0), glm::dvec3(1e6, -1e6, 1e6) })
  {
    Mesh ball = icosphere(2);
    ball.triangles.resize(ball.triangles.size() * 3 / 4); // open, as where an image ends
    std::vector<glm::vec3> outward;
    for (glm::dvec3& p : ball.points)
    {
      outward.emplace_back(p);
      p += center;
    }
    std::vector<glm::vec3> inward;
    std::transform(outward.begin(), outward.end(), std::back_inserter(inward), std::negate<>());
    // However triangles are wound.
    for (const Mesh& mesh : { ball, turned(ball) })
    {
      EXPECT_FALSE(facesInward(mesh.view(), outward));
      EXPECT_TRUE(facesInward(mesh.view(), inward));
    }
    EXPECT_THROW(facesInward(ball.view(), std::span(inward).first(3)), std::invalid_argument);
  }
}
