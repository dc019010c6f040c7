// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/ProjectContour.h"
#include "Fields/Field.h"
#include "Fields/FieldView.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>

namespace ink
{

/// The normal curvature of a field's level set in the direction to the eye, with normals against the gradient
/// (DeCarlo et al. 2003, section 2.2): of f in the tangent direction w, - w . H w / |grad f|. 0 where it is
/// not defined.
template <Field F>
double radialCurvature(const F& field, const Eye& eye, const glm::dvec3& position)
{
  const glm::dvec3 gradient = field.gradient(position);
  const double slope = glm::length(gradient);
  const glm::dvec3 normal = gradient / slope;
  const glm::dvec3 view = eye.from(position);
  const glm::dvec3 tangent = glm::normalize(view - glm::dot(view, normal) * normal);
  const double curvature =
    -glm::dot(tangent, static_cast<glm::dmat3>(field.hessian(position)) * tangent) / slope;
  return std::isfinite(curvature) ? curvature : 0.0;
}

/// Completes the contours of f = isoValue that chains of points are given of: projects the points, joins
/// those that coincide, and fills the arrays that are asked for. Normals are against the gradient; along z
/// where there is none.
/// @param contours with positions and elements
void describeContours(const FieldView& field, double isoValue, const Eye& eye, const ContourArrays& arrays,
  const ContourProjection& projection, Contours& contours);

} // namespace ink
