// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ConnectedParts.h"

#include "Core/DisjointSets.h"

namespace ink
{

std::vector<std::uint32_t> connectedParts(const TriangleMesh& mesh)
{
  DisjointSets sets(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles)
  {
    sets.join(a, b);
    sets.join(b, c);
  }
  std::vector<std::uint32_t> parts(mesh.points.size());
  std::uint32_t count = 0;
  for (std::uint32_t point = 0; point < parts.size(); ++point)
  {
    // The least comes first.
    const std::uint32_t first = sets.least(point);
    parts[point] = first == point ? count++ : parts[first];
  }
  return parts;
}

} // namespace ink
