// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace ink
{

/// A vector of unit length in the direction of another; zero where that has none, being zero or not finite,
/// or where the square of its length is.
template <class Real>
glm::vec<3, Real> unitOrZero(const glm::vec<3, Real>& v)
{
  const Real length = glm::length(v);
  return length > Real(0) && std::isfinite(length) ? v / length : glm::vec<3, Real>(Real(0));
}

} // namespace ink
