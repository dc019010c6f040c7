// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/GeodesicUnfolding.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

namespace
{

using namespace ink::test;

constexpr float far = 1e30f;

struct Unfolder
{
  explicit Unfolder(const Mesh& from)
    : mesh(from)
    , points(from.points.begin(), from.points.end())
    , unfolding(this->points, this->mesh.triangles)
  {
  }

  /// The position in the triangle whose center is nearest.
  ink::GeodesicUnfolding::SurfacePoint at(const glm::vec3& position) const
  {
    std::uint32_t best = 0;
    float least = 1e30f;
    for (std::uint32_t t = 0; t < this->mesh.triangles.size(); ++t)
    {
      const auto& [a, b, c] = this->mesh.triangles[t];
      const glm::vec3 middle = (this->points[a] + this->points[b] + this->points[c]) / 3.0f;
      if (const float distance = glm::distance(middle, position); distance < least)
      {
        least = distance;
        best = t;
      }
    }
    const auto& [a, b, c] = this->mesh.triangles[best];
    return { (this->points[a] + this->points[b] + this->points[c]) / 3.0f, best };
  }

  float distance(const ink::GeodesicUnfolding::SurfacePoint& a, const ink::GeodesicUnfolding::SurfacePoint& b,
    float limit) const
  {
    float distance = far;
    ink::GeodesicUnfolding::Front front;
    this->unfolding.visitAround(a, limit, front,
      [&](std::uint32_t triangle, const auto&, const glm::vec3& image, const float*)
      { distance = triangle == b.triangle ? glm::distance(image, b.position) : distance; });
    return distance < limit ? distance : far;
  }

  float distance(const glm::vec3& a, const glm::vec3& b, float limit = 100.0f) const
  {
    return this->distance(this->at(a), this->at(b), limit);
  }

  Mesh mesh;
  std::vector<glm::vec3> points;
  ink::GeodesicUnfolding unfolding;
};

} // namespace

TEST(GeodesicUnfolding, IsStraightInAPlane)
{
  const Unfolder plane(square(30));
  for (const glm::vec3& to :
    { glm::vec3(0.9f, 0.8f, 0), glm::vec3(0.1f, 0.93f, 0), glm::vec3(0.15f, 0.1f, 0) })
  {
    const auto a = plane.at({ 0.1f, 0.1f, 0 });
    const auto b = plane.at(to);
    EXPECT_NEAR(plane.distance(a, b, 10.0f), glm::distance(a.position, b.position), 1e-5f);
    EXPECT_EQ(plane.distance(a, b, 0.9f * glm::distance(a.position, b.position)), far);
  }
}

TEST(GeodesicUnfolding, GoesAroundASphereAlongGreatCircles)
{
  const Unfolder ball(sphere(200, 100));
  const auto a = ball.at({ 1, 0, 0.1f });
  // Also across the seam at y = 0, where the mesh is joined by positions alone.
  for (const glm::vec3& to :
    { glm::vec3(0.5f, 0.7f, 0.4f), glm::vec3(0.9f, -0.4f, -0.2f), glm::vec3(0, 1, 0.5f) })
  {
    const auto b = ball.at(glm::normalize(to));
    const float angle = std::acos(glm::dot(glm::normalize(a.position), glm::normalize(b.position)));
    EXPECT_NEAR(ball.distance(a, b, 10.0f), angle, 0.02f * angle);
  }
}

TEST(GeodesicUnfolding, DoesNotJumpBetweenSheets)
{
  Mesh two = square(20);
  const Mesh upper = square(20, 0.01);
  const auto count = static_cast<std::uint32_t>(two.points.size());
  two.points.insert(two.points.end(), upper.points.begin(), upper.points.end());
  for (const auto& [a, b, c] : upper.triangles)
  {
    two.triangles.push_back({ a + count, b + count, c + count });
  }
  const Unfolder unfolder(two);
  EXPECT_EQ(unfolder.distance({ 0.5f, 0.5f, 0.0f }, { 0.55f, 0.52f, 0.01f }, 0.3f), far);
  EXPECT_LT(unfolder.distance({ 0.5f, 0.5f, 0.01f }, { 0.55f, 0.52f, 0.01f }, 0.3f), 0.1f);
}

TEST(GeodesicUnfolding, GoesRoundTheEndOfAFold)
{
  // A hairpin: up to x = 1 at height 0, round a half circle, and back at height 0.02.
  Mesh fold;
  const double r = 0.01;
  const double length = 2.0 + std::numbers::pi * r;
  fold.addPatch(400, 20,
    [=](double u, double v)
    {
      const double s = u * length;
      if (s < 1.0)
      {
        return glm::dvec3(s, v, 0.0);
      }
      const double angle = std::min((s - 1.0) / r, std::numbers::pi);
      const double back = std::max(s - 1.0 - std::numbers::pi * r, 0.0);
      return glm::dvec3(1.0 + r * std::sin(angle) - back, v, r * (1.0 - std::cos(angle)));
    });
  const Unfolder unfolder(fold);
  const auto a = unfolder.at({ 0.9f, 0.5f, 0.0f });
  const auto b = unfolder.at({ 0.95f, 0.55f, 0.02f });
  const float unfolded = (1.0f - a.position.x) + (1.0f - b.position.x) + std::numbers::pi_v<float> * float(r);
  const float exact = std::hypot(unfolded, b.position.y - a.position.y);
  const float found = unfolder.distance(a, b, 1.0f);
  EXPECT_GE(found, 0.99f * exact);
  EXPECT_LE(found, 1.01f * exact);
  EXPECT_EQ(unfolder.distance(a, b, 0.1f), far);
  // Far from the fold, the other side is out of reach.
  EXPECT_EQ(unfolder.distance({ 0.4f, 0.5f, 0.0f }, { 0.42f, 0.55f, 0.02f }, 0.5f), far);
}

TEST(GeodesicUnfolding, LooksAcrossAHole)
{
  Mesh mesh = square(20);
  std::erase_if(mesh.triangles,
    [&](const ink::Triangle& t)
    {
      const glm::dvec3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
      return std::abs(middle.x - 0.5) < 0.1 && std::abs(middle.y - 0.5) < 0.1;
    });
  const Unfolder unfolder(mesh);
  const auto a = unfolder.at({ 0.35f, 0.5f, 0 });
  const auto b = unfolder.at({ 0.65f, 0.55f, 0 });
  const float straight = glm::distance(a.position, b.position);
  const float found = unfolder.distance(a, b, 10.0f);
  // As if it were filled: the triangles around it lie in one plane.
  EXPECT_NEAR(found, straight, 1e-5f);
}

/// A right angle is laid flat exactly, however it is cut into triangles and whichever way these face.
TEST(GeodesicUnfolding, IsStraightRoundAnEdge)
{
  for (const bool mixed : { false, true })
  {
    Mesh mesh;
    mesh.addPatch(20, 10,
      [](double u, double v)
      { return u < 0.5 ? glm::dvec3(2.0 * u, v, 0.0) : glm::dvec3(1.0, v, 2.0 * u - 1.0); });
    for (std::size_t i = 0; mixed && i < mesh.triangles.size(); i += 3)
    {
      std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    }
    const Unfolder unfolder(mesh);
    const auto a = unfolder.at({ 0.8f, 0.3f, 0 });
    const auto b = unfolder.at({ 1.0f, 0.7f, 0.3f });
    const float flat = std::hypot(1.0f - a.position.x + b.position.z, b.position.y - a.position.y);
    EXPECT_NEAR(unfolder.distance(a, b, 2.0f), flat, 1e-5f);
  }
}

TEST(GeodesicUnfolding, GoesThroughEdgesOfManyTriangles)
{
  // Three half planes on the y axis.
  Mesh mesh;
  mesh.points = { { 0, 0, 0 }, { 0, 1, 0 }, { -1, 0.5, 0 }, { 1, 0.5, 0 }, { 0, 0.5, 1 } };
  mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } };
  const Unfolder unfolder(mesh);
  EXPECT_LT(unfolder.distance({ -0.3f, 0.5f, 0 }, { 0.3f, 0.5f, 0 }), 1.0f);
}

TEST(GeodesicUnfolding, TakesAnyOrientation)
{
  Mesh mesh = square(20);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
  {
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  }
  const Unfolder unfolder(mesh);
  const auto a = unfolder.at({ 0.1f, 0.2f, 0 });
  for (int i = 1; i < 40; ++i)
  {
    const auto b = unfolder.at({ 0.15f + 0.02f * i, 0.2f + 0.017f * i, 0 });
    EXPECT_NEAR(unfolder.distance(a, b, 10.0f), glm::distance(a.position, b.position), 1e-5f) << i;
  }
}
