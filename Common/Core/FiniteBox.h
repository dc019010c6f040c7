// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/IsFinite.h"
#include "Core/ParallelChunks.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>

namespace ink
{

/// The least and the greatest coordinates of points; of none infinite, the least above the greatest.
struct FiniteBox
{
  glm::dvec3 low{ std::numeric_limits<double>::infinity() };
  glm::dvec3 high{ -std::numeric_limits<double>::infinity() };

  bool isEmpty() const { return this->low.x > this->high.x; }
};

/// The box of those of some points that are finite, on all threads.
/// @param pointAt returns point i = 0 ... count - 1 as glm::dvec3
template <class PointAt>
FiniteBox finiteBox(std::size_t count, const PointAt& pointAt)
{
  return parallelReduce(
    count, FiniteBox{},
    [&](std::size_t i)
    {
      const glm::dvec3 p = pointAt(i);
      return isFinite(p) ? FiniteBox{ p, p } : FiniteBox{};
    },
    [](const FiniteBox& a, const FiniteBox& b) {
      return FiniteBox{ glm::min(a.low, b.low), glm::max(a.high, b.high) };
    });
}

} // namespace ink
