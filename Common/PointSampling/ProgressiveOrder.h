// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A progressive order of points, in which every prefix is blue noise: for every k, the first k points have a
/// minimum distance that falls with k, and leave no voids much larger than it.
///
/// Dart throwing on the points with a radius that shrinks by a twelfth of an octave at a time (McCool and
/// Fiume 1992, section 3): at each radius every point that is far enough from all chosen ones is chosen, in
/// random order within blocks of space that are processed in parallel. A rejected point is not tested again
/// until the radius is below its distance to the chosen ones, so that the time is nearly linear in the number
/// of points.
///
/// Points on different sides or sheets of a surface need no distance: those whose normals differ by more than
/// 105 degrees, or agree while one point is directly above the other, see areApart.
/// @param points relative to their center, as they are in single precision; points that are not finite come
///   last
/// @param normals unit, one per point; empty: only distances are compared
/// @param radii relative radius of each point, greater than 0; empty: all equal. The distance of two points
///   is in proportion to the smaller of theirs.
/// @param seed random choices hash it with the point's index
/// @return the points' indices in progressive order; none when stopped. The same for any number of threads.
std::vector<std::uint32_t> progressiveOrder(std::span<const glm::vec3> points,
  std::span<const glm::vec3> normals, std::span<const float> radii, std::uint64_t seed,
  const Progress& progress = {});

} // namespace ink
