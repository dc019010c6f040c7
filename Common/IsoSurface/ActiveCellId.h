// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace ink
{

/// One number for a cell of a grid, by its global index, so that pieces of a grid agree: 21 bits an axis, x
/// in the lowest. Ascending in grid order. Indices from -2^20 to 2^20 - 2 along each axis.
using ActiveCellId = std::int64_t;

/// What the id of a cell's neighbor along an axis is greater by.
constexpr ActiveCellId activeCellStep(int axis)
{
  return ActiveCellId{ 1 } << (21 * axis);
}

inline ActiveCellId activeCellId(const glm::ivec3& cell)
{
  constexpr ActiveCellId bias = ActiveCellId{ 1 } << 20;
  return (cell.x + bias) * activeCellStep(0) + (cell.y + bias) * activeCellStep(1) +
    (cell.z + bias) * activeCellStep(2);
}

} // namespace ink
