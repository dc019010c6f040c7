// SPDX-License-Identifier: BSD-3-Clause
// What the tests of contours of meshes share.
#pragma once

#include "Core/Hash.h"
#include "Curves/Contours/MeshContours.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ink::test
{

inline constexpr ink::ContourArrays allArrays{ true, true, true, true };

/// Of a unit sphere about the origin.
inline std::vector<glm::vec3> radialNormals(const Mesh& mesh)
{
  return { mesh.points.begin(), mesh.points.end() };
}

/// The largest distance from the circle along which a view cone from `eye` touches the unit sphere.
inline double distanceFromCircle(const ink::Contours& contours, const ink::Eye& eye)
{
  // Hertzmann and Zorin 2000: n.(e - p) = 0 with n = p gives p.e = 1.
  const glm::dvec3 axis = glm::normalize(eye.parallel ? -eye.direction : eye.position);
  const double height = eye.parallel ? 0.0 : 1.0 / glm::length(eye.position);
  const double radius = std::sqrt(1.0 - height * height);
  double largest = 0.0;
  for (const glm::dvec3& p : contours.positions)
  {
    const double along = glm::dot(p, axis);
    largest = std::max(largest, std::hypot(along - height, glm::length(p - along * axis) - radius));
  }
  return largest;
}

/// Unit normals of a torus about the z axis.
inline std::vector<glm::vec3> tubeNormals(const Mesh& mesh, double radius)
{
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& p : mesh.points)
  {
    const glm::dvec3 middle = radius * glm::normalize(glm::dvec3(p.x, p.y, 0.0));
    normals.emplace_back(glm::normalize(p - middle));
  }
  return normals;
}

/// A cube about the origin with four points for each of its sides, and normals to match.
inline Mesh splitCube(std::vector<glm::vec3>& normals)
{
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      mesh.addPatch(1, 1,
        [=](double u, double v)
        {
          glm::dvec3 p(0.0);
          p[axis] = side;
          p[(axis + 1) % 3] = side * (2.0 * u - 1.0); // so that it faces outwards
          p[(axis + 2) % 3] = 2.0 * v - 1.0;
          return p;
        });
      glm::vec3 normal(0.0f);
      normal[axis] = static_cast<float>(side);
      normals.insert(normals.end(), 4, normal);
    }
  }
  return mesh;
}

/// In the cube from -1 to 1.
inline glm::dvec3 randomPoint(std::uint64_t id)
{
  const auto random = [](std::uint64_t key) { return 2.0 * ink::unitDouble(ink::hash(17, key)) - 1.0; };
  return { random(3 * id), random(3 * id + 1), random(3 * id + 2) };
}

/// Near and far, inside and outside of a body of size 1, and at infinity.
inline ink::Eye randomEye(std::uint64_t id)
{
  const glm::dvec3 point = randomPoint(id);
  return id % 4 == 3 ? ink::Eye::along(point) : ink::Eye::at(std::pow(10.0, double(id % 4)) * point);
}

inline bool areEqual(const ink::Contours& a, const ink::Contours& b)
{
  return a.chains.offsets == b.chains.offsets && a.chains.closed == b.chains.closed && a.kinds == b.kinds &&
    a.positions == b.positions && a.normals == b.normals && a.radialCurvature == b.radialCurvature &&
    a.arcLength == b.arcLength && a.elements == b.elements;
}

inline std::size_t closedChains(const ink::Contours& contours)
{
  return static_cast<std::size_t>(
    std::count(contours.chains.closed.begin(), contours.chains.closed.end(), 1));
}

/// No point is repeated right after itself, and lengths, closed and open, are what the points say.
inline void expectValid(const ink::Contours& contours)
{
  ASSERT_EQ(contours.kinds.size(), contours.chains.size());
  ASSERT_EQ(contours.positions.size(), contours.chains.pointCount());
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    const std::size_t begin = contours.chains.offsets[chain];
    const std::size_t end = contours.chains.offsets[chain + 1];
    ASSERT_GE(end, begin + 2);
    for (std::size_t i = begin; i < end; ++i)
    {
      if (i + 1 < end || contours.chains.closed[chain])
      {
        EXPECT_NE(contours.positions[i], contours.positions[i + 1 < end ? i + 1 : begin]) << i;
      }
    }
  }
}

} // namespace ink::test
