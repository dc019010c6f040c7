// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Grid/GridField.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

/// Internal to Common/IsoSurface.
namespace ink
{

/// Central differences at a cell's corners, interpolated, per sample step; NaN at the grid's border.
template <class Work>
glm::dvec3 interpolatedGradient(const GridField<Work>& field, const glm::dvec3& point)
{
  const glm::ivec3& size = field.geometry().dimensions();
  const glm::dvec3 index = field.geometry().toIndex(point);
  const glm::ivec3 cell(glm::floor(index));
  if (glm::any(glm::lessThan(cell, glm::ivec3(1))) || glm::any(glm::greaterThan(cell, size - 3)))
  {
    return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  }
  const glm::vec<3, Work> t(index - glm::dvec3(cell));
  const glm::vec<3, Work> s = Work(1) - t;
  // Of the four samples along an axis from the one before the cell on.
  Work value[3][4];
  Work slope[3][4];
  for (int axis = 0; axis < 3; ++axis)
  {
    const Work values[4] = { Work(0), s[axis], t[axis], Work(0) };
    const Work slopes[4] = { -s[axis], -t[axis], s[axis], t[axis] };
    std::copy_n(values, 4, value[axis]);
    std::copy_n(slopes, 4, slope[axis]);
  }
  const Work* slice = field.data() + field.geometry().offset(cell - 1);
  const std::size_t row = static_cast<std::size_t>(size.x);
  // Relative to one of them, so that large values lose no digits.
  const Work middle = field.at(cell);
  glm::vec<3, Work> sum(Work(0));
  for (int z = 0; z < 4; ++z, slice += row * size.y)
  {
    for (int y = 0; y < 4; ++y)
    {
      const Work* const v = slice + row * y;
      Work mean = 0;
      Work change = 0;
      for (int x = 0; x < 4; ++x)
      {
        mean += value[0][x] * (v[x] - middle);
        change += slope[0][x] * (v[x] - middle);
      }
      sum.x += value[2][z] * value[1][y] * change;
      sum.y += value[2][z] * slope[1][y] * mean;
      sum.z += slope[2][z] * value[1][y] * mean;
    }
  }
  return sum;
}

} // namespace ink
