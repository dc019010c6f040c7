// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SolidMesh.h"

#include "MeshesWithCurvature.h"
#include "SampledMeshes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// A ball with its normals.
struct Ball
{
  Mesh mesh = icosphere(4);
  std::vector<glm::vec3> normals;

  Ball()
  {
    for (const glm::dvec3& p : this->mesh.points)
    {
      this->normals.emplace_back(p);
    }
  }
  bool solid() const { return isSolid(this->mesh.view(), this->normals); }
  /// Takes away the triangles around the pole, up to an angle in degrees.
  void open(double degrees)
  {
    const double height = std::cos(degrees * std::numbers::pi / 180.0);
    std::erase_if(
      this->mesh.triangles, [&](const Triangle& t) { return this->mesh.points[t[0]].z > height; });
  }
};

} // namespace

TEST(SolidMesh, ClosedOrWithSmallHoles)
{
  EXPECT_TRUE(Ball().solid());
  Ball holed;
  holed.open(3.0); // a hole of a seventh of the diagonal around
  EXPECT_TRUE(holed.solid());
  holed.open(20.0);
  EXPECT_FALSE(holed.solid());
  const Mesh sheet = square(4);
  EXPECT_FALSE(
    isSolid(sheet.view(), std::vector<glm::vec3>(sheet.points.size(), glm::vec3(0.0f, 0.0f, 1.0f))));
  EXPECT_FALSE(isSolid({}, {}));
}

TEST(SolidMesh, SeamsAreClosed)
{
  // Each triangle has points of its own, rounded.
  const Ball ball;
  Ball apart;
  apart.mesh = soupOf(ball.mesh);
  apart.normals.clear();
  for (std::size_t i = 0; i < apart.mesh.points.size(); ++i)
  {
    apart.normals.push_back(ball.normals[ball.mesh.triangles[i / 3][i % 3]]);
    apart.mesh.points[i] += 1e-8 * static_cast<double>((i - i % 3) % 7);
  }
  EXPECT_TRUE(apart.solid());
  apart.open(20.0);
  EXPECT_FALSE(apart.solid());
}

TEST(SolidMesh, NormalsSayWhatIsInside)
{
  // However triangles run.
  Ball ball;
  for (std::size_t t = 0; t < ball.mesh.triangles.size(); t += 3)
  {
    std::swap(ball.mesh.triangles[t][0], ball.mesh.triangles[t][1]);
  }
  EXPECT_TRUE(ball.solid());
  for (glm::vec3& normal : ball.normals)
  {
    normal = -normal;
  }
  EXPECT_FALSE(ball.solid());
}

TEST(SolidMesh, EachPartFarAwayToo)
{
  Ball two;
  const Ball other;
  const auto first = static_cast<std::uint32_t>(two.mesh.points.size());
  for (std::size_t i = 0; i < other.mesh.points.size(); ++i)
  {
    two.mesh.points.push_back(1e6 + 0.5 * other.mesh.points[i]);
    two.normals.push_back(other.normals[i]);
  }
  for (const auto& [a, b, c] : other.mesh.triangles)
  {
    two.mesh.triangles.push_back({ first + a, first + b, first + c });
  }
  // A point of no triangle, and a triangle of a point that is not finite.
  two.mesh.points.emplace_back(std::numeric_limits<double>::quiet_NaN());
  two.normals.emplace_back(0.0f);
  two.mesh.triangles.push_back({ 0, 1, static_cast<std::uint32_t>(two.mesh.points.size() - 1) });
  EXPECT_TRUE(two.solid());
  for (std::size_t i = first; i < two.normals.size(); ++i)
  {
    two.normals[i] = -two.normals[i];
  }
  EXPECT_FALSE(two.solid()) << "a hollow";
  two.normals.pop_back();
  EXPECT_THROW(two.solid(), std::invalid_argument);
}
