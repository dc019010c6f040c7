// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Eye.h"
#include "Curves/Contours/UnitBall.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ink
{

/// Planes n.x = n.p in float, which tell for almost every one whether an eye is in front of it: several at a
/// time, and with a third of the memory that position and normal take in double.
class FacingPlanes
{
public:
  static constexpr std::size_t atOnce = 8;

  FacingPlanes() = default;
  /// @param planeOf of plane i, a pair of its normal, of unit length or zero, and a position
  template <class PlaneOf>
  FacingPlanes(std::size_t count, const UnitBall& ball, const PlaneOf& planeOf)
    : Ball(ball)
  {
    this->Planes.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const std::pair<glm::dvec3, glm::dvec3> plane = planeOf(i);
      this->Planes.emplace_back(
        glm::vec3(plane.first), static_cast<float>(glm::dot(plane.first, ball.toBall(plane.second))));
    }
  }

  /// A bit for each of `atOnce` planes; those with neither bit need n.v in double.
  struct Sides
  {
    std::uint32_t front; ///< n.v > 0
    std::uint32_t back;  ///< n.v < 0
  };

  /// An eye among the planes.
  class View
  {
  public:
    View(const FacingPlanes& planes, const Eye& eye);

    /// @param planes indices, `atOnce` in a row
    Sides sides(const std::uint32_t* planes) const;

  private:
    const glm::vec4* Planes;
    glm::vec4 Position;
    float Slack;
  };

private:
  UnitBall Ball;
  std::vector<glm::vec4> Planes;
};

} // namespace ink
