// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FeatureSplit.h"

#include "Core/DisjointSets.h"
#include "Mesh/OnePerPoint.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace ink
{

namespace
{

double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// On which side of its triangles the normals of each connected part of a mesh are.
class PartVotes
{
public:
  PartVotes(const FeatureSplit& split, const TriangleMesh& mesh, std::span<const glm::vec3> normals)
    : Parts(mesh.points.size())
    , Votes(mesh.points.size(), glm::dvec2(0.0))
  {
    for (std::size_t t = 0; t < split.triangles.size(); ++t)
    {
      const Triangle& fans = split.triangles[t];
      const auto& [a, b, c] = mesh.triangles[t];
      if (fans[0] == fans[1])
      {
        continue;
      }
      const glm::dvec3 area = glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
      const double size = glm::length(area);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t point = mesh.triangles[t][i];
        this->Parts.join(point, a);
        this->Parts.join(point, split.sources[fans[i]]);
        const double cosine = glm::dot(area / size, glm::dvec3(normals[point]));
        if (std::isfinite(cosine))
        {
          this->Votes[point] += glm::dvec2(cosine, std::abs(cosine));
        }
      }
    }
    for (std::uint32_t point = 0; point < this->Votes.size(); ++point)
    {
      if (const std::uint32_t part = this->Parts.least(point); part != point)
      {
        this->Votes[part] += this->Votes[point];
      }
    }
  }

  /// 1 if nearly all normals of a point's part are on the side to which its triangles run
  /// counterclockwise, -1 if on the other one, else 0.
  int sideOf(std::uint32_t point)
  {
    constexpr double nearlyAll = 0.8;
    const glm::dvec2& vote = this->Votes[this->Parts.least(point)];
    return std::abs(vote.x) <= nearlyAll * vote.y ? 0 : vote.x < 0.0 ? -1 : 1;
  }

private:
  DisjointSets Parts;
  std::vector<glm::dvec2> Votes; ///< sums of cosines, and of their magnitudes, of points, then of parts
};

} // namespace

void cutFeatures(MeshNavigation& navigation, double angle, double reach)
{
  MeshNavigation cut = navigation;
  cut.cutFeatures(angle, reach);
  const TriangleMesh& mesh = navigation.mesh();
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  DisjointSets parts(count);
  std::vector<double> lengths(count); // of features, of each triangle
  for (std::uint32_t t = 0; t < count; ++t)
  {
    for (std::uint32_t edge = 0; edge < 3; ++edge)
    {
      const auto other = navigation.across(t, edge);
      if (other && t < other->triangle)
      {
        parts.join(t, other->triangle);
        lengths[t] += cut.across(t, edge) ? 0.0
                                          : glm::distance(mesh.points[mesh.triangles[t][edge]],
                                              mesh.points[mesh.triangles[t][(edge + 1) % 3]]);
      }
    }
  }
  std::vector<double> excess(count); // of each part, by its least triangle
  for (std::uint32_t t = 0; t < count; ++t)
  {
    if (navigation.isUsable(t))
    {
      const auto& [a, b, c] = mesh.triangles[t];
      const double area =
        0.5 * glm::length(glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
      excess[parts.least(t)] += lengths[t] * reach - mostFeatures * area;
    }
  }
  for (std::uint32_t t = 0; t < count; ++t)
  {
    if (excess[parts.least(t)] > 0.0)
    {
      cut.restore(t, navigation);
    }
  }
  navigation = std::move(cut);
}

void cutFeatures(MeshNavigation& navigation)
{
  const double diagonal = glm::distance(navigation.lower(), navigation.upper());
  cutFeatures(navigation, defaultFeatureAngle, defaultFeatureReach * diagonal);
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

std::vector<glm::vec3> splitNormals(
  const FeatureSplit& split, const TriangleMesh& mesh, std::span<const glm::vec3> normals)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  constexpr std::uint32_t none = MeshNavigation::border;
  std::vector<glm::dvec3> sums(split.sources.size(), glm::dvec3(0.0));
  std::vector<std::uint32_t> fanOf(mesh.points.size(), none);
  std::vector<glm::dvec3> ofPoints(sums.size(), glm::dvec3(0.0)); // sums along seams
  std::vector<std::uint8_t> isOneOfSeveral(sums.size(), 0);
  std::vector<std::uint8_t> isOfSeam(sums.size(), 0);
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
      ofPoints[fans[i]] += glm::dvec3(normals[point]);
      isOfSeam[fans[i]] |= split.sources[fans[i]] != point ? 1 : 0;
      if (fanOf[point] != fans[i])
      {
        isOneOfSeveral[fans[i]] = isOneOfSeveral[fanOf[point]] = 1;
      }
    }
    const glm::dvec3 area = glm::cross(sides[0], sides[1]);
    const double size = glm::length(area);
    for (std::size_t i = 0; i < 3 && size > 0.0; ++i)
    {
      sums[fans[i]] += angleBetween(sides[i], -sides[(i + 2) % 3]) / size * area;
    }
  }
  // What is bent by more than a right angle may have a mean that lies behind one of its sides, whose own it
  // cannot tell then; but triangles that all run the same way round can.
  std::vector<std::uint8_t> sidesOf(mesh.points.size(), 0); // 1: with the triangles of a fan, 2: against
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const std::uint32_t point = split.sources[i];
    const double with = isOneOfSeveral[i] != 0 ? glm::dot(sums[i], glm::dvec3(normals[point])) : 0.0;
    sidesOf[point] |= with > 0.0 ? 1 : with < 0.0 ? 2 : 0;
  }
  constexpr std::uint8_t both = 3;
  std::optional<PartVotes> votes;
  if (std::find(sidesOf.begin(), sidesOf.end(), both) != sidesOf.end())
  {
    votes.emplace(split, mesh, normals);
  }
  std::vector<glm::vec3> result = split.spread(normals);
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    // Opposite ones cancel out up to rounding.
    constexpr double rounding = 1e-6;
    const glm::dvec3& sum = isOneOfSeveral[i] != 0 ? sums[i] : ofPoints[i];
    const double length = glm::length(sum);
    if ((isOneOfSeveral[i] != 0 || isOfSeam[i] != 0) && length > rounding)
    {
      const glm::vec3 mean(sum / length);
      const int voted = sidesOf[split.sources[i]] == both ? votes->sideOf(split.sources[i]) : 0;
      const bool isBehind = voted != 0 ? voted < 0 : glm::dot(mean, result[i]) < 0.0f;
      result[i] = isBehind ? -mean : mean;
    }
  }
  return result;
}

bool mayHaveFeatures(const TriangleMesh& mesh, std::span<const glm::vec3> normals, double angle)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  // Of two triangles at a point one is as far from its normal as half the angle between them.
  const double leastCosine = std::cos(glm::radians(0.5 * angle));
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
    [&](const Triangle& triangle)
    {
      const auto& [a, b, c] = triangle;
      const glm::dvec3 area = glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
      const double least = leastCosine * glm::length(area);
      return std::any_of(triangle.begin(), triangle.end(),
        [&](std::uint32_t point) { return std::abs(glm::dot(area, glm::dvec3(normals[point]))) < least; });
    });
}

} // namespace ink
