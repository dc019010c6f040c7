// SPDX-License-Identifier: BSD-3-Clause
// Walking straight on over meshes: across folds, seams and slivers, up to borders.

#include "Mesh/MeshNavigation.h"

#include "Core/Hash.h"
#include "SampledMeshes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>

namespace
{

using namespace ink;
using namespace ink::test;

/// Three quarters of a cylinder of radius 1 around the z axis, unrolled to x in [0, 3 pi / 2] and z in [0,
/// 4].
Mesh cylinder(int columns, double turn = 1.5 * std::numbers::pi)
{
  Mesh mesh;
  mesh.addPatch(columns, 10,
    [=](double u, double v) { return glm::dvec3(std::cos(turn * u), std::sin(turn * u), 4.0 * v); });
  return mesh;
}

std::size_t crossable(const MeshNavigation& navigation)
{
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < navigation.mesh().triangles.size(); ++t)
  {
    for (std::uint32_t edge = 0; edge < 3; ++edge)
    {
      count += navigation.across(t, edge) ? 1 : 0;
    }
  }
  return count;
}

} // namespace

TEST(MeshNavigation, WalksAreGeodesics)
{
  // On a prism geodesics are straight once it is unrolled.
  constexpr int columns = 24;
  const Mesh mesh = cylinder(columns);
  const MeshNavigation navigation(mesh.view(), 180.0);
  const double width = glm::distance(mesh.points[0], mesh.points[1]);
  const MeshPoint start{ 0, { 0.5, 0.5, 0.0 } };
  const glm::dvec3 across = glm::normalize(mesh.points[1] - mesh.points[0]);
  for (const double slope : { 0.0, 0.1, 0.37 })
  {
    const double distance = 7.3 * width;
    const glm::dvec3 direction = glm::normalize(across + slope * glm::dvec3(0.0, 0.0, 1.0));
    const auto end = navigation.walk(start, 17.0 * direction, distance);
    ASSERT_TRUE(end.has_value());
    const glm::dvec3 p = navigation.position(end->at);
    EXPECT_NEAR(p.z, distance * slope / std::hypot(1.0, slope), 1e-9) << slope;
    // Columns of the prism passed: the middle of the first and more.
    const double columnsPassed = 0.5 + distance / std::hypot(1.0, slope) / width;
    const double angle = 1.5 * std::numbers::pi / columns;
    const double whole = std::floor(columnsPassed);
    const glm::dvec3 a(std::cos(whole * angle), std::sin(whole * angle), p.z);
    const glm::dvec3 b(std::cos((whole + 1.0) * angle), std::sin((whole + 1.0) * angle), p.z);
    EXPECT_LT(glm::distance(p, a + (columnsPassed - whole) * (b - a)), 1e-8) << slope;
    EXPECT_NEAR(end->heading.z / glm::length(end->heading), slope / std::hypot(1.0, slope), 1e-9) << slope;
  }
  EXPECT_FALSE(navigation.walk(start, -across, width).has_value()); // beyond the border
  EXPECT_FALSE(navigation.walk(start, { 0.0, 0.0, 0.0 }, width).has_value());
}

TEST(MeshNavigation, SeamsAreClosed)
{
  // The last column of points is, up to rounding, at the first one's positions.
  const Mesh mesh = cylinder(24, 2.0 * std::numbers::pi);
  const MeshNavigation navigation(mesh.view(), 180.0);
  const std::size_t border = 2 * 24;
  EXPECT_EQ(crossable(navigation), 3 * mesh.triangles.size() - border);

  // Single precision, or worse.
  Mesh rounded = mesh;
  for (std::size_t i = 0; i < rounded.points.size(); ++i)
  {
    const auto random = [i](std::uint64_t n) { return 2.0 * unitDouble(hash(1, i, n)) - 1.0; };
    rounded.points[i] += 3e-7 * glm::dvec3(random(0), random(1), random(2));
  }
  EXPECT_EQ(crossable(MeshNavigation(rounded.view(), 180.0)), 3 * mesh.triangles.size() - border);
}

TEST(MeshNavigation, SliversAtSeamsAreLeftOut)
{
  // A column of quads that are 1e-15 wide.
  Mesh mesh;
  mesh.addPatch(5, 4,
    [](double u, double v)
    {
      const double x[] = { 0.0, 0.3, 0.5, 0.5 + 1e-15, 0.8, 1.0 };
      return glm::dvec3(x[std::lround(5.0 * u)], v, 0.0);
    });
  const MeshNavigation navigation(mesh.view(), 180.0);
  std::size_t usable = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    usable += navigation.isUsable(t) ? 1 : 0;
  }
  EXPECT_EQ(usable, 32u);
  const auto end = navigation.walk({ 0, { 0.4, 0.3, 0.3 } }, { 1.0, 0.2, 0.0 }, 0.7);
  ASSERT_TRUE(end.has_value());
  const glm::dvec3 from = navigation.position({ 0, { 0.4, 0.3, 0.3 } });
  EXPECT_LT(
    glm::distance(navigation.position(end->at), from + 0.7 * glm::normalize(glm::dvec3(1.0, 0.2, 0.0))),
    1e-8);
}

TEST(MeshNavigation, FeatureAndNonManifoldEdgesAreNotCrossed)
{
  const Mesh prism = cylinder(9); // folds of 30 degrees
  EXPECT_GT(crossable(MeshNavigation(prism.view(), 31.0)), crossable(MeshNavigation(prism.view(), 29.0)));

  Mesh flat = square(1);
  EXPECT_EQ(crossable(MeshNavigation(flat.view(), 180.0)), 2u);
  // The same edge once more.
  flat.points.emplace_back(0.0, 0.0, 1.0);
  flat.triangles.push_back({ flat.triangles[0][0], flat.triangles[0][2], 4 });
  EXPECT_EQ(crossable(MeshNavigation(flat.view(), 180.0)), 0u);
}

TEST(MeshNavigation, RoughnessMakesNoFeatures)
{
  // Waves of a period of two cells, steeper than 45 degrees to both sides, on the two sides of a roof.
  constexpr int cells = 40;
  Mesh mesh;
  mesh.addPatch(cells, cells,
    [](double u, double v)
    {
      const double wave = std::lround(cells * u) % 2 == 0 ? 0.0 : 1.5 / cells;
      return glm::dvec3(u, v, wave - std::abs(u - 0.5));
    });
  const std::size_t all = crossable(MeshNavigation(mesh.view(), 180.0));
  MeshNavigation navigation(mesh.view(), 180.0);
  EXPECT_LT(crossable(MeshNavigation(mesh.view(), 45.0)), all - 2 * cells * (cells / 2));
  navigation.cutFeatures(45.0, 10.0 / cells);
  // Only the ridge of the roof, where it is bent by 90 degrees, and what is near the border.
  const auto isCrossed = [&](double x)
  {
    const auto t = static_cast<std::uint32_t>(2 * (cells / 2 * cells + std::lround(x * cells)));
    const MeshPoint start{ t, glm::dvec3(1.0 / 3.0) };
    return navigation.walk(start, { 1.0, 0.0, 0.0 }, 4.0 / cells).has_value();
  };
  EXPECT_TRUE(isCrossed(0.3));
  EXPECT_TRUE(isCrossed(0.7));
  EXPECT_FALSE(isCrossed(0.475));

  // A thin plate keeps the edges of its rim, although one gets around it.
  Mesh plate = square(10);
  Mesh below = square(10, -0.01);
  const auto offset = static_cast<std::uint32_t>(plate.points.size());
  plate.points.insert(plate.points.end(), below.points.begin(), below.points.end());
  for (const auto& [a, b, c] : below.triangles)
  {
    plate.triangles.push_back({ a + offset, c + offset, b + offset });
  }
  for (std::uint32_t i = 0; i < 10; ++i) // the side at y = 0
  {
    plate.triangles.push_back({ i, i + offset, i + 1 });
    plate.triangles.push_back({ i + 1, i + offset, i + 1 + offset });
  }
  MeshNavigation edges(plate.view(), 180.0);
  const std::size_t before = crossable(edges);
  edges.cutFeatures(45.0, 0.3);
  EXPECT_EQ(crossable(edges), before - 2 * 2 * 10);
}

TEST(MeshNavigation, PointsHaveToExist)
{
  Mesh mesh = square(1);
  mesh.triangles.push_back({ 0, 1, 9 });
  EXPECT_THROW(MeshNavigation(mesh.view(), 180.0), std::invalid_argument);
}
