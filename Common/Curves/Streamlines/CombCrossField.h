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

/// Which directions of a cross field to exchange for those at right angles, so that neighbors have the same
/// one of the two: lines along them form one family over large parts of a surface, instead of blocks at right
/// angles to each other. Signs s in [-1, 1], 1 where a direction stays, minimize
///
///   sum over points |p| (s - p / |p|)^2 + 2 (reach / mean edge)^2 sum over edges |cos(2 a)| (s_i -+ s_j)^2
///
/// with a point's preference p, and the angle a of an edge's two directions, one turned into the other's
/// tangent plane: minus where they are closer than 45 degrees, plus where the one at right angles is. An edge
/// to a point that coincides with another, which is a neighbor in its place, counts once, not twice. As
/// singularities of index 1/4 are, some seams are left; they lie where preferences are weakest.
///
/// @param normals one per point, unit length; zero leaves a point as it is
/// @param directions one per point, tangent, unit length or zero
/// @param preferences one per point, in [-1, 1]: how much the direction is to stay (1) or to be exchanged
/// (-1)
/// @param reach how far a sure point's direction goes on over others, world units
/// @param seams whether points of borders that share a position have common neighbors
/// @return one per point, 1 where the direction is to be exchanged, else 0; zeros when stopped. The same
///   for any number of threads.
/// @throws std::invalid_argument if a span has not one entry per point, or a triangle names a point that does
///   not exist
std::vector<unsigned char> combCrossField(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> preferences, double reach,
  const Progress& progress = {}, Seams seams = Seams::Joined);

} // namespace ink
