// SPDX-License-Identifier: BSD-3-Clause
// How far samples are from the sharp edges of their side of a surface.

#include "Curves/Contours/EdgeOffsets.h"

#include "MachineParts.h"
#include "PointSampling/WhiteNoise.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// Those of the last triangle around each point.
std::vector<glm::vec3> faceNormals(const Mesh& mesh)
{
  std::vector<glm::vec3> normals(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const glm::dvec3 normal =
      glm::normalize(glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
    normals[a] = normals[b] = normals[c] = normal;
  }
  return normals;
}

std::vector<SurfaceSample> samplesOf(const Mesh& mesh)
{
  return sampleWhiteNoise(mesh.view(), cumulateArea(mesh.view()), 2000, 1);
}

} // namespace

TEST(EdgeOffsets, OfABoxAreThoseToTheEdgesOfAFace)
{
  // A thin plate, whose faces have points of their own.
  const glm::dvec3 size(2.0, 1.0, 0.1);
  constexpr double reach = 0.3;
  for (const int cells : { 1, 9 })
  {
    const Mesh mesh = box(size, cells, false);
    const std::vector<SurfaceSample> samples = samplesOf(mesh);
    const std::vector<EdgeOffsets> offsets = edgeOffsets(mesh.view(), faceNormals(mesh), samples, reach);
    ASSERT_EQ(offsets.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const glm::dvec3 p = positionOf(mesh.view(), samples[i]);
      std::vector<double> distances; // from the edges of the sample's face
      for (int axis = 0; axis < 3; ++axis)
      {
        const double ends[2] = { p[axis], size[axis] - p[axis] };
        const bool isOfFace = std::min(ends[0], ends[1]) > 1e-6;
        distances.insert(distances.end(), ends, isOfFace ? ends + 2 : ends);
      }
      std::sort(distances.begin(), distances.end());
      const double nearest = distances[0];
      const double found = glm::length(offsets[i][0]);
      EXPECT_NEAR(found, nearest < reach ? nearest : 0.0, 1e-5) << p.x << ' ' << p.y << ' ' << p.z;
      // On the narrow sides the other edge is within reach.
      const bool isNarrow = p.z > 1e-6 && p.z < size.z - 1e-6;
      if (isNarrow && distances[1] < reach)
      {
        EXPECT_NEAR(glm::length(offsets[i][1]), distances[1], 1e-5);
      }
      EXPECT_LT(glm::dot(offsets[i][0], offsets[i][1]), 0.51f * found * glm::length(offsets[i][1]) + 1e-6f);
    }
  }
}

TEST(EdgeOffsets, SmoothSurfacesAndBordersHaveNone)
{
  const Mesh ball = icosphere(3);
  std::vector<glm::vec3> normals(ball.points.begin(), ball.points.end());
  EXPECT_TRUE(edgeOffsets(ball.view(), normals, samplesOf(ball), 0.3).empty());

  Mesh sheet;
  sheet.addPatch(3, 3, [](double u, double v) { return glm::dvec3(u, v, 0.0); });
  EXPECT_TRUE(edgeOffsets(sheet.view(), faceNormals(sheet), samplesOf(sheet), 0.3).empty());
}
