// SPDX-License-Identifier: BSD-3-Clause
// Creases, borders and edges of more than two faces.
#include "MeshContourTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace ink::test;

TEST(MeshContours, EndAtBorders)
{
  // Half a sphere, seen from the side.
  Mesh mesh = sphere(40, 20);
  std::erase_if(mesh.triangles,
    [&](const ink::Triangle& t)
    { return mesh.points[t[0]].z + mesh.points[t[1]].z + mesh.points[t[2]].z > 0.0; });
  ink::MeshContourOptions options;
  options.borders = true;
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh), options);
  const ink::Contours contours = finder.find(ink::Eye::along({ 1.0, 0.3, 0.1 }), allArrays);
  expectValid(contours);
  ASSERT_EQ(contours.chains.size(), 2u);
  EXPECT_EQ(contours.kinds, (std::vector{ ink::ContourKind::Silhouette, ink::ContourKind::Border }));
  EXPECT_EQ(contours.chains.closed, (std::vector<std::uint8_t>{ 0, 1 }));
  EXPECT_NEAR(contours.positions.front().z, 0.0, 1e-12);
  EXPECT_NEAR(contours.positions[contours.chains.offsets[1] - 1].z, 0.0, 1e-12);
  EXPECT_EQ(contours.chains.segmentCount(1), 40u);
  EXPECT_EQ(contours.radialCurvature.back(), 0.0f);
}

TEST(MeshContours, FindsCreasesByTheirAngle)
{
  std::vector<glm::vec3> normals;
  const Mesh mesh = splitCube(normals);
  ink::MeshContourOptions options;
  options.silhouettes = false;
  options.creases = true;
  for (const auto& [angle, edges] : { std::pair(0.0, 12u), std::pair(89.9, 12u), std::pair(90.1, 0u) })
  {
    options.creaseAngle = angle;
    const ink::Contours contours =
      ink::MeshContours(mesh.view(), {}, options).find(ink::Eye::at({ 4, 5, 6 }));
    EXPECT_EQ(contours.chains.size(), edges) << angle; // three meet at each corner
    EXPECT_EQ(contours.positions.size(), 2 * edges);
  }
}

TEST(MeshContours, SharpCreasesAreWhereNormalsDiffer)
{
  std::vector<glm::vec3> normals;
  const Mesh mesh = splitCube(normals);
  ink::MeshContourOptions options;
  options.silhouettes = false;
  options.creases = true;
  const auto count = [&](std::span<const glm::vec3> given) {
    return ink::MeshContours(mesh.view(), given, options).find(ink::Eye::at({ 4, 5, 6 })).chains.size();
  };
  // As of a rough surface: steep, but with one normal at each position.
  const std::vector<glm::vec3> smooth = radialNormals(mesh);
  EXPECT_EQ(count(smooth), 12u);
  options.sharpCreasesOnly = true;
  EXPECT_EQ(count(normals), 12u);
  EXPECT_EQ(count(smooth), 0u);
}

TEST(MeshContours, LeavesOutCreasesThatAreSpecks)
{
  // A square of 20 x 20 steps with a ridge across and another one of two steps.
  Mesh mesh;
  constexpr int side = 21;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      mesh.points.push_back(
        { double(i), double(j), i == 15 || (i == 5 && std::abs(j - 5) <= 1) ? 2.0 : 0.0 });
    }
  }
  for (std::uint32_t j = 0; j + 1 < side; ++j)
  {
    for (std::uint32_t i = 0; i + 1 < side; ++i)
    {
      const std::uint32_t a = i + side * j;
      mesh.triangles.push_back({ a, a + 1, a + side });
      mesh.triangles.push_back({ a + 1, a + side + 1, a + side });
    }
  }
  ink::MeshContourOptions options;
  options.silhouettes = false;
  options.creases = true;
  options.creaseAngle = 100.0;
  const auto bounds = [&](double shortest)
  {
    options.shortestCrease = shortest;
    const ink::Contours contours =
      ink::MeshContours(mesh.view(), {}, options).find(ink::Eye::at({ 4, 5, 6 }));
    double left = 1e9;
    double right = -1e9;
    for (const glm::dvec3& p : contours.positions)
    {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
    }
    return std::pair(left, right);
  };
  EXPECT_LT(bounds(0.0).first, 5.5) << "the short one";
  EXPECT_LT(bounds(0.05).first, 5.5) << "2 of a diagonal of 28.4";
  EXPECT_GT(bounds(0.3).first, 13.5);
  EXPECT_GT(bounds(1.0).second, 14.5) << "the other one ends at borders";
  for (const double wrong : { -0.1, 1.1, std::nan("") })
  {
    options.shortestCrease = wrong;
    EXPECT_THROW(ink::MeshContours(mesh.view(), {}, options), std::invalid_argument);
  }
}

TEST(MeshContours, LeaveOutBordersOfMissingTriangles)
{
  // A square of 10 x 10 that lacks one triangle within, and its own border of 40.
  Mesh mesh;
  constexpr std::uint32_t side = 11;
  for (std::uint32_t j = 0; j < side; ++j)
  {
    for (std::uint32_t i = 0; i < side; ++i)
    {
      mesh.points.push_back({ double(i), double(j), 0.0 });
      const std::uint32_t a = i + side * j;
      if (i + 1 < side && j + 1 < side)
      {
        mesh.triangles.push_back({ a, a + 1, a + side });
        if (i != 5 || j != 5)
        {
          mesh.triangles.push_back({ a + 1, a + side + 1, a + side });
        }
      }
    }
  }
  ink::MeshContourOptions options;
  options.silhouettes = false;
  options.borders = true;
  const auto lengthWith = [&](double shortest)
  {
    options.shortestBorder = shortest;
    const ink::Contours found = ink::MeshContours(mesh.view(), {}, options).find(ink::Eye::at({ 4, 5, 6 }));
    double length = 0.0;
    for (std::size_t line = 0; line < found.chains.size(); ++line)
    {
      const std::size_t begin = found.chains.offsets[line];
      const std::size_t points = found.chains.offsets[line + 1] - begin;
      for (std::size_t i = 0; i < found.chains.segmentCount(line); ++i)
      {
        length += glm::distance(found.positions[begin + i], found.positions[begin + (i + 1) % points]);
      }
    }
    return length;
  };
  const double hole = 2.0 + std::sqrt(2.0);
  const double diagonal = 10.0 * std::sqrt(2.0);
  EXPECT_NEAR(lengthWith(0.0), 40.0 + hole, 1e-9);
  EXPECT_NEAR(lengthWith(0.99 * hole / diagonal), 40.0 + hole, 1e-9);
  EXPECT_NEAR(lengthWith(1.01 * hole / diagonal), 40.0, 1e-9);
  EXPECT_NEAR(lengthWith(1.0), 40.0, 1e-9);
  for (const double wrong : { -0.1, 1.1, std::nan("") })
  {
    options.shortestBorder = wrong;
    EXPECT_THROW(ink::MeshContours(mesh.view(), {}, options), std::invalid_argument);
  }
}

TEST(MeshContours, GoOnAcrossHolesThatAreLeftOut)
{
  const Mesh whole = torus(1.0, 0.4, 96, 64);
  const std::vector<glm::vec3> normals = tubeNormals(whole, 1.0);
  Mesh mesh = whole;
  mesh.triangles.clear();
  for (std::size_t i = 0; i < whole.triangles.size(); ++i)
  {
    if (i % 61 != 0)
    {
      mesh.triangles.push_back(whole.triangles[i]);
    }
  }
  ink::MeshContourOptions options;
  options.borders = true;
  const ink::MeshContours withHoles(mesh.view(), normals, options);
  options.shortestBorder = 0.1; // of the diagonal of 4
  const ink::MeshContours without(mesh.view(), normals, options);
  const ink::MeshContours reference(whole.view(), normals);
  for (std::uint64_t id = 0; id < 100; ++id)
  {
    const ink::Eye eye = ink::Eye::at(glm::dvec3(0.0, 0.0, 3.0) + randomPoint(id));
    const std::size_t chains = reference.find(eye).chains.size();
    const ink::Contours found = without.find(eye, allArrays);
    expectValid(found);
    EXPECT_EQ(found.chains.size(), chains) << id;
    EXPECT_EQ(closedChains(found), chains) << id;
    EXPECT_EQ(without.find(eye, {}, ink::SilhouetteSearch::Exhaustive).positions, found.positions) << id;
    const ink::Contours interrupted = withHoles.find(eye);
    const auto silhouettes =
      std::count(interrupted.kinds.begin(), interrupted.kinds.end(), ink::ContourKind::Silhouette);
    EXPECT_GT(silhouettes, static_cast<std::ptrdiff_t>(chains)) << id;
  }
}

TEST(MeshContours, AreDrawnOnceWhereACreaseIsASilhouette)
{
  std::vector<glm::vec3> normals;
  const Mesh mesh = splitCube(normals);
  for (const bool faceted : { false, true })
  {
    ink::MeshContourOptions options;
    options.faceted = faceted;
    options.creases = true;
    const auto count = [&](ink::ContourKind kind)
    {
      const ink::Contours contours =
        ink::MeshContours(mesh.view(), normals, options).find(ink::Eye::at({ 4, 5, 6 }));
      return std::count(contours.kinds.begin(), contours.kinds.end(), kind);
    };
    EXPECT_EQ(count(ink::ContourKind::Silhouette), 1) << "around the cube";
    options.once = true;
    EXPECT_EQ(count(ink::ContourKind::Silhouette), 0);
    EXPECT_EQ(count(ink::ContourKind::Crease), 12);
    options.creaseAngle = 100.0;
    EXPECT_EQ(count(ink::ContourKind::Silhouette), 1) << "no creases, no gaps";
  }
}

TEST(MeshContours, TakesEdgesOfManyFaces)
{
  // Three half planes on the y axis.
  Mesh mesh;
  mesh.points = { { 0, 0, 0 }, { 0, 1, 0 }, { -1, 0.5, 0 }, { 1, 0.5, 0 }, { 0, 0.5, 1 } };
  mesh.triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } };
  ink::MeshContourOptions options{ true, true, true, 30.0, true, true };
  const ink::Contours contours =
    ink::MeshContours(mesh.view(), {}, options).find(ink::Eye::at({ 3, 4, 5 }), allArrays);
  expectValid(contours);
  ASSERT_EQ(contours.kinds.back(), ink::ContourKind::NonManifold);
  EXPECT_EQ(std::count(contours.kinds.begin(), contours.kinds.end(), ink::ContourKind::Border), 3);
  EXPECT_EQ(std::count(contours.kinds.begin(), contours.kinds.end(), ink::ContourKind::Crease), 0);
  EXPECT_EQ(contours.arcLength.back(), 1.0);
}
