// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Eye.h"
#include "Fields/Field.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ink
{

/// How far a position is from the occluding contour of f = isoValue, in first order.
struct ContourResidual
{
  double distance;     ///< from the surface, (f - isoValue) / |grad f|, in world units
  double sine;         ///< of the angle between the tangent plane and the direction to the eye
  glm::dvec3 gradient; ///< there
};

template <Field F>
ContourResidual contourResidual(const F& field, double isoValue, const Eye& eye, const glm::dvec3& position)
{
  const glm::dvec3 gradient = field.gradient(position);
  const double slope = glm::length(gradient);
  const glm::dvec3 view = eye.from(position);
  return { (static_cast<double>(field.value(position)) - isoValue) / slope,
    glm::dot(gradient, view) / (slope * glm::length(view)), gradient };
}

/// When the projection onto a contour ends, and how far it may lead.
struct ContourProjection
{
  int steps = 0;           ///< at most, halved ones included; 0: no projection
  double tolerance = 1e-4; ///< converged: the distance is no more than this times `reach`, the sine than this
  double reach = 1.0;      ///< no position moves farther, in world units
};

/// Projects a position onto the occluding contour of the surface f = isoValue, f = isoValue and
/// grad f . v = 0, by Newton steps in the plane of both functions' gradients: the shortest ones that would
/// lead there if both were linear. Steps that lead no closer are halved, so that, as in projectToIsoSurface,
/// the gradient need not be the exact derivative of the value.
///
/// Stays where the contour is out of reach, and where both gradients are parallel: there the radial curvature
/// is 0, and the contour a point where curves meet or end in a cusp.
/// @return the position, and whether the tolerance is met there
template <Field F>
std::pair<glm::dvec3, bool> projectToContour(const F& field, double isoValue, const Eye& eye,
  const glm::dvec3& start, const ContourProjection& projection)
{
  const auto error = [&](const ContourResidual& r)
  { return std::max(std::abs(r.distance) / projection.reach, std::abs(r.sine)); };
  glm::dvec3 position = start;
  ContourResidual residual = contourResidual(field, isoValue, eye, position);
  double share = 1.0;
  glm::dvec3 step(0.0);
  bool moved = true;
  for (int n = 0; n < projection.steps && !(error(residual) <= projection.tolerance); ++n)
  {
    if (moved)
    {
      // Rows of the 2x2 system: each function's gradient divided by that function's scale.
      const glm::dvec3& gradient = residual.gradient;
      const double slope = glm::length(gradient);
      const glm::dvec3 view = eye.from(position);
      const double distance = glm::length(view);
      const glm::dvec3 a = gradient / slope;
      const glm::dvec3 b = (static_cast<glm::dmat3>(field.hessian(position)) * view -
                             (eye.parallel ? glm::dvec3(0.0) : gradient)) /
        (slope * distance);
      const double ab = glm::dot(a, b);
      const double bb = glm::dot(b, b);
      const double determinant = bb - ab * ab; // a has length 1
      step =
        ((-residual.distance * bb + residual.sine * ab) * a + (-residual.sine + residual.distance * ab) * b) /
        determinant;
      share = 1.0;
    }
    const glm::dvec3 next = position + share * step;
    moved = false;
    if (glm::distance(next, start) <= projection.reach)
    {
      const ContourResidual closer = contourResidual(field, isoValue, eye, next);
      moved = error(closer) < error(residual);
      if (moved)
      {
        position = next;
        residual = closer;
      }
    }
    share *= 0.5;
  }
  return { position, error(residual) <= projection.tolerance };
}

} // namespace ink
