// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of meshes whose contours are known.
#include "MeshContourTesting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ink::test;

TEST(MeshContours, OfASphereIsACircle)
{
  const std::vector<ink::Eye> eyes = { ink::Eye::at({ 1.3, 2.1, 3.7 }), ink::Eye::at({ -20, 5, 3 }),
    ink::Eye::along({ 0.3, -0.5, 0.2 }) };
  for (const ink::Eye& eye : eyes)
  {
    double before = 0.0;
    for (const int rows : { 20, 40, 80 })
    {
      const Mesh mesh = sphere(2 * rows, rows);
      const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
      const ink::Contours contours = finder.find(eye, allArrays);
      ASSERT_EQ(contours.chains.size(), 1u) << rows;
      EXPECT_TRUE(contours.chains.closed[0]);
      const double error = distanceFromCircle(contours, eye);
      if (before > 0.0)
      {
        EXPECT_LT(error, 0.3 * before) << rows; // second order
      }
      before = error;
      for (std::size_t i = 0; i < contours.positions.size(); ++i)
      {
        EXPECT_NEAR(glm::dot(glm::dvec3(contours.normals[i]), contours.positions[i]), 1.0, 0.02);
        EXPECT_NEAR(contours.radialCurvature[i], 1.0, 0.05);
      }
    }
    EXPECT_LT(before, 1e-3);
  }
}

TEST(MeshContours, OfATorusAreTwoClosedCurvesOutsideAndOneInside)
{
  // Analytically: with n = (cos u cos v, sin u cos v, sin v), n.(e - p) = 0 is A(u) cos v + e_z sin v = r
  // with A(u) = e.(cos u, sin u, 0) - R, which has two solutions v where A^2 + e_z^2 > r^2.
  const double radius = 1.0;
  const double tube = 0.4;
  const Mesh mesh = torus(radius, tube, 96, 64);
  const ink::MeshContours finder(mesh.view(), tubeNormals(mesh, radius));
  int inside = 0;
  for (std::uint64_t id = 0; id < 1000; ++id)
  {
    const glm::dvec3 point = (id % 2 == 0 ? 1.5 : 20.0) * randomPoint(id);
    const double distance = std::hypot(std::hypot(point.x, point.y) - radius, point.z);
    // Not where two curves nearly touch.
    if (std::abs(std::abs(point.z) - tube) < 0.1 * tube || std::abs(distance - tube) < 0.1 * tube)
    {
      continue;
    }
    const ink::Contours contours = finder.find(ink::Eye::at(point));
    expectValid(contours);
    EXPECT_EQ(contours.chains.size(), distance < tube ? 1u : 2u) << id;
    EXPECT_EQ(closedChains(contours), contours.chains.size()) << id;
    inside += distance < tube;
  }
  EXPECT_GT(inside, 10);
  // On the axis, from which the curves are circles, and at infinity there.
  for (const ink::Eye& eye :
    { ink::Eye::at({ 0, 0, 3 }), ink::Eye::at({ 0, 0, 0 }), ink::Eye::along({ 0, 0, 1 }) })
  {
    EXPECT_EQ(closedChains(finder.find(eye)), 2u);
  }
}

TEST(MeshContours, TellASurfaceWithABorder)
{
  Mesh mesh = torus(1.0, 0.4, 24, 16);
  const auto isClosed = [&] { return ink::MeshContours(mesh.view(), tubeNormals(mesh, 1.0)).isClosed(); };
  EXPECT_TRUE(isClosed());
  // Any one face less, and with a point more that lies where another one does.
  for (const std::size_t face : { std::size_t(0), std::size_t(100), mesh.triangles.size() - 1 })
  {
    std::swap(mesh.triangles[face], mesh.triangles.back());
    const ink::Triangle last = mesh.triangles.back();
    mesh.triangles.pop_back();
    EXPECT_FALSE(isClosed()) << face;
    mesh.points.push_back(mesh.points[last[0]]);
    mesh.triangles.push_back({ static_cast<std::uint32_t>(mesh.points.size() - 1), last[2], last[1] });
    EXPECT_TRUE(isClosed()) << face << ", the other way round";
  }
}

TEST(MeshContours, OfAnEyeInsideASphereAreNone)
{
  const Mesh mesh = sphere(40, 20);
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
  EXPECT_EQ(finder.find(ink::Eye::at({ 0.2, -0.1, 0.3 })).chains.size(), 0u);
}

/// With n.v = 0 exactly at points, the contour runs along them once.
TEST(MeshContours, RunThroughPointsWhereTheNormalIsAtRightAngles)
{
  Mesh mesh = sphere(40, 20);
  for (glm::dvec3& point : mesh.points)
  {
    point.z = std::abs(point.z) < 1e-9 ? 0.0 : point.z;
  }
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
  for (const double direction : { -1.0, 1.0 })
  {
    const ink::Contours contours = finder.find(ink::Eye::along({ 0, 0, direction }), allArrays);
    expectValid(contours);
    ASSERT_EQ(contours.chains.size(), 1u);
    EXPECT_TRUE(contours.chains.closed[0]);
    ASSERT_EQ(contours.positions.size(), 40u);
    for (const glm::dvec3& p : contours.positions)
    {
      EXPECT_EQ(p.z, 0.0);
    }
    EXPECT_NEAR(contours.arcLength.back(), 39.0 / 40.0 * 2.0 * std::numbers::pi, 0.01);
  }
}

TEST(MeshContours, OfACubeWithNormalsOfItsSidesAreItsEdges)
{
  std::vector<glm::vec3> normals;
  const Mesh mesh = splitCube(normals);
  const ink::MeshContours interpolated(mesh.view(), normals);
  ink::MeshContourOptions options;
  options.faceted = true;
  const ink::MeshContours faceted(mesh.view(), {}, options);
  struct View
  {
    ink::Eye eye;
    std::size_t edges;
  };
  for (const auto& [eye, edges] : { View{ ink::Eye::at({ 4, 5, 6 }), 6 },
         View{ ink::Eye::at({ 4, 5, 0 }), 6 }, View{ ink::Eye::at({ 0.3, 0.2, 9 }), 4 },
         View{ ink::Eye::along({ 1, -2, 3 }), 6 }, View{ ink::Eye::along({ 0, 0, -1 }), 4 } })
  {
    const ink::Contours contours = interpolated.find(eye, allArrays);
    ASSERT_EQ(contours.chains.size(), 1u);
    EXPECT_TRUE(contours.chains.closed[0]);
    EXPECT_EQ(contours.positions.size(), edges);
    EXPECT_EQ(contours.arcLength.back(), 2.0 * double(edges - 1));
    for (const float curvature : contours.radialCurvature)
    {
      EXPECT_GT(curvature, 0.0f);
    }
    const ink::Contours same = faceted.find(eye, allArrays);
    EXPECT_EQ(same.positions.size(), edges);
    EXPECT_EQ(same.chains.closed, contours.chains.closed);
    for (const glm::vec3& normal : same.normals)
    {
      EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
    }
  }
  // From inside there is nothing to see of its outside.
  EXPECT_EQ(interpolated.find(ink::Eye::at({ 0.1, 0.2, 0.3 })).chains.size(), 0u);
  EXPECT_EQ(faceted.find(ink::Eye::at({ 0.1, 0.2, 0.3 })).chains.size(), 0u);
}

/// The two lines along a can and the halves of its rims, which are sharp edges, are one closed chain.
TEST(MeshContours, FollowSharpEdgesBetweenSmoothSides)
{
  Mesh mesh;
  std::vector<glm::vec3> normals;
  const auto around = [](double u) { return u == 1.0 ? 0.0 : 2.0 * std::numbers::pi * u; };
  mesh.addPatch(50, 10,
    [&](double u, double v) { return glm::dvec3(std::cos(around(u)), std::sin(around(u)), 2.0 * v - 1.0); });
  for (const glm::dvec3& p : mesh.points)
  {
    normals.emplace_back(p.x, p.y, 0.0);
  }
  for (const double side : { -1.0, 1.0 })
  {
    mesh.addPatch(50, 5,
      [&](double u, double v) { return glm::dvec3(v * std::cos(around(u)), v * std::sin(around(u)), side); });
    normals.resize(mesh.points.size(), glm::vec3(0, 0, side));
  }
  const ink::MeshContours finder(mesh.view(), normals);
  for (std::uint64_t id = 0; id < 100; ++id)
  {
    const glm::dvec3 direction = randomPoint(id);
    const ink::Contours contours = finder.find(ink::Eye::along(direction), allArrays);
    expectValid(contours);
    ASSERT_EQ(contours.chains.size(), 1u) << id;
    EXPECT_TRUE(contours.chains.closed[0]);
    // Half of each rim, and two lines of length 2.
    double length =
      contours.arcLength.back() + glm::distance(contours.positions.front(), contours.positions.back());
    EXPECT_NEAR(length, 2.0 * std::numbers::pi + 4.0, 0.05) << id;
  }
}

TEST(MeshContours, KeepTheirShapeFarFromTheOrigin)
{
  Mesh mesh = sphere(80, 40);
  const std::vector<glm::vec3> normals = radialNormals(mesh);
  const glm::dvec3 far(1e7, -2e7, 3e7);
  for (glm::dvec3& point : mesh.points)
  {
    point += far;
  }
  const ink::Eye near = ink::Eye::at({ 2, 3, 4 });
  const ink::MeshContours finder(mesh.view(), normals);
  ink::Contours contours = finder.find(ink::Eye::at(near.position + far));
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_TRUE(contours.chains.closed[0]);
  for (glm::dvec3& point : contours.positions)
  {
    point -= far;
  }
  EXPECT_LT(distanceFromCircle(contours, near), 0.002);
}

TEST(MeshContours, OfNothingAreNone)
{
  const Mesh empty;
  EXPECT_EQ(ink::MeshContours(empty.view(), {}).find(ink::Eye::at({ 1, 2, 3 })).chains.size(), 0u);
  Mesh points;
  points.points = { { 0, 0, 0 }, { 1, 0, 0 } };
  const std::vector<glm::vec3> normals(2, glm::vec3(0, 0, 1));
  const ink::MeshContourOptions all{ true, false, true, 30.0, true, true };
  EXPECT_EQ(ink::MeshContours(points.view(), normals, all).find(ink::Eye::at({ 1, 2, 3 })).chains.size(), 0u);
}

TEST(MeshContours, SayWhatIsWrong)
{
  const Mesh mesh = square(2);
  const auto messageOf = [](const auto& run)
  {
    try
    {
      run();
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::vector<glm::vec3> normals(9, glm::vec3(0, 0, 1));
  const std::vector<glm::vec3> few(3, glm::vec3(0, 0, 1));
  EXPECT_EQ(messageOf([&] { ink::MeshContours(mesh.view(), {}); }),
    "the mesh has no normals, expected one per point for interpolated silhouettes; faceted ones need none");
  EXPECT_EQ(messageOf([&] { ink::MeshContours(mesh.view(), few); }),
    "there are 3 normals for 9 points, expected one per point");
  EXPECT_NE(messageOf(
              [&] {
                ink::MeshContours(mesh.view(), normals, { true, false, true, -1.0, false, false });
              })
              .find("expected from 0 to 180"),
    std::string::npos);
  const ink::MeshContours finder(mesh.view(), normals);
  EXPECT_EQ(messageOf(
              [&] {
                finder.find(ink::Eye::at({ 0, 1.0 / 0.0, 0 }));
              }),
    "the eye's position is not finite");
  EXPECT_EQ(messageOf(
              [&] {
                finder.find(ink::Eye::along({ 0, 0, 0 }));
              }),
    "the eye's direction is zero, expected a vector into the scene");
  EXPECT_EQ(messageOf([&] { finder.find(ink::Eye::at({ 0, 0, 1 })); }), "");
}
