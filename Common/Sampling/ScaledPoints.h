// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sampling/TriangleMesh.h"

#include <vector>

namespace ink
{

/// A mesh's points with a length as the unit and the middle of its triangles with an area as the origin, so
/// that single precision does for them.
struct ScaledPoints
{
  std::vector<glm::vec3> points;
  double widest; ///< the mesh's largest extent
};

/// @param areas those of cumulateArea(mesh)
/// @param unit above 0
/// @throw std::invalid_argument if the mesh is 2^24 units wide or more
ScaledPoints scalePoints(const TriangleMesh& mesh, const CumulativeArea& areas, double unit);

} // namespace ink
