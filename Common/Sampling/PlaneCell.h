#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace ink
{

/// What of a plane is nearer to the origin than to any neighbour: a Voronoi cell, cut by one neighbour after
/// the other out of a square.
class PlaneCell
{
public:
  static constexpr std::size_t mostNeighbours = 24;

  /// @param reach half the square's side
  explicit PlaneCell(float reach);

  /// Cuts off what is nearer to a neighbour. At most mostNeighbours times.
  void cut(const glm::vec2& neighbour);

  /// The distance to the farthest corner, those of the square included: neighbours twice as far away cut
  /// nothing.
  float extent() const;

  static constexpr std::size_t mostCorners = mostNeighbours + 4;

  /// The distances of the corners between two neighbours, in no order.
  /// @return how many there are; only so many are written
  std::size_t corners(std::span<float, mostCorners> distances) const;

private:
  struct Corner
  {
    glm::vec2 place;
    bool cutAfter; // whether the side from here to the next corner is a neighbour's
  };
  std::array<Corner, mostCorners> Corners;
  std::size_t Count = 4;
};

} // namespace ink
