// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// One family of directions from the two principal ones of each point, such that lines along them run side by
/// side over large parts of a surface, as an engraver's do, instead of in blocks at right angles to each
/// other.
///
/// Which of the two belongs to the family is said by a field that follows the preferred ones in the mean of
/// 25 distances of lines (alignedLineField). The family follows these, as well as they are defined, in the
/// mean of 4 distances; where the field lies between them, or none is defined, it leads from one to the other
/// or goes on as beside.
///
/// @param normals one per point, unit length; zero leaves a point as it is
/// @param directions one per point, tangent, unit length or zero
/// @param umbilics one per point, in [0, 1]: how little directions are determined, see umbilicMeasure
/// @param preferences one per point, in [-1, 1]: how much better the direction suits than the one at right
///   angles to it, or this (below 0)
/// @param distance of the lines, world units, above 0
/// @return one per point, tangent and of unit length, or zero; the given ones where nothing is preferred, and
///   when stopped. The same for any number of threads.
/// @throws std::invalid_argument if a span has not one entry per point
std::vector<glm::dvec3> combDirections(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> umbilics, std::span<const float> preferences,
  double distance, const Progress& progress = {});

} // namespace ink
