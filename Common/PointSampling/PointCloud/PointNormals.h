// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace ink
{

/// Consistently oriented unit normals of points that sample surfaces: principal component analysis of the
/// nearest neighbors, then orientation propagated along the minimum spanning tree of the neighborhood graph,
/// whose edges weigh less the more parallel the normals are (Hoppe et al. 1992, sections 3.2 and 3.3). In
/// each connected component, the normal of the point farthest from the center points away from the center, so
/// that normals of closed surfaces point outwards.
/// @param points those that are not finite get the normal 0; coincident points count as one
/// @param neighbors the number of neighbors, including the point itself, 3 to 64; more smooth noise and edges
/// @param viewpoint the position of a range scanner that saw all points: normals are then oriented towards
///   it, without a tree
/// @return one per point; none when stopped. (0, 0, 1) where the neighbors are collinear or coincide.
std::vector<glm::vec3> estimateNormals(std::span<const glm::vec3> points, int neighbors = 16,
  const Progress& progress = {}, const std::optional<glm::vec3>& viewpoint = {});

} // namespace ink
