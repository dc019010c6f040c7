// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace ink
{

/// A mesh's points in a given unit of length, relative to the center of its nondegenerate triangles, so that
/// single precision suffices.
struct ScaledPoints
{
  std::vector<glm::vec3> points;
  double widest; ///< the mesh's largest extent
};

/// @param areas those of cumulateArea(mesh)
/// @param unit above 0
/// @throws std::invalid_argument if the mesh is 2^24 units wide or more
ScaledPoints scalePoints(const TriangleMesh& mesh, const CumulativeArea& areas, double unit);

} // namespace ink
