#pragma once

#include "Parallel/ParallelFor.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// An order of points in which every beginning is spread evenly: the first k points are nowhere nearer to
/// each other than a distance that falls with k, and leave no gaps much larger than it.
///
/// Darts are thrown at the points with a radius that shrinks by a twelfth of an octave at a time (McCool and
/// Fiume 1992, section 3): at each radius every point that is far enough from all chosen ones is chosen, in
/// random order within blocks of space that are looked at in parallel. A point that is not need not be looked
/// at again before the radius is below its distance to the chosen ones, so that the time is nearly linear in
/// the number of points.
///
/// Points on different sides or sheets of a surface do not keep each other away: normals that point away from
/// each other by more than 105 degrees, or the same way but one point straight above the other.
/// @param points single precision suffices for positions relative to the points' middle; points that are not
///   finite come last
/// @param normals unit, one a point; or none: distance alone counts
/// @param radii relative size of the empty space around each point, greater than 0, one a point; or none, for
///   all the same. Two points keep a distance in proportion to the smaller of theirs.
/// @param seed together with the point's index all that the choice depends on
/// @return indices, the most important point first; none when stopped. The same on any number of threads.
std::vector<std::uint32_t> priorityOrder(std::span<const glm::vec3> points,
  std::span<const glm::vec3> normals, std::span<const float> radii, std::uint64_t seed,
  const Progress& progress = {});

} // namespace ink
