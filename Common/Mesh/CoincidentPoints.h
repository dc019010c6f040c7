// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// How close to each other points count as one, so that seams are closed however coordinates are rounded: a
/// millionth of the largest extent between two corners of bounds, in world units.
double coincidenceDistance(const glm::dvec3& lower, const glm::dvec3& upper);

/// Which points coincide: each with one that is no farther than a distance along any axis. That one stands
/// for others and coincides with none of those before it, along a fixed direction of space.
/// @param points those that are named are finite
/// @param named indices of points, without repeats
/// @return one per entry of `named`: the least index of the points that it coincides with, itself included
std::vector<std::uint32_t> coincidentPoints(
  std::span<const glm::dvec3> points, std::span<const std::uint32_t> named, double distance);

} // namespace ink
