// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Mesh/Seams.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// Smooths directions where they are hardly defined, as a cross field: a direction and the one at right
/// angles to it count as the same, so that neither signs nor an exchange of the two disturb the mean. The
/// directions of a point are the angle of a complex number to the power of four in its tangent plane;
/// each iteration replaces it by the mean of itself and its neighbors', turned about the planes' common line,
/// in proportion to how well each is defined (after Hertzmann and Zorin 2000, section 5.1, who minimize an
/// energy of such angles).
///
/// Directions keep their names: each result is the one of four that is closest to what it was. An undefined
/// direction (zero) gets one if it has a neighbor within as many edges as there are iterations.
///
/// @param normals one per point, unit length; zero leaves a point as it is
/// @param directions one per point, unit length or zero
/// @param umbilics one per point, in [0, 1]: up to .5 a direction is left as it is, from there to 1 it gives
///   way to its neighbors'
/// @param seams whether points of borders that share a position have common neighbors
/// @return one per point, tangent and of unit length, or zero; `directions` when stopped. The same for any
///   number of threads.
/// @throws std::invalid_argument if a span has not one entry per point, or a triangle names a point that
///   does not exist
std::vector<glm::dvec3> smoothCrossField(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> umbilics, int iterations,
  const Progress& progress = {}, Seams seams = Seams::Joined);

} // namespace ink
