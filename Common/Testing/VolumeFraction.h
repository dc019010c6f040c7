// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

namespace ink::testing
{

/// The share of a cell of edge 1 around a point that lies within a shape, as solvers of multiphase flows have
/// it: that of 4 x 4 x 4 points.
template <class Shape>
double volumeFraction(const Shape& shape, const glm::dvec3& center)
{
  int inside = 0;
  for (int k = 0; k < 64; ++k)
  {
    const glm::dvec3 part(k & 3, k >> 2 & 3, k >> 4);
    inside += shape.distance(center + (part - 1.5) / 4.0) < 0.0 ? 1 : 0;
  }
  return inside / 64.0;
}

} // namespace ink::testing
