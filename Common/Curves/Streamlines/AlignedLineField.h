// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// The smoothest field of directions without a sign that follows those which points prefer (Knöppel et al.
/// 2013, sections 3 and 4, for directions that are the same after half a turn).
///
/// A direction is the root of a complex number u in its point's tangent plane. The numbers minimize
///
///   sum over points A |p| |u - q|^2 + reach^2 sum over edges w |u_i - r_ij u_j|^2
///
/// with a point's area A and preference p, the square q of the direction that is preferred, cotangent
/// weights w, and the square r_ij of the turn from one tangent plane to the other. So a preference counts
/// over a distance of reach / sqrt(|p|), and of what is smaller than the reach the mean.
/// Points within a sixth of the reach have one unknown, so that many points cost little.
///
/// @param normals one per point, unit length; zero leaves a point as it is
/// @param directions one per point, tangent, unit length or zero
/// @param preferences one per point, in [-1, 1]: above 0 the direction is preferred, below 0 the one at right
///   angles to it
/// @param reach in world units, above 0
/// @return one per point, tangent and of unit length, or zero; the given ones where nothing around is
///   preferred, and when stopped. The same for any number of threads.
/// @throws std::invalid_argument if a span has not one entry per point
std::vector<glm::dvec3> alignedLineField(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> preferences, double reach,
  const Progress& progress = {});

} // namespace ink
