#pragma once

#include "Parallel/ParallelFor.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace ink
{

/// Unit normals of points that sample surfaces, all to the same side of each: principal component analysis of
/// the nearest neighbors, then signs along the minimum spanning tree of the neighbors' graph, whose edges
/// weigh less the more parallel the normals are (Hoppe et al. 1992, sections 3.2 and 3.3). In each
/// connected part the point farthest from its middle gets a normal away from it, so that closed surfaces have
/// their normals outside.
/// @param points those that are not finite get the normal 0
/// Points at one place count as one.
/// @param neighbors how many count, themselves included; 3 to 64. More smooth noise and edges.
/// @param viewpoint from where all points were seen, as by a range scanner: normals then point to its side,
/// and no tree is needed
/// @return one a point; none when stopped. (0, 0, 1) where the neighbors lie on a line or at one place.
std::vector<glm::vec3> estimateNormals(std::span<const glm::vec3> points, int neighbors = 16,
  const Progress& progress = {}, const std::optional<glm::vec3>& viewpoint = {});

} // namespace ink
