#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace ink
{

/// A disc radius for points that sample a surface evenly but come without one: the median over up to 64
/// points, taken evenly from the list, of the distance to the sixth nearest other point (fewer where there
/// are fewer points). Discs of this radius around the points of a regular, a hexagonal or a random sampling
/// overlap so that they leave no holes, save for rare ones in a random sampling.
/// @param points positions; those that are not finite are passed over
/// @return in the unit of the points; 0 for fewer than two finite points or when they coincide.
/// Time: 64 passes over the points, in parallel.
float discRadiusFromSpacing(std::span<const glm::vec3> points);

} // namespace ink
