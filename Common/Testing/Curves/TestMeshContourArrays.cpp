// SPDX-License-Identifier: BSD-3-Clause
// What contours of meshes have at their points: faces and radial curvature.
#include "MeshContourTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace ink::test;

TEST(MeshContours, NameTheFaceOfEachSegment)
{
  const Mesh mesh = torus(1.0, 0.4, 40, 20);
  const ink::MeshContours finder(mesh.view(), tubeNormals(mesh, 1.0));
  const ink::Contours contours = finder.find(ink::Eye::at({ 3, 1, 2 }), allArrays);
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    const std::size_t begin = contours.chains.offsets[chain];
    const std::size_t end = contours.chains.offsets[chain + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      const glm::dvec3 middle =
        0.5 * (contours.positions[i] + contours.positions[i + 1 < end ? i + 1 : begin]);
      const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(contours.elements[i])];
      const glm::dvec3 corners[3] = { mesh.points[a], mesh.points[b], mesh.points[c] };
      const glm::dvec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      double shares = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        shares += glm::length(glm::cross(corners[k] - middle, corners[(k + 1) % 3] - middle));
      }
      EXPECT_NEAR(shares, glm::length(area), 1e-9) << i; // inside
    }
  }
}

/// Against Euler's theorem for the torus, whose principal curvatures are 1 / r and cos v / (R + r cos v).
TEST(MeshContours, KnowTheirRadialCurvature)
{
  const double radius = 1.0;
  const double tube = 0.4;
  const Mesh mesh = torus(radius, tube, 400, 200);
  const ink::MeshContours finder(mesh.view(), tubeNormals(mesh, radius));
  const glm::dvec3 eye(2.0, 0.7, 1.2);
  const ink::Contours contours = finder.find(ink::Eye::at(eye), allArrays);
  int negative = 0;
  for (std::size_t i = 0; i < contours.positions.size(); ++i)
  {
    const glm::dvec3 p = contours.positions[i];
    const glm::dvec3 out = glm::normalize(glm::dvec3(p.x, p.y, 0.0));
    const glm::dvec3 n = glm::normalize(p - radius * out);
    const glm::dvec3 v = eye - p;
    const glm::dvec3 w = glm::normalize(v - n * glm::dot(n, v));
    const double along = glm::dot(w, glm::dvec3(-out.y, out.x, 0.0));
    const double cosine = glm::dot(n, out);
    const double k = along * along * cosine / (radius + tube * cosine) + (1.0 - along * along) / tube;
    EXPECT_NEAR(contours.radialCurvature[i], k, 0.05 / tube) << i;
    negative += k < 0.0;
  }
  EXPECT_GT(negative, 10); // in the hole
}

TEST(MeshContours, OfNormalsThatPointInwardsHaveTheSameRadialCurvature)
{
  const Mesh mesh = torus(1.0, 0.4, 60, 30);
  std::vector<glm::vec3> normals = tubeNormals(mesh, 1.0);
  const ink::Eye eye = ink::Eye::at({ 2.0, 0.7, 1.2 });
  const ink::Contours outwards = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  for (glm::vec3& normal : normals)
  {
    normal = -normal;
  }
  const ink::Contours inwards = ink::MeshContours(mesh.view(), normals).find(eye, allArrays);
  const auto sorted = [](std::vector<float> values)
  {
    std::sort(values.begin(), values.end());
    return values;
  };
  const std::vector<float> expected = sorted(outwards.radialCurvature);
  const std::vector<float> found = sorted(inwards.radialCurvature);
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_LT(expected.front(), 0.0f);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-4) << i;
  }
}
