// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SolidMesh.h"

#include "Mesh/ConnectedParts.h"
#include "Mesh/LongestBorder.h"
#include "Mesh/OnePerPoint.h"
#include "Mesh/SignedVolume.h"
#include "Mesh/WeldedTriangles.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{
namespace
{

constexpr double longestHole = 0.2; // of the diagonal

} // namespace

bool isSolid(const TriangleMesh& mesh, std::span<const glm::vec3> normals)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  const WeldedTriangles welded(mesh);
  if (welded.triangles.empty() || !(longestBorder(welded.mesh()) <= longestHole * welded.diagonal()))
  {
    return false;
  }
  const std::vector<std::uint32_t> parts = connectedParts(welded.mesh());
  struct Part
  {
    bool isUsed = false;
    glm::dvec3 origin; ///< volumes are relative to it, so that they do not cancel out
    double volume = 0.0;
  };
  std::vector<Part> found(mesh.points.size());
  for (std::size_t t = 0; t < welded.triangles.size(); ++t)
  {
    Part& part = found[parts[welded.triangles[t][0]]];
    const auto& [p, q, r] = mesh.triangles[welded.source[t]];
    part.origin = part.isUsed ? part.origin : mesh.points[p];
    part.isUsed = true;
    const glm::dvec3 a = mesh.points[p] - part.origin;
    const glm::dvec3 b = mesh.points[q] - part.origin;
    const glm::dvec3 c = mesh.points[r] - part.origin;
    part.volume += signedVolume(a, b, c, glm::dvec3(normals[p] + normals[q] + normals[r]));
  }
  return std::all_of(
    found.begin(), found.end(), [](const Part& part) { return !part.isUsed || part.volume > 0.0; });
}

} // namespace ink
