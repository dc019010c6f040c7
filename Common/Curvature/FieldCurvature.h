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

/// The second fundamental form of a level set, from gradient and Hessian: of the normal -grad f / |grad f| it
/// is - u . H w / |grad f| in tangent directions u and w (Kindlmann et al. 2003, section 2), the sign of
/// PrincipalCurvature.
struct LevelSetForm
{
  glm::dvec3 normal; ///< unit length, against the gradient
  glm::dmat3 hessian;
  double slope; ///< |grad f|, above 0

  double operator()(const glm::dvec3& u, const glm::dvec3& w) const
  {
    return -glm::dot(u, this->hessian * w) / this->slope;
  }
  /// Nothing where a derivative is not finite.
  std::optional<TangentForm> inAxes(const glm::dvec3& axis1, const glm::dvec3& axis2) const
  {
    const TangentForm form{ (*this)(axis1, axis1), (*this)(axis1, axis2), (*this)(axis2, axis2) };
    const bool isFinite = std::isfinite(form.l) && std::isfinite(form.m) && std::isfinite(form.n);
    return isFinite ? std::optional(form) : std::nullopt;
  }
};

/// @return nothing where it is not defined: the gradient is zero or not finite
template <Field F>
std::optional<LevelSetForm> levelSetForm(const F& field, const glm::dvec3& position)
{
  const glm::dvec3 gradient = field.gradient(position);
  const double slope = glm::length(gradient);
  if (!(slope > 0.0) || !std::isfinite(slope))
  {
    return std::nullopt;
  }
  return LevelSetForm{ -gradient / slope, field.hessian(position), slope };
}

/// The principal curvatures of the level set of a field through a point.
/// @return nothing where it is not defined: the gradient is zero, or a derivative is not finite
template <Field F>
std::optional<PrincipalCurvature> fieldCurvature(const F& field, const glm::dvec3& position)
{
  const std::optional<LevelSetForm> here = levelSetForm(field, position);
  if (!here)
  {
    return std::nullopt;
  }
  const auto [axis1, axis2] = tangentAxes(here->normal);
  const std::optional<TangentForm> form = here->inAxes(axis1, axis2);
  return form ? std::optional(principalCurvature(*form, axis1, axis2)) : std::nullopt;
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
