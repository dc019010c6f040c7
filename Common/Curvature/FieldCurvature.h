// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelChunks.h"
#include "Curvature/MeshCurvature.h"
#include "Curvature/PrincipalCurvature.h"
#include "Fields/Field.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace ink
{

/// The principal curvatures of the level set of a field through a point, from gradient and Hessian there. The
/// shape operator of the normal -grad f / |grad f| is, in tangent directions u and w, - u . H w / |grad f|
/// (Kindlmann et al. 2003, section 2), the sign of PrincipalCurvature.
/// @return nothing where it is not defined: the gradient is zero, or a derivative is not finite
template <Field F>
std::optional<PrincipalCurvature> fieldCurvature(const F& field, const glm::dvec3& position)
{
  const glm::dvec3 gradient = field.gradient(position);
  const double slope = glm::length(gradient);
  if (!(slope > 0.0) || !std::isfinite(slope))
  {
    return std::nullopt;
  }
  const glm::dmat3 hessian = field.hessian(position);
  const auto [axis1, axis2] = tangentAxes(-gradient / slope);
  const TangentForm form{ -glm::dot(axis1, hessian * axis1) / slope,
    -glm::dot(axis1, hessian * axis2) / slope, -glm::dot(axis2, hessian * axis2) / slope };
  if (!std::isfinite(form.l) || !std::isfinite(form.m) || !std::isfinite(form.n))
  {
    return std::nullopt;
  }
  return principalCurvature(form, axis1, axis2);
}

/// The same at many points, with the source None, and zero curvature, where it is not defined.
/// @param progress when it asks to stop, the result is empty
template <Field F>
MeshCurvature fieldCurvatures(
  const F& field, std::span<const glm::dvec3> points, const Progress& progress = {})
{
  MeshCurvature result;
  result.points.resize(points.size());
  result.sources.assign(points.size(), CurvatureSource::None);
  constexpr std::size_t pointsPerChunk = 256;
  const bool finished = parallelForEach(
    points.size(),
    [&](std::size_t i)
    {
      if (const std::optional<PrincipalCurvature> found = fieldCurvature(field, points[i]))
      {
        result.points[i] = *found;
        result.sources[i] = CurvatureSource::Surface;
      }
    },
    pointsPerChunk, progress);
  return finished ? result : MeshCurvature();
}

} // namespace ink
