// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointGroups.h"

#include "SampledMeshes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

} // namespace

TEST(PointGroups, AreAroundTheirMiddles)
{
  const Mesh mesh = square(40);
  std::vector<glm::vec3> normals(mesh.points.size(), glm::vec3(0.0f, 0.0f, 1.0f));
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    normals[i].z = mesh.points[i].x < 0.5 ? 1.0f : -1.0f; // a fold
  }
  const PointTriangles around(mesh.view());
  constexpr double radius = 0.1;
  const PointGroups groups = groupPoints(mesh.view(), around, normals, radius);
  // Each holds more than it would if they were in the way of each other, and fewer than a disk of its radius.
  EXPECT_GT(groups.size(), mesh.points.size() / 55);
  EXPECT_LT(groups.size(), mesh.points.size() / 12);
  std::vector<int> times(mesh.points.size());
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    for (const std::uint32_t point : groups.of(group))
    {
      ++times[point];
      EXPECT_EQ(groups.ofPoints[point], group);
      EXPECT_LE(glm::distance(mesh.points[point], mesh.points[groups.of(group)[0]]), radius);
      EXPECT_EQ(normals[point].z, normals[groups.of(group)[0]].z);
    }
  }
  EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
  // Shorter than edges.
  EXPECT_EQ(groupPoints(mesh.view(), around, normals, 0.02).size(), mesh.points.size());
}

TEST(PointGroups, TrianglesAroundPoints)
{
  Mesh mesh = square(3);
  mesh.points.emplace_back(7.0); // of no triangle
  const PointTriangles around(mesh.view());
  std::size_t sum = 0;
  for (std::uint32_t point = 0; point < mesh.points.size(); ++point)
  {
    EXPECT_TRUE(std::is_sorted(around.of(point).begin(), around.of(point).end()));
    sum += around.of(point).size();
    for (const std::uint32_t t : around.of(point))
    {
      EXPECT_NE(
        std::find(mesh.triangles[t].begin(), mesh.triangles[t].end(), point), mesh.triangles[t].end());
    }
  }
  EXPECT_EQ(sum, 3 * mesh.triangles.size());
  EXPECT_TRUE(around.of(mesh.points.size() - 1).empty());
}
