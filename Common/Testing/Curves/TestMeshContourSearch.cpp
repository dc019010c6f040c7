// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes are the same however they are searched for, and on any number of threads.
#include "MeshContourTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

using namespace ink::test;

TEST(MeshContours, FindsByTheHierarchyWhatAnExhaustiveSearchFinds)
{
  const Mesh mesh = torus(0.7, 0.3, 30, 20);
  const std::vector<glm::vec3> smooth = tubeNormals(mesh, 0.7);
  std::vector<glm::vec3> noisy = smooth;
  for (std::size_t i = 0; i < noisy.size(); ++i)
  {
    noisy[i] += glm::vec3(0.5 * randomPoint(i));
  }
  // Faces with points of their own, some with other normals than their neighbors: sharp edges.
  Mesh soup;
  std::vector<glm::vec3> ofSoup;
  for (const ink::Triangle& triangle : mesh.triangles)
  {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t point : triangle)
    {
      soup.points.push_back(mesh.points[point]);
      ofSoup.push_back(first % 7 == 0 ? noisy[point] : smooth[point]);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  // One triangle in fifty is missing; silhouettes go on across the holes.
  Mesh torn = mesh;
  std::erase_if(torn.triangles,
    [&](const ink::Triangle& triangle) { return triangle[0] % 25 == 3 && triangle[1] > triangle[2]; });
  EXPECT_LT(torn.triangles.size(), mesh.triangles.size() - 15);
  struct Case
  {
    const Mesh& mesh;
    const std::vector<glm::vec3>& normals;
    bool faceted;
    double shortestBorder = 0.0;
  };
  std::size_t found = 0;
  for (const Case& tried : { Case{ mesh, smooth, false }, Case{ mesh, noisy, false },
         Case{ soup, ofSoup, false }, Case{ mesh, smooth, true }, Case{ torn, smooth, false, 0.3 } })
  {
    ink::MeshContourOptions options;
    options.faceted = tried.faceted;
    options.shortestBorder = tried.shortestBorder;
    const ink::MeshContours finder(tried.mesh.view(), tried.normals, options);
    for (std::uint64_t id = 0; id < 1000; ++id)
    {
      const ink::Eye eye = randomEye(id);
      const ink::Contours contours = finder.find(eye, allArrays);
      ASSERT_TRUE(areEqual(contours, finder.find(eye, allArrays, ink::SilhouetteSearch::Exhaustive))) << id;
      expectValid(contours);
      found += contours.chains.size();
    }
  }
  EXPECT_GT(found, 7000u);
}

TEST(MeshContours, FindsByTheHierarchyFromPointsOfTheSurface)
{
  // There v of some points is 0 or nearly so.
  const Mesh mesh = sphere(32, 16);
  const ink::MeshContours finder(mesh.view(), radialNormals(mesh));
  for (std::size_t i = 0; i < mesh.points.size(); i += 2)
  {
    for (const double away : { 1.0, 1.0 + 1e-9, 1.001, 0.999 })
    {
      const ink::Eye eye = ink::Eye::at(away * mesh.points[i]);
      const ink::Contours contours = finder.find(eye, allArrays);
      expectValid(contours);
      ASSERT_TRUE(areEqual(contours, finder.find(eye, allArrays, ink::SilhouetteSearch::Exhaustive))) << i;
    }
  }
}

TEST(MeshContours, AreTheSameForAnyNumberOfThreads)
{
  const Mesh mesh = torus(1.0, 0.4, 300, 200);
  const std::vector<glm::vec3> normals = tubeNormals(mesh, 1.0);
  ink::MeshContourOptions options;
  for (const bool faceted : { false, true })
  {
    options = { true, faceted, true, 1.0, true, true };
    const auto run = [&]
    {
      const ink::MeshContours finder(mesh.view(), normals, options);
      return std::pair(finder.find(ink::Eye::at({ 3, 1, 2 }), allArrays),
        finder.find(ink::Eye::at({ 3, 1, 2 }), allArrays, ink::SilhouetteSearch::Exhaustive));
    };
    const auto one = onThreads(1, run);
    const auto two = onThreads(2, run);
    EXPECT_TRUE(areEqual(one.first, two.first));
    EXPECT_TRUE(areEqual(one.second, two.second));
    EXPECT_GT(one.first.chains.size(), 2u);
  }
}

TEST(MeshContours, DoNotDependOnHowFacesRun)
{
  Mesh mesh = torus(1.0, 0.4, 40, 20);
  ink::MeshContourOptions options{ true, true, true, 25.0, true, true };
  const ink::MeshContours straight(mesh.view(), {}, options);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
  {
    std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
  }
  const ink::MeshContours mixed(mesh.view(), {}, options);
  for (std::uint64_t id = 0; id < 50; ++id)
  {
    const ink::Contours a = straight.find(randomEye(id));
    const ink::Contours b = mixed.find(randomEye(id));
    EXPECT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(closedChains(a), closedChains(b));
  }
}

/// Points that are not finite or belong to no face, faces without area, and normals that are not there.
TEST(MeshContours, AreNotDisturbedByWhatIsDegenerate)
{
  Mesh mesh = sphere(40, 20);
  std::vector<glm::vec3> normals = radialNormals(mesh);
  const ink::Eye eye = ink::Eye::at({ 2, 3, 4 });
  const ink::Contours clean = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(),
    { { nan, 0, 0 }, { 0, std::numeric_limits<double>::infinity(), 0 }, { 0.1, 0.2, 0.3 } });
  normals.insert(normals.end(), 3, glm::vec3(0, 0, 1));
  mesh.triangles.insert(mesh.triangles.begin(), { 3, first, 5 });
  mesh.triangles.push_back({ first + 1, 60, 70 });
  mesh.triangles.push_back({ 100, 100, 101 });
  ink::Contours contours = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  for (std::int64_t& element : contours.elements)
  {
    --element; // one face has been put in front
  }
  EXPECT_TRUE(areEqual(clean, contours));

  for (std::size_t i = 0; i < normals.size(); i += 11)
  {
    normals[i] = i % 2 == 0 ? glm::vec3(0.0f) : glm::vec3(static_cast<float>(nan), 0, 0);
  }
  contours = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  EXPECT_EQ(contours.chains.size(), 1u);
  EXPECT_TRUE(contours.chains.closed[0]);
  EXPECT_LT(distanceFromCircle(contours, eye), 0.02);
}
