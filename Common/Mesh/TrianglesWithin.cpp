// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TrianglesWithin.h"

namespace ink
{

std::vector<std::uint32_t> trianglesWithin(const TriangleMesh& mesh, std::span<const HalfSpace> region)
{
  std::vector<std::uint32_t> result;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle& triangle = mesh.triangles[t];
    const bool reaches = std::all_of(region.begin(), region.end(),
      [&](const HalfSpace& half)
      {
        return std::any_of(triangle.begin(), triangle.end(),
          [&](std::uint32_t point) { return half.contains(mesh.points[point]); });
      });
    if (reaches)
    {
      result.push_back(t);
    }
  }
  return result;
}

} // namespace ink
