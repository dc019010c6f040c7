// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <vector>

namespace ink
{

/// Directions on the flat parts of a mesh, where curvature has none: one for each whole part (triangles that
/// share points), so that hatching is straight there. A part is flat if it is no farther from a plane than
/// 3 % of its width, both as root mean squares, and faces to one side. Its direction is
///   - where its border has one, up to right angles (the mean over the border's edges of exp(4 i a), of their
///     angles a, weighted by length, is larger than 1/2): parallel or at right angles to that, whichever the
///     part extends farther along;
///   - else that in which the part extends farthest.
/// Where two extents are nearly equal, as those of squares and discs, it is the one nearest to the x axis, or
/// in planes at right angles to that the y axis.
///
/// @param mesh cut open along its edges, see splitAtFeatures; each triangle's points exist
/// @return one per point: unit length and in the part's plane; zero where the surface is not flat. The same
///   for any number of threads.
std::vector<glm::dvec3> flatDirections(const TriangleMesh& mesh);

} // namespace ink
