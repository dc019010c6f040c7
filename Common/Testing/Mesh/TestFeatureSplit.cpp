// SPDX-License-Identifier: BSD-3-Clause
// Meshes cut open at feature edges: boxes, noise, voxels' stairs, seams, normals of each side.

#include "Mesh/FeatureSplit.h"

#include "MachineParts.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

FeatureSplit splitOf(const Mesh& mesh)
{
  MeshNavigation navigation(mesh.view(), 180.0);
  cutFeatures(navigation);
  return splitAtFeatures(navigation);
}

std::vector<glm::vec3> facing(const Mesh& mesh, const glm::vec3& normal)
{
  return std::vector<glm::vec3>(mesh.points.size(), normal);
}

} // namespace

TEST(FeatureSplit, BoxesHaveACornerOfEachFace)
{
  for (const int cells : { 1, 7 })
  {
    for (const bool welded : { true, false })
    {
      const Mesh mesh = box({ 2.0, 1.0, 0.5 }, cells, welded);
      const FeatureSplit split = splitOf(mesh);
      const auto perFace = static_cast<std::size_t>((cells + 1) * (cells + 1));
      EXPECT_EQ(split.sources.size(), 6 * perFace) << cells << welded;
      // What normals the mesh has does not matter: those of its corners are none of any face.
      const std::vector<glm::vec3> normals =
        splitNormals(split, mesh.view(), facing(mesh, { 0.0f, 0.0f, 0.0f }));
      for (std::size_t t = 0; welded && t < mesh.triangles.size(); ++t)
      {
        const auto& [a, b, c] = mesh.triangles[t];
        const glm::dvec3 face =
          glm::normalize(glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
        for (int i = 0; i < 3; ++i)
        {
          const std::uint32_t fan = split.triangles[t][i];
          EXPECT_EQ(mesh.points[split.sources[fan]], mesh.points[mesh.triangles[t][i]]);
          const bool isInner =
            std::count(split.sources.begin(), split.sources.end(), split.sources[fan]) == 1;
          EXPECT_GT(isInner ? 1.0 : glm::dot(glm::dvec3(normals[fan]), face), 1.0 - 1e-6) << t;
        }
      }
    }
  }
}

TEST(FeatureSplit, SmoothMeshesKeepPointsOrderAndNormals)
{
  const Mesh ball = icosphere(3);
  const FeatureSplit split = splitOf(ball);
  EXPECT_EQ(split.triangles, ball.triangles);
  std::vector<glm::vec3> normals;
  for (std::size_t i = 0; i < ball.points.size(); ++i)
  {
    EXPECT_EQ(split.sources[i], i);
    normals.emplace_back(glm::normalize(ball.points[i] + glm::dvec3(0.1, 0.2, 0.0)));
  }
  EXPECT_EQ(splitNormals(split, ball.view(), normals), normals);
  EXPECT_FALSE(mayHaveFeatures(ball.view(), normals));
}

TEST(FeatureSplit, NoiseIsNoFeature)
{
  // Edges are .019 long. Up to a third of that, the ball goes straight on from 2 % of its diagonal away;
  // beyond, there are too many features.
  for (const double noise : { 0.003, 0.006, 0.012, 0.02 })
  {
    const MeshWithCurvature rough = ellipsoid({ 1.0, 1.0, 1.0 }, 6, noise);
    const MeshNavigation steep(rough.mesh.view(), defaultFeatureAngle);
    const std::size_t points = rough.mesh.points.size();
    EXPECT_GT(splitAtFeatures(steep).sources.size(), points + points / 2 * (noise > 0.005 ? 1 : 0)) << noise;
    EXPECT_LT(splitOf(rough.mesh).sources.size(), points + points / 50) << noise;
  }
}

TEST(FeatureSplit, StairsBetweenVoxelsAreNone)
{
  // A plane at a slope of 1/3, cut into voxels of a hundredth of its side.
  Mesh mesh;
  constexpr int steps = 33;
  const double size = 1.0 / (3 * steps);
  std::vector<glm::dvec3> profile;
  for (int step = 0; step < steps; ++step)
  {
    profile.emplace_back(3 * step * size, 0.0, step * size);
    profile.emplace_back((3 * step + 3) * size, 0.0, step * size);
  }
  constexpr int rows = 20;
  for (int row = 0; row <= rows; ++row)
  {
    for (const glm::dvec3& p : profile)
    {
      mesh.points.push_back(p + glm::dvec3(0.0, double(row) / rows, 0.0));
    }
  }
  const auto stride = static_cast<std::uint32_t>(profile.size());
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    for (std::uint32_t i = 0; i + 1 < stride; ++i)
    {
      const std::uint32_t corner = row * stride + i;
      mesh.triangles.push_back({ corner, corner + 1, corner + stride + 1 });
      mesh.triangles.push_back({ corner, corner + stride + 1, corner + stride });
    }
  }
  // All but those at the ends, from where one cannot walk to both sides.
  EXPECT_LT(splitOf(mesh).sources.size(), mesh.points.size() + 4 * (rows + 1));
}

TEST(FeatureSplit, RoughPartsLeaveOthersTheirFeatures)
{
  // A box within a ball that is too rough to have features.
  const Mesh part = box({ 0.2, 0.3, 0.4 }, 4, true);
  Mesh both = ellipsoid({ 1.0, 1.0, 1.0 }, 6, 0.02).mesh;
  const std::size_t points = both.points.size();
  const auto offset = static_cast<std::uint32_t>(points);
  both.points.insert(both.points.end(), part.points.begin(), part.points.end());
  for (const auto& [a, b, c] : part.triangles)
  {
    both.triangles.push_back({ offset + a, offset + b, offset + c });
  }
  const FeatureSplit split = splitOf(both);
  const auto ofBox =
    std::count_if(split.sources.begin(), split.sources.end(), [&](std::uint32_t p) { return p >= offset; });
  EXPECT_EQ(ofBox, 6 * 5 * 5);
  EXPECT_EQ(split.sources.size() - static_cast<std::size_t>(ofBox), points);
}

TEST(FeatureSplit, SeamsAreOnePoint)
{
  Mesh twice = icosphere(2);
  std::vector<glm::dvec3> points;
  for (Triangle& triangle : twice.triangles)
  {
    for (std::uint32_t& corner : triangle)
    {
      points.push_back(twice.points[corner]);
      corner = static_cast<std::uint32_t>(points.size() - 1);
    }
  }
  const std::size_t distinct = twice.points.size();
  twice.points = points;
  const FeatureSplit split = splitOf(twice);
  EXPECT_EQ(split.sources.size(), distinct);
  std::vector<glm::vec3> normals;
  for (std::size_t t = 0; t < twice.triangles.size(); ++t)
  {
    const glm::dvec3* p = &points[3 * t];
    normals.insert(normals.end(), 3, glm::vec3(glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]))));
  }
  const std::vector<glm::vec3> mean = splitNormals(split, twice.view(), normals);
  for (std::size_t i = 0; i < mean.size(); ++i)
  {
    EXPECT_GT(glm::dot(glm::dvec3(mean[i]), points[split.sources[i]]), 0.99);
  }
}

TEST(FeatureSplit, NormalsOfLongThinTrianglesCountByAngle)
{
  // A fan of unequal triangles on the cap, quads of two on the side: all of the cap face up.
  const Mesh mesh = cylinder(37, 1, 3.0, true);
  const FeatureSplit split = splitOf(mesh);
  const std::vector<glm::vec3> normals = splitNormals(split, mesh.view(), facing(mesh, { 0.0f, 0.0f, 1.0f }));
  std::map<std::uint32_t, int> sides;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const glm::dvec3 n(normals[i]);
    const glm::dvec3& p = mesh.points[split.sources[i]];
    const bool isCap = std::abs(n.z) > 0.5;
    const double likeness = isCap ? std::abs(n.z) : std::abs(glm::dot(n, glm::dvec3(p.x, p.y, 0.0)));
    EXPECT_GT(likeness, isCap ? 1.0 - 1e-6 : 1.0 - 1e-3);
    ++sides[split.sources[i]];
  }
  for (const auto& [point, count] : sides)
  {
    EXPECT_EQ(count, 2) << point;
  }
}

TEST(FeatureSplit, MeansBehindOneOfTheirSidesAreNotFollowed)
{
  // Around the rims, as around knife edges, the mean lies behind the cap.
  const double length = 3.0;
  const Mesh mesh = cylinder(37, 20, length, true);
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& p : mesh.points)
  {
    const glm::vec3 radial(static_cast<float>(p.x), static_cast<float>(p.y), 0.0f);
    normals.push_back(p.z == 0.0 ? 0.6f * radial + glm::vec3(0.0f, 0.0f, 0.8f)
        : p.z == length          ? 0.6f * radial - glm::vec3(0.0f, 0.0f, 0.8f)
                                 : radial);
  }
  const FeatureSplit split = splitOf(mesh);
  for (const float sign : { 1.0f, -1.0f })
  {
    const std::vector<glm::vec3> found = splitNormals(split, mesh.view(), normals);
    int caps = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const glm::dvec3& p = mesh.points[split.sources[i]];
      if (std::abs(found[i].z) > 0.5f)
      {
        ++caps;
        EXPECT_GT(sign * found[i].z * (p.z > 0.0 ? 1.0f : -1.0f), 0.99f) << i;
      }
      else
      {
        EXPECT_GT(sign * glm::dot(glm::dvec3(found[i]), glm::dvec3(p.x, p.y, 0.0)), 0.99) << i;
      }
    }
    EXPECT_EQ(caps, 2 * 37);
    // Inwards, as of a bore.
    std::transform(normals.begin(), normals.end(), normals.begin(), [](const glm::vec3& n) { return -n; });
  }
}

TEST(FeatureSplit, DegenerateMeshes)
{
  EXPECT_TRUE(splitOf(Mesh()).sources.empty());
  Mesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { NAN, 0, 0 }, { 9, 9, 9 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 0, 1 }, { 0, 1, 4 }, { 0, 1, 3 } };
  const FeatureSplit split = splitOf(mesh);
  EXPECT_EQ(split.sources, (std::vector<std::uint32_t>{ 0, 1, 3 }));
  EXPECT_EQ(split.triangles[0], (Triangle{ 0, 0, 0 }));
  EXPECT_EQ(split.triangles[3], (Triangle{ 0, 1, 2 }));
  EXPECT_THROW(splitNormals(split, mesh.view(), {}), std::invalid_argument);
}
