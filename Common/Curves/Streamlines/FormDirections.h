// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/PrincipalCurvature.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace ink
{

/// Where lines that show a surface's form go, one entry per point.
struct FormDirections
{
  std::array<std::vector<glm::dvec3>, 2>
    directions;                   ///< of maximum and minimum curvature; unit length or zero
  std::vector<float> umbilics;    ///< how little they are determined, see umbilicMeasure
  std::vector<float> preferences; ///< in [-1, 1]: how much more the first one bends, or the second one
};

/// Principal directions at the smallest scale at which a surface has some: where its curvature bends it by a
/// negligible angle over the distance of two lines, that of all around (averagedCurvature) over four
/// distances, eight, and so on up to 6 % of its diagonal, as long as it bends by no more than that angle
/// over these. So a cylinder with noise is hatched around, and not along each of its dents.
///
/// What is round and has no direction at any scale, as a sphere, has that of parallels around one axis, which
/// hardly counts: any other direction nearby prevails. The axis is between the coordinate axes, so that none
/// of the usual views is along it, and in the light of the usual lamp. Planes have none.
///
/// @param mesh each triangle's points exist
/// @param normals one per point, unit length or zero
/// @param curvatures one per point
/// @param negligible a curvature that counts as none over the distance, in 1 / world unit
/// @param distance of the lines, world units, above 0
/// @return the same for any number of threads
/// @throws std::invalid_argument if a span has not one entry per point
FormDirections formDirections(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const PrincipalCurvature> curvatures, double negligible, double distance);

} // namespace ink
