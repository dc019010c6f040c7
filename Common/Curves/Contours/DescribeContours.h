// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelFor.h"
#include "Curves/Contours/ContourPoints.h"
#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/ProjectContour.h"
#include "Fields/Field.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

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
template <Field F>
void describeContours(const F& field, double isoValue, const Eye& eye, const ContourArrays& arrays,
  const ContourProjection& projection, Contours& contours)
{
  const auto forEachPoint = [&contours](const auto& body)
  {
    constexpr std::size_t pointsAtOnce = 256;
    const std::size_t count = contours.positions.size();
    parallelFor((count + pointsAtOnce - 1) / pointsAtOnce,
      [&](std::size_t part)
      {
        for (std::size_t n = part * pointsAtOnce; n < std::min(count, (part + 1) * pointsAtOnce); ++n)
        {
          body(n, contours.positions[n]);
        }
      });
  };
  if (projection.steps > 0)
  {
    forEachPoint([&](std::size_t, glm::dvec3& position)
      { position = projectToContour(field, isoValue, eye, position, projection).first; });
  }
  joinCoincidentPoints(contours);
  if (arrays.normals)
  {
    contours.normals.resize(contours.positions.size());
    forEachPoint(
      [&](std::size_t n, const glm::dvec3& position)
      {
        const glm::dvec3 gradient = field.gradient(position);
        const double slope = glm::length(gradient);
        contours.normals[n] =
          slope > 0.0 && std::isfinite(slope) ? glm::vec3(-gradient / slope) : glm::vec3(0.0f, 0.0f, 1.0f);
      });
  }
  if (arrays.radialCurvature)
  {
    contours.radialCurvature.resize(contours.positions.size());
    forEachPoint([&](std::size_t n, const glm::dvec3& position)
      { contours.radialCurvature[n] = static_cast<float>(radialCurvature(field, eye, position)); });
  }
  if (arrays.arcLength)
  {
    measureArcLength(contours);
  }
  if (!arrays.elements)
  {
    contours.elements.clear();
  }
}

} // namespace ink
