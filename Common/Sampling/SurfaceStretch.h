#pragma once

#include "Sampling/TriangleMesh.h"

#include <span>
#include <vector>

namespace ink
{

/// How far two places that were one unit apart are at the most after a triangle was deformed: the larger
/// singular value of the linear map that takes its corners to where they are now. Of a triangle without area,
/// how much its longest side has grown; 1 where that had no length or anything is not finite.
double largestStretch(const glm::dvec3 (&before)[3], const glm::dvec3 (&now)[3]);

/// At each point of a mesh, the largest stretch of the triangles at it, and of those up to `rounds` points
/// further; linear in between it is nowhere less than that of the triangle itself. Discs that covered the
/// surface and grow by it cover the deformed one, if they reach no further than that.
/// @param before, now positions of the same points
/// @param rounds 0 or more
std::vector<float> pointStretch(std::span<const glm::dvec3> before, std::span<const glm::dvec3> now,
  std::span<const Triangle> triangles, int rounds);

} // namespace ink
