#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

/// The finite ones of some points, each place once: many points at one place would leave no room for others
/// among a point's nearest neighbors.
struct DistinctPoints
{
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit DistinctPoints(std::span<const glm::vec3> points);

  std::vector<glm::vec3> places;    ///< in the order in which the points first have them
  std::vector<std::uint32_t> first; ///< of each place, its first point
  std::vector<std::uint32_t> of;    ///< of each point, its place; `none` if it is not finite
};

} // namespace ink
