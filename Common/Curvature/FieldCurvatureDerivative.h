// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/FieldCurvature.h"
#include "Curvature/TurnedTangent.h"
#include "Fields/Projection.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

namespace ink
{

/// How derivatives of a field's curvature are found.
struct FieldDerivativeOptions
{
  /// How far from a point, in world units, differences are taken; above 0. Of a grid, about the distance of
  /// its samples.
  double step = 1.0;
  /// Where the field is defined; false for NaN and infinity.
  std::function<bool(const glm::dvec3&)> within;
};

/// The derivative of the second fundamental form of a field's level set: central differences between points a
/// step away along the principal directions, projected back onto the level set, with the forms there in the
/// axes of the point, turned with the normal. Of the differences that are equal on a smooth surface (Codazzi)
/// the mean is taken. The error is of second order in the step.
///
/// Where the level set does not go on to one side, differences are one-sided; where it does to neither, 0.
/// @param at fieldCurvature there
template <Field F>
CurvatureDerivative fieldCurvatureDerivative(const F& field, const glm::dvec3& position,
  const PrincipalCurvature& at, const FieldDerivativeOptions& options)
{
  constexpr int projectionSteps = 20;
  constexpr double tolerance = 1e-6; // of the step
  const double level = field.value(position);
  const glm::dvec3 normal = at.normal();
  const std::array<glm::dvec3, 2> axes{ at.direction1, at.direction2 };
  const auto formAt = [&](const glm::dvec3& start) -> std::optional<TangentForm>
  {
    const Projection end =
      projectToIsoSurface(field, level, start, projectionSteps, tolerance * options.step, options.within);
    const std::optional<LevelSetForm> form = end.converged ? levelSetForm(field, end.position) : std::nullopt;
    // Another sheet does not count.
    if (!form || !(glm::dot(form->normal, normal) > 0.0))
    {
      return std::nullopt;
    }
    return form->inAxes(
      turnedTangent(axes[0], normal, form->normal), turnedTangent(axes[1], normal, form->normal));
  };
  std::array<TangentForm, 2> along; // derivatives of the form
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::optional<TangentForm> after = formAt(position + options.step * axes[i]);
    const std::optional<TangentForm> before = formAt(position - options.step * axes[i]);
    const TangentForm here{ at.k1, 0.0, at.k2 };
    const TangentForm to = after.value_or(here);
    const TangentForm from = before.value_or(here);
    const double distance = options.step * std::max(int(after.has_value()) + int(before.has_value()), 1);
    along[i] = { (to.l - from.l) / distance, (to.m - from.m) / distance, (to.n - from.n) / distance };
  }
  return { along[0].l, (2.0 * along[0].m + along[1].l) / 3.0, (along[0].n + 2.0 * along[1].m) / 3.0,
    along[1].n };
}

/// Adds `derivatives` to the curvature of a field's level sets at points, 0 where it has none.
/// @param found fieldCurvatures of the points
/// @param progress when it asks to stop, `found` becomes empty
template <Field F>
void addFieldDerivatives(const F& field, std::span<const glm::dvec3> points,
  const FieldDerivativeOptions& options, MeshCurvature& found, const Progress& progress = {})
{
  found.derivatives.resize(found.points.size());
  constexpr std::size_t pointsPerChunk = 64;
  const bool finished = parallelForEach(
    found.points.size(),
    [&](std::size_t i)
    {
      if (found.sources[i] != CurvatureSource::None)
      {
        found.derivatives[i] = fieldCurvatureDerivative(field, points[i], found.points[i], options);
      }
    },
    pointsPerChunk, progress);
  if (!finished)
  {
    found = {};
  }
}

} // namespace ink
