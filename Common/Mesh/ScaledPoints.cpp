// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/ScaledPoints.h"

#include "Core/ParallelChunks.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace ink
{

ScaledPoints scalePoints(const TriangleMesh& mesh, const CumulativeArea& areas, double unit)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (areas.area[t + 1] > areas.area[t])
    {
      for (const std::uint32_t point : mesh.triangles[t])
      {
        low = glm::min(low, mesh.points[point]);
        high = glm::max(high, mesh.points[point]);
      }
    }
  }
  const glm::dvec3 size = (high - low) / unit;
  const double widest = std::max({ size.x, size.y, size.z });
  if (!(widest < 0x1p24))
  {
    throw std::invalid_argument("the mesh is " + std::to_string(widest) +
      " radii wide; expected fewer than 16777216, so a larger radius or fewer samples");
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  std::vector<glm::vec3> points(mesh.points.size());
  parallelForEach(points.size(), [&](std::size_t i) { points[i] = (mesh.points[i] - middle) / unit; });
  return { std::move(points), widest };
}

} // namespace ink
