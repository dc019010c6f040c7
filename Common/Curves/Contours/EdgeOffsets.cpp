// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/EdgeOffsets.h"

#include "Core/KdTree.h"
#include "Core/ParallelChunks.h"
#include "Curves/Contours/ContourSurface.h"
#include "Curves/Contours/FeatureEdges.h"
#include "Mesh/FeatureSplit.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ink
{

namespace
{

/// Positions on edges that are found by a tree, a share of the reach apart, and how many of them are looked
/// at for a sample: those of both sides of an edge, and of several edges.
constexpr double spacingShare = 0.25;
constexpr std::size_t candidates = 24;

/// What is less than this share of the way to the nearest position, in its direction, is in another one. That
/// which is next to it along the same edge is as far.
constexpr double otherDirection = 0.5;

/// How far out of an edge's side a sample may lie that is on it, as a share of its distance.
constexpr double offSide = 0.5;

/// One of the two triangles at a sharp edge.
struct EdgeSide
{
  std::uint32_t triangle;
  glm::dvec3 begin; ///< of the edge
  glm::dvec3 along; ///< to its end

  glm::dvec3 nearest(const glm::dvec3& position) const
  {
    const double share = glm::dot(position - this->begin, this->along) / glm::dot(this->along, this->along);
    return this->begin + std::clamp(share, 0.0, 1.0) * this->along;
  }
};

glm::dvec3 triangleNormal(const TriangleMesh& mesh, std::uint32_t triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  const glm::dvec3 doubleArea = glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  const double length = glm::length(doubleArea);
  return length > 0.0 ? doubleArea / length : glm::dvec3(0.0);
}

std::vector<EdgeSide> sidesOfSharpEdges(const TriangleMesh& mesh, std::span<const glm::vec3> normals)
{
  const ContourSurface surface(mesh, normals);
  const FeatureEdges edges(surface, defaultFeatureAngle, defaultShortestCrease, 0.0, true);
  std::vector<EdgeSide> sides;
  for (const ContourSegment& crease : edges.creases)
  {
    const glm::dvec3 begin = surface.corners[crease.from.corner0].position;
    const glm::dvec3 along = surface.corners[crease.to.corner0].position - begin;
    for (const std::uint32_t face : { crease.face, crease.otherFace })
    {
      sides.push_back({ surface.faceIds[face], begin, along });
    }
  }
  return sides;
}

/// Whether a position in a triangle is on an edge's side of the surface, and not beyond the edge.
bool isOn(const TriangleMesh& mesh, const EdgeSide& side, std::uint32_t triangle, const glm::dvec3& fromEdge)
{
  if (side.triangle == triangle)
  {
    return true;
  }
  const auto& [a, b, c] = mesh.triangles[side.triangle];
  const glm::dvec3 inwards = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0 - side.begin;
  const glm::dvec3 across =
    inwards - glm::dot(inwards, side.along) / glm::dot(side.along, side.along) * side.along;
  const glm::dvec3 normal = triangleNormal(mesh, side.triangle);
  const double leastCosine = std::cos(glm::radians(defaultFeatureAngle));
  // Triangles of a file need not run the same way round.
  return std::abs(glm::dot(normal, triangleNormal(mesh, triangle))) > leastCosine &&
    std::abs(glm::dot(normal, fromEdge)) <= offSide * glm::length(fromEdge) &&
    glm::dot(across, fromEdge) >= 0.0;
}

} // namespace

std::vector<EdgeOffsets> edgeOffsets(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const SurfaceSample> samples, double reach)
{
  const std::vector<EdgeSide> sides = sidesOfSharpEdges(mesh, normals);
  if (sides.empty())
  {
    return {};
  }
  // Relative to one of them, in reaches, for single precision.
  const glm::dvec3 origin = sides.front().begin;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> sideOf;
  for (std::uint32_t i = 0; i < sides.size(); ++i)
  {
    const EdgeSide& side = sides[i];
    const double steps = std::max(std::ceil(glm::length(side.along) / (spacingShare * reach)), 1.0);
    for (double step = 0.5; step < steps; step += 1.0)
    {
      positions.emplace_back((side.begin + step / steps * side.along - origin) / reach);
      sideOf.push_back(i);
    }
  }
  const KdTree tree(positions);
  std::vector<EdgeOffsets> result(samples.size());
  parallelForEach(samples.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 position = positionOf(mesh, samples[i]);
      const glm::vec3 from((position - origin) / reach);
      std::array<std::uint32_t, candidates> found;
      // Most samples are near no edge, which the nearest tells.
      tree.find(from, std::span(found).first(1));
      if (glm::distance(from, positions[found[0]]) > 1.0 + spacingShare)
      {
        return;
      }
      const std::span<std::uint32_t> near(found.data(), std::min(candidates, positions.size()));
      tree.find(from, near);
      std::vector<glm::dvec3> offsets;
      for (const std::uint32_t candidate : near)
      {
        const EdgeSide& side = sides[sideOf[candidate]];
        const glm::dvec3 offset = side.nearest(position) - position;
        if (glm::length(offset) <= reach && isOn(mesh, side, samples[i].triangle, -offset))
        {
          offsets.push_back(offset);
        }
      }
      const auto shorter = [](const glm::dvec3& a, const glm::dvec3& b)
      { return glm::dot(a, a) < glm::dot(b, b); };
      std::stable_sort(offsets.begin(), offsets.end(), shorter);
      if (offsets.empty())
      {
        return;
      }
      const glm::dvec3 first = offsets.front();
      result[i][0] = first;
      const auto other = std::find_if(offsets.begin(), offsets.end(),
        [&](const glm::dvec3& offset)
        { return glm::dot(first, offset) < otherDirection * glm::dot(first, first); });
      result[i][1] = other == offsets.end() ? glm::vec3(0.0f) : glm::vec3(*other);
    });
  return result;
}

} // namespace ink
