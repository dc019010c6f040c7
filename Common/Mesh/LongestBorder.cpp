// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/LongestBorder.h"

#include "Core/DisjointSets.h"
#include "Mesh/BorderEdges.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <vector>

namespace ink
{

double longestBorder(const TriangleMesh& mesh)
{
  const std::vector<MeshEdge> borders = borderEdges(mesh, [](const Triangle&) { return true; });
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

} // namespace ink
