// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Field.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

/// Where a projection ended.
struct Projection
{
  glm::dvec3 position;
  bool converged;
};

/// The step from a position to f = isoValue if f were linear: (isoValue - f) grad f / |grad f|^2. Not finite
/// where the field or its gradient is not, or where the gradient vanishes.
/// @param value of the field at the position
template <Field F>
glm::dvec3 newtonStep(const F& field, double isoValue, const glm::dvec3& position, double value)
{
  const glm::dvec3 gradient = field.gradient(position);
  const glm::dvec3 size = glm::abs(gradient);
  // Scaled, so that squares neither overflow nor vanish.
  const double scale = std::max({ size.x, size.y, size.z });
  const glm::dvec3 direction = gradient / scale;
  return (isoValue - value) / scale / glm::dot(direction, direction) * direction;
}

/// Projects a position onto the surface f = isoValue by Newton steps along the gradient (Schmidt et al. 2007,
/// equation 2, which is printed with the opposite sign and without the square). A step that does not bring
/// the value closer to isoValue is halved, as they do, so that the gradient need not be the exact derivative
/// of the value: that of a grid, interpolated central differences, is not.
///
/// The result is the start, not converged, where the surface seems to be out of reach, that is where the next
/// step would leave `within`, and where the field is not defined or has no slope.
///
/// @param steps     how many positions to try at most; halved steps count, too
/// @param tolerance converged: the distance left, |isoValue - f| / |grad f| in world units, is no more
/// @param within    bool(const glm::dvec3&): where the position may go; false for NaN and infinity
template <Field F, class Within>
Projection projectToIsoSurface(
  const F& field, double isoValue, const glm::dvec3& start, int steps, double tolerance, const Within& within)
{
  Projection at{ start, false };
  double value = field.value(start);
  glm::dvec3 step = newtonStep(field, isoValue, start, value);
  double share = 1.0;
  for (int n = 0; n < steps && !(glm::length(step) <= tolerance); ++n)
  {
    const glm::dvec3 next = at.position + share * step;
    const double nextValue = within(next) ? static_cast<double>(field.value(next)) : NAN;
    if (std::abs(isoValue - nextValue) < std::abs(isoValue - value))
    {
      at.position = next;
      value = nextValue;
      step = newtonStep(field, isoValue, next, value);
      share = 1.0;
    }
    else
    {
      share *= 0.5;
    }
  }
  if (!within(at.position + step))
  {
    return { start, false };
  }
  at.converged = glm::length(step) <= tolerance;
  return at;
}

} // namespace ink
