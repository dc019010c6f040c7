// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FeatureSplit.h"

#include "Core/DisjointSets.h"
#include "Mesh/OnePerPoint.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace ink
{

namespace
{

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

void cutFeatures(MeshNavigation& navigation, double angle)
{
  navigation.cutFeatures(angle, defaultFeatureReach * glm::distance(navigation.lower(), navigation.upper()));
}

FeatureSplit splitAtFeatures(const MeshNavigation& navigation)
{
  const std::span<const Triangle> triangles = navigation.mesh().triangles;
  DisjointSets fans(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    for (std::uint32_t edge = 0; edge < 3; ++edge)
    {
      const std::optional<MeshNavigation::Neighbor> other = navigation.across(t, edge);
      if (other && t < other->triangle)
      {
        fans.join(3 * t + edge, 3 * other->triangle + other->corner(0));
        fans.join(3 * t + (edge + 1) % 3, 3 * other->triangle + other->corner(1));
      }
    }
  }
  // By the points that fans begin with, so that a mesh without features keeps its order.
  struct Fan
  {
    std::uint32_t source;
    std::uint32_t corner;
  };
  std::vector<Fan> order;
  for (std::uint32_t corner = 0; corner < 3 * triangles.size(); ++corner)
  {
    if (navigation.isUsable(corner / 3) && fans.least(corner) == corner)
    {
      order.push_back({ triangles[corner / 3][corner % 3], corner });
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [](const Fan& a, const Fan& b) { return a.source < b.source; });
  FeatureSplit result;
  std::vector<std::uint32_t> ids(3 * triangles.size());
  for (const Fan& fan : order)
  {
    ids[fan.corner] = static_cast<std::uint32_t>(result.sources.size());
    result.sources.push_back(fan.source);
  }
  result.triangles.assign(triangles.size(), { 0, 0, 0 });
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    for (std::uint32_t i = 0; i < 3 && navigation.isUsable(t); ++i)
    {
      result.triangles[t][i] = ids[fans.least(3 * t + i)];
    }
  }
  return result;
}

std::vector<glm::vec3> splitNormals(const FeatureSplit& split, const TriangleMesh& mesh,
  std::span<const glm::vec3> normals, bool keepAtSeams)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  constexpr std::uint32_t none = MeshNavigation::border;
  std::vector<glm::dvec3> sums(split.sources.size(), glm::dvec3(0.0));
  std::vector<std::uint32_t> fanOf(mesh.points.size(), none);
  std::vector<std::uint8_t> isShared(sums.size(), 0); // whether a point has other fans, or the fan other points
  for (std::size_t t = 0; t < split.triangles.size(); ++t)
  {
    const Triangle& fans = split.triangles[t];
    if (fans[0] == fans[1])
    {
      continue;
    }
    std::array<glm::dvec3, 3> sides;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::uint32_t point = mesh.triangles[t][i];
      sides[i] = glm::normalize(mesh.points[mesh.triangles[t][(i + 1) % 3]] - mesh.points[point]);
      fanOf[point] = fanOf[point] == none ? fans[i] : fanOf[point];
      if (fanOf[point] != fans[i] || (!keepAtSeams && split.sources[fans[i]] != point))
      {
        isShared[fans[i]] = isShared[fanOf[point]] = 1;
      }
    }
    const glm::dvec3 area = glm::cross(sides[0], sides[1]);
    const double size = glm::length(area);
    for (std::size_t i = 0; i < 3 && size > 0.0; ++i)
    {
      sums[fans[i]] += angleBetween(sides[i], -sides[(i + 2) % 3]) / size * area;
    }
  }
  std::vector<glm::vec3> result = split.spread(normals);
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    // Opposite ones cancel out up to rounding.
    constexpr double rounding = 1e-6;
    const double length = glm::length(sums[i]);
    if (isShared[i] != 0 && length > rounding)
    {
      const glm::vec3 mean(sums[i] / length);
      result[i] = glm::dot(mean, result[i]) < 0.0f ? -mean : mean;
    }
  }
  return result;
}

} // namespace ink
