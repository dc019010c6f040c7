// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace ink
{

/// The 2D Voronoi cell of the origin, clipped out of a square by one neighbor's bisector after the other.
class VoronoiCell2D
{
public:
  static constexpr std::size_t mostNeighbors = 24;

  /// @param reach half the square's side
  explicit VoronoiCell2D(float reach);

  /// Clips the cell by the bisector to a neighbor. May be called mostNeighbors times.
  void cut(const glm::vec2& neighbor);

  /// The distance to the farthest corner, including those of the square: neighbors twice as far away clip
  /// nothing.
  float extent() const;

  static constexpr std::size_t mostCorners = mostNeighbors + 4;

  /// The distances of the corners between two neighbors' bisectors, in no particular order.
  /// @return their number; only that many are written
  std::size_t corners(std::span<float, mostCorners> distances) const;

private:
  struct Corner
  {
    glm::vec2 position;
    bool cutAfter; // whether the edge to the next corner is part of a bisector
  };
  std::array<Corner, mostCorners> Corners;
  std::size_t Count = 4;
};

} // namespace ink
