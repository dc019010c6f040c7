// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

/// Welded points: the finite points with duplicate positions merged, since coincident points would displace
/// all others from the nearest neighbors.
struct WeldedPoints
{
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit WeldedPoints(std::span<const glm::vec3> points);

  std::vector<glm::vec3> positions; ///< distinct positions, in the order of their first points
  std::vector<std::uint32_t> first; ///< for each position, its first point
  std::vector<std::uint32_t> of;    ///< for each point, the index of its position; `none` if it is not finite
};

} // namespace ink
