// SPDX-License-Identifier: BSD-3-Clause
// The triangles that an eye sees: of a sphere as analysis says, behind and around others, in whatever order
// and wherever the eye is.

#include "Visibility/SeenTriangles.h"

#include "SampledMeshes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

constexpr glm::dvec3 down(0.0, 0.0, -1.0);
/// Two pixels, the least.
constexpr double noMargin = 0.0;

glm::dvec3 middleOf(const Mesh& mesh, std::uint32_t triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  return (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
}

std::vector<bool> flagsOf(const Mesh& mesh, const Eye& eye, double margin, const glm::dvec3& axis = down)
{
  std::vector<bool> flags(mesh.triangles.size());
  const std::vector<std::uint32_t> seen = seenTriangles(mesh.view(), eye, axis, margin);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  for (const std::uint32_t t : seen)
  {
    flags[t] = true;
  }
  return flags;
}

/// How many triangles lie at a height.
std::size_t countAt(const Mesh& mesh, const std::vector<std::uint32_t>& triangles, double height)
{
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(),
    [&](std::uint32_t t) { return std::abs(middleOf(mesh, t).z - height) < 1e-9; }));
}

} // namespace

TEST(SeenTriangles, OfASphereTheCapThatFacesTheEye)
{
  const Mesh mesh = sphere(120, 60);
  constexpr double distance = 3.0;
  for (const bool parallel : { false, true })
  {
    const Eye eye = parallel ? Eye::along(down) : Eye::at({ 0.0, 0.0, distance });
    const double horizon = parallel ? 0.0 : 1.0 / distance;
    for (const double margin : { noMargin, 0.02, 0.1 })
    {
      const std::vector<bool> seen = flagsOf(mesh, eye, margin);
      // Behind the horizon those within the margin of the outline, by a square: up to sqrt(2) times as far.
      const double reach = std::max(margin, 2.0 / 1024);
      constexpr double triangle = 0.03;
      const double outline = parallel ? 1.0 : 1.0 / std::sqrt(distance * distance - 1.0);
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      {
        const glm::dvec3 p = middleOf(mesh, t);
        const double radius = std::hypot(p.x, p.y) / (parallel ? 1.0 : distance - p.z);
        const double within = (outline - radius) / (2.0 * outline);
        EXPECT_TRUE(seen[t] || (p.z < horizon && within > reach - triangle))
          << p.z << " with a margin of " << margin;
        EXPECT_TRUE(!seen[t] || p.z > horizon - 0.06 || within < std::sqrt(2.0) * reach + triangle)
          << p.z << " with a margin of " << margin;
      }
    }
  }
}

TEST(SeenTriangles, BehindAnotherSurfaceUpToTheMargin)
{
  // A large floor and a smaller sheet above its middle.
  Mesh mesh;
  mesh.addPatch(100, 100, [](double u, double v) { return glm::dvec3(4.0 * u - 2.0, 4.0 * v - 2.0, 0.0); });
  mesh.addPatch(40, 40, [](double u, double v) { return glm::dvec3(2.0 * u - 1.0, 2.0 * v - 1.0, 1.0); });
  for (const double margin : { 0.01, 0.05 })
  {
    const std::vector<bool> seen = flagsOf(mesh, Eye::along(down), margin);
    const double aside = 4.0 * margin; // world units
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const glm::dvec3 p = middleOf(mesh, t);
      const double within = 1.0 - std::max(std::abs(p.x), std::abs(p.y));
      const bool isHidden = p.z == 0.0 && within > aside + 0.06;
      EXPECT_TRUE(seen[t] != isHidden || (p.z == 0.0 && std::abs(within - aside) < 0.06))
        << p.x << " " << p.y << " " << p.z << " with a margin of " << margin;
    }
  }
  // From below it is the sheet that is hidden.
  const std::vector<bool> below = flagsOf(mesh, Eye::along(-down), 0.01);
  EXPECT_EQ(std::count(below.begin(), below.begin() + 20000, true), 20000);
  EXPECT_EQ(std::count(below.begin() + 20000, below.end(), true), 0);
}

TEST(SeenTriangles, TheRimOfWhatLiesRightBehind)
{
  // Nothing is beside the picture, so that the lower one is seen as far as the margin goes, on all sides.
  Mesh mesh = square(100, 1.0);
  mesh.addPatch(100, 100, [](double u, double v) { return glm::dvec3(u, v, 0.0); });
  const std::vector<bool> seen = flagsOf(mesh, Eye::along(down), 0.05);
  for (std::uint32_t t = 20000; t < mesh.triangles.size(); ++t)
  {
    const glm::dvec3 p = middleOf(mesh, t);
    const double inside = std::min({ p.x, p.y, 1.0 - p.x, 1.0 - p.y });
    EXPECT_TRUE(seen[t] ? inside < 0.062 : inside > 0.045) << p.x << ' ' << p.y;
  }
}

TEST(SeenTriangles, WhatIsNearEnoughBehindIsSeen)
{
  // The margin, of a picture of size 1, is .1 deep.
  for (const auto& [depth, isSeen] : { std::pair(0.09, true), std::pair(0.12, false) })
  {
    Mesh mesh = square(10);
    mesh.addPatch(
      10, 10, [&](double u, double v) { return glm::dvec3(0.3 + 0.4 * u, 0.3 + 0.4 * v, -depth); });
    const std::vector<std::uint32_t> seen = seenTriangles(mesh.view(), Eye::along(down), down, 0.1);
    EXPECT_EQ(countAt(mesh, seen, -depth), isSeen ? 200u : 0u) << depth;
  }
}

TEST(SeenTriangles, ALargeTriangleWhoseCornersAreHidden)
{
  Mesh mesh;
  mesh.points = { { -1.0, -0.8, 0.0 }, { 1.0, -0.8, 0.0 }, { 0.0, 1.0, 0.0 } };
  mesh.triangles = { { 0, 1, 2 } };
  for (const glm::dvec3 corner : std::vector<glm::dvec3>(mesh.points))
  {
    mesh.addPatch(2, 2,
      [&](double u, double v)
      { return glm::dvec3(corner.x + 0.6 * u - 0.3, corner.y + 0.6 * v - 0.3, 1.0); });
  }
  EXPECT_EQ(seenTriangles(mesh.view(), Eye::along(down), down, noMargin).size(), mesh.triangles.size());
  mesh.addPatch(1, 1, [](double u, double v) { return glm::dvec3(4.0 * u - 2.0, 4.0 * v - 2.0, 0.5); });
  const std::vector<std::uint32_t> seen = seenTriangles(mesh.view(), Eye::along(down), down, noMargin);
  EXPECT_EQ(seen.size(), mesh.triangles.size() - 1);
  EXPECT_EQ(seen.front(), 1u);
}

TEST(SeenTriangles, FromWithinOnlyWhatIsInFront)
{
  const Mesh mesh = sphere(60, 30);
  const std::vector<bool> seen = flagsOf(mesh, Eye::at(glm::dvec3(0.0)), noMargin);
  const double widest = std::cos(std::atan(2.0)); // to the sides, and to the corners
  const double corners = std::cos(std::atan(std::sqrt(8.0)));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const double along = -middleOf(mesh, t).z;
    EXPECT_TRUE(seen[t] || along < widest + 0.1) << along;
    const bool reachesBehind = std::abs(along) < 0.08;
    EXPECT_TRUE(!seen[t] || along > corners - 0.1 || reachesBehind) << along;
  }
}

TEST(SeenTriangles, ATriangleThatReachesBehindTheEyeIsSeen)
{
  Mesh mesh = square(4, -1.0);
  mesh.points.insert(mesh.points.end(), { { 0.4, 0.4, 1.0 }, { 0.6, 0.4, 1.0 }, { 0.5, 0.6, -5.0 } });
  const auto last = static_cast<std::uint32_t>(mesh.points.size() - 1);
  mesh.triangles.push_back({ last - 2, last - 1, last });
  const std::vector<bool> seen = flagsOf(mesh, Eye::at({ 0.5, 0.5, 0.0 }), noMargin);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 33);
}

TEST(SeenTriangles, TheSameOnAnyNumberOfThreads)
{
  Mesh mesh = torus(1.0, 0.4, 300, 200);
  const Mesh other = sphere(200, 100);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles)
  {
    mesh.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }
  const auto found = [&] {
    return seenTriangles(mesh.view(), Eye::at({ 3.0, 1.0, 2.0 }), { -3.0, -1.0, -2.0 }, 0.01);
  };
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const std::vector<std::uint32_t> one = found();
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(one, found());
  EXPECT_GT(one.size(), mesh.triangles.size() / 8);
  EXPECT_LT(one.size(), mesh.triangles.size() / 2);
}

TEST(SeenTriangles, OfDegenerateInput)
{
  EXPECT_TRUE(seenTriangles({}, Eye::along(down), down, 0.1).empty());
  Mesh point;
  point.points = { { 1.0, 2.0, 3.0 }, { 1.0, 2.0, 3.0 }, { 1.0, 2.0, 3.0 } };
  point.triangles = { { 0, 1, 2 } };
  EXPECT_TRUE(seenTriangles(point.view(), Eye::along(down), down, 0.1).empty());
  // All of it behind the eye.
  EXPECT_TRUE(seenTriangles(square(4, 2.0).view(), Eye::at(glm::dvec3(0.0)), down, 0.1).empty());
  Mesh broken = square(4);
  broken.points[7].x = std::numeric_limits<double>::quiet_NaN();
  broken.points[9].z = std::numeric_limits<double>::infinity();
  EXPECT_GT(seenTriangles(broken.view(), Eye::along(down), down, noMargin).size(), 15u);
  EXPECT_THROW(
    seenTriangles(broken.view(), Eye::at(glm::dvec3(9.0)), glm::dvec3(0.0), 0.1), std::invalid_argument);
  EXPECT_THROW(seenTriangles(broken.view(), Eye::along(glm::dvec3(0.0)), down, 0.1), std::invalid_argument);
}
