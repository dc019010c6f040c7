// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <span>
#include <vector>

namespace ink
{

/// The largest stretch of a deformed triangle: the larger singular value of the linear map from its old to
/// its new corners. For a degenerate triangle, the growth of its longest side; 1 if that had no length or a
/// value is not finite.
double largestStretch(const glm::dvec3 (&before)[3], const glm::dvec3 (&now)[3]);

/// For each point of a mesh, the largest stretch of the triangles within `rounds` rings beyond its own.
/// Interpolated linearly, it is nowhere less than the stretch of the triangle itself. Discs that cover the
/// surface and are scaled by it cover the deformed surface, if they reach no farther than these rings.
/// @param before, now positions of the same points
/// @param rounds 0 or more
std::vector<float> pointStretch(std::span<const glm::dvec3> before, std::span<const glm::dvec3> now,
  std::span<const Triangle> triangles, int rounds);

} // namespace ink
