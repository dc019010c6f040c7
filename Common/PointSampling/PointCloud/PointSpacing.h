// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace ink
{

/// A disc radius for points that sample a surface evenly: the median over up to 64 points, at regular steps
/// in the list, of the distance to the sixth nearest other point (or to the farthest if there are fewer).
/// Discs of this radius around the points of a square lattice, a hexagonal lattice or a random sampling leave
/// no holes, except for rare ones in a random sampling.
/// @param points positions; those that are not finite are ignored
/// @return in the unit of the points; 0 for fewer than two finite points or when they coincide. Time: 64
///   passes over the points, in parallel.
float discRadiusFromSpacing(std::span<const glm::vec3> points);

} // namespace ink
