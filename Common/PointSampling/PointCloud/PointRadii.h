// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// Disc radii for points that sample surfaces unevenly, such as raw scans (left open by Zhang et al. 2014,
/// section 6).
struct PointRadii
{
  std::vector<float> radius;     ///< one per point, in the unit of the points
  std::vector<char> isolated;    ///< 1 for points that belong to no surface; their radius is 0
  std::size_t isolatedCount = 0; ///< of points
};

/// A radius for each point from the distances to its neighbors, such that discs cover dense and sparse
/// regions without holes, but do not close real holes.
///
/// The 24 nearest positions are unfolded into a point's tangent plane, preserving their distances. The
/// farthest corner of the point's Voronoi cell among them determines the disc's radius. A corner three times
/// as far away as the median of corners nearby belongs to a hole and is ignored; so points at a boundary have
/// discs like those in the interior. Then each point takes the maximum over its twelve nearest neighbors,
/// then the mean of these maxima, so that radii vary slowly, and adds a quarter.
///
/// A point is isolated when it is eight times as far from its neighbors as the densest three of these are
/// from theirs, or three times and off their plane; or when it is in a volumetric cloud with six times the
/// median spacing of all points. Coincident points count as one.
///
/// @param normals unit, one per point: neighbors that face away are on the other side of the surface and
///   ignored. Empty, or zero for some points: both sides count.
/// @return radius 0 for points that are not finite, and for all if there are no two distinct ones; for
///   collinear neighbors the distance to the sixth of them. Nothing when stopped. Time: O(n log n), in
///   parallel.
PointRadii pointRadii(
  std::span<const glm::vec3> points, std::span<const glm::vec3> normals, const Progress& progress = {});

} // namespace ink
