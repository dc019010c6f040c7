#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace ink
{

/// What of a plane is nearer to the origin than to any neighbor: a Voronoi cell, cut by one neighbor after
/// the other out of a square.
class PlaneCell
{
public:
  static constexpr std::size_t mostNeighbors = 24;

  /// @param reach half the square's side
  explicit PlaneCell(float reach);

  /// Cuts off what is nearer to a neighbor. At most mostNeighbors times.
  void cut(const glm::vec2& neighbor);

  /// The distance to the farthest corner, those of the square included: neighbors twice as far away cut
  /// nothing.
  float extent() const;

  static constexpr std::size_t mostCorners = mostNeighbors + 4;

  /// The distances of the corners between two neighbors, in no order.
  /// @return how many there are; only so many are written
  std::size_t corners(std::span<float, mostCorners> distances) const;

private:
  struct Corner
  {
    glm::vec2 place;
    bool cutAfter; // whether the side from here to the next corner is a neighbor's
  };
  std::array<Corner, mostCorners> Corners;
  std::size_t Count = 4;
};

} // namespace ink
