#pragma once

#include "Parallel/ParallelFor.h"

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace ink
{

/// Discs for points that sample surfaces unevenly, as raw scans do (what Zhang et al. 2014, section 6, leave
/// open).
struct PointRadii
{
  std::vector<float> radius;     ///< one a point, in the unit of the points
  std::vector<char> isolated;    ///< 1 for points that belong to no surface; their radius is 0
  std::size_t isolatedCount = 0; ///< of points
};

/// A radius for each point by the distances to its neighbors, so that the discs leave no holes where points
/// are dense or sparse, and do not close those that the points leave.
///
/// The nearest 24 places around a point are laid into its tangent plane, each at its distance. What is nearer
/// to the point than to any of them is its cell (a Voronoi cell), and its farthest corner says how wide the
/// disc must be. A corner counts as one of a hole, and not at all, when it is three times as far away as
/// corners around here are in the median; so points on a border have discs as those behind them. Then each
/// point takes the widest of the twelve nearest, and the mean of these, which makes radii change slowly from
/// point to point, and a quarter more.
///
/// A point is isolated when it is eight times as far from its neighbors as the densest three of these are
/// from theirs, or three times and stands out of their plane; or when it is in a cloud that fills space and
/// is six times as sparse as the points are in the median. Points at one place count as one.
///
/// @param normals unit, one a point: neighbors that face away are not of the same side of the surface.
/// Empty, or zero for some points: both sides count.
/// @return radius 0 for points that are not finite, and for all if there are not two different ones. Nothing
/// when stopped. Where neighbors lie on a line, the distance to the sixth of them. Time: n log n, in
/// parallel.
PointRadii pointRadii(
  std::span<const glm::vec3> points, std::span<const glm::vec3> normals, const Progress& progress = {});

} // namespace ink
