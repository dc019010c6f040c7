// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Eye.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace ink
{

/// The triangles of a mesh that an eye sees, both sides of them, and those around: what is left out is hidden
/// by others, and by more than a margin. Depths are compared in a picture of 1024 pixels on its larger side
/// that shows all of the mesh in front of the eye, up to 63 degrees away from the axis (a depth buffer,
/// Catmull 1974). Ascending; the same for any number of threads.
///
/// @param axis the direction that the eye looks into, of any length but 0; of no effect if it is parallel
/// @param margin how far what is seen goes on into what is not, aside and in depth, as a share of that
///   picture's larger side; two pixels at least
/// @throws std::invalid_argument as Eye::check, or if the axis is not finite or zero
std::vector<std::uint32_t> seenTriangles(
  const TriangleMesh& mesh, const Eye& eye, const glm::dvec3& axis, double margin);

} // namespace ink
