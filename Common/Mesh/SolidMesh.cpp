// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SolidMesh.h"

#include "Core/DisjointSets.h"
#include "Core/IsFinite.h"
#include "Mesh/BorderEdges.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/ConnectedParts.h"
#include "Mesh/OnePerPoint.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace ink
{

namespace
{

constexpr double longestHole = 0.2; // of the diagonal

/// The length of the longest border, with all borders that it joins.
double longestBorder(const TriangleMesh& mesh, const std::vector<MeshEdge>& borders)
{
  DisjointSets sets(mesh.points.size());
  for (const MeshEdge& edge : borders)
  {
    sets.join(edge[0], edge[1]);
  }
  std::vector<double> lengths(mesh.points.size());
  double longest = 0.0;
  for (const MeshEdge& edge : borders)
  {
    double& length = lengths[sets.least(edge[0])];
    length += glm::distance(mesh.points[edge[0]], mesh.points[edge[1]]);
    longest = std::max(longest, length);
  }
  return longest;
}

/// Triangles of the first of all points that coincide, so that seams are closed.
/// @param isUsed of each point; those are finite
std::vector<Triangle> weld(std::span<const glm::dvec3> points, std::span<const std::uint8_t> isUsed,
  double distance, std::vector<Triangle> triangles)
{
  std::vector<std::uint32_t> used;
  std::vector<std::uint32_t> number(points.size());
  for (std::uint32_t point = 0; point < points.size(); ++point)
  {
    number[point] = static_cast<std::uint32_t>(used.size());
    if (isUsed[point] != 0)
    {
      used.push_back(point);
    }
  }
  const std::vector<std::uint32_t> firsts = coincidentPoints(points, used, distance);
  for (Triangle& triangle : triangles)
  {
    for (std::uint32_t& point : triangle)
    {
      point = firsts[number[point]];
    }
  }
  return triangles;
}

} // namespace

bool isSolid(const TriangleMesh& mesh, std::span<const glm::vec3> normals)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  std::vector<Triangle> triangles;
  std::copy_if(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(triangles),
    [&mesh](const Triangle& triangle)
    {
      return std::all_of(triangle.begin(), triangle.end(),
        [&mesh](std::uint32_t point) { return isFinite(mesh.points[point]); });
    });
  if (triangles.empty())
  {
    return false;
  }
  std::vector<std::uint8_t> isUsed(mesh.points.size());
  glm::dvec3 low(mesh.points[triangles[0][0]]);
  glm::dvec3 high(low);
  for (const Triangle& triangle : triangles)
  {
    for (const std::uint32_t point : triangle)
    {
      isUsed[point] = 1;
      low = glm::min(low, mesh.points[point]);
      high = glm::max(high, mesh.points[point]);
    }
  }
  const std::vector<Triangle> corners = weld(mesh.points, isUsed, coincidenceDistance(low, high), triangles);
  const TriangleMesh welded{ mesh.points, corners, {}, {} };
  const auto all = [](const Triangle&) { return true; };
  if (!(longestBorder(welded, borderEdges(welded, all)) <= longestHole * glm::distance(low, high)))
  {
    return false;
  }
  const std::vector<std::uint32_t> parts = connectedParts(welded);
  struct Part
  {
    bool isUsed = false;
    glm::dvec3 origin; ///< volumes are relative to it, so that they do not cancel out
    double volume = 0.0;
  };
  std::vector<Part> found(mesh.points.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    Part& part = found[parts[welded.triangles[t][0]]];
    const auto& [p, q, r] = triangles[t];
    part.origin = part.isUsed ? part.origin : mesh.points[p];
    part.isUsed = true;
    const glm::dvec3 a = mesh.points[p] - part.origin;
    const glm::dvec3 b = mesh.points[q] - part.origin;
    const glm::dvec3 c = mesh.points[r] - part.origin;
    const double side = glm::dot(glm::cross(b - a, c - a), glm::dvec3(normals[p] + normals[q] + normals[r]));
    part.volume += (side < 0.0 ? -1.0 : 1.0) * glm::dot(a, glm::cross(b, c));
  }
  return std::all_of(
    found.begin(), found.end(), [](const Part& part) { return !part.isUsed || part.volume > 0.0; });
}

} // namespace ink
