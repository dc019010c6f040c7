// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/FieldCurvature.h"
#include "Curves/Streamlines/StreamlineTracer.h"
#include "Fields/Field.h"
#include "Fields/Projection.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <vector>

namespace ink
{

struct FieldTraceOptions
{
  double isoValue = 0.0;
  bool maximum = true;        ///< along maximum or minimum curvature
  double step = 1.0;          ///< in world units
  double maximumLength = 1e3; ///< in steps; of a line, each of its halves has half of it
  double umbilicLimit = 0.98; ///< lines end where the umbilic measure is more
  double closeDistance = 0.0; ///< in steps: a line that passes its start in this distance is closed
  int projectionSteps = 20;   ///< of Newton's method after each step
  double tolerance = 1e-6;    ///< in steps: how far points may be from the surface
};

/// A line of curvature on the iso-surface of a field.
struct FieldStreamline
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals; ///< unit length, against the gradient
  std::vector<double> arcLength;   ///< from the first point, in world units
  bool closed = false;             ///< then the last point is joined to the first
  std::array<LineEnd, 2> ends{};   ///< along the direction at the seed, and against it
};

/// The direction of the line of curvature of the level set through a position that is closer to a heading;
/// zero where it is not defined.
template <Field F>
glm::dvec3 fieldDirection(
  const F& field, const glm::dvec3& position, const glm::dvec3& heading, const FieldTraceOptions& options)
{
  const std::optional<PrincipalCurvature> here = fieldCurvature(field, position);
  if (!here || here->umbilicMeasure() > options.umbilicLimit)
  {
    return glm::dvec3(0.0);
  }
  const glm::dvec3& direction = options.maximum ? here->direction1 : here->direction2;
  return glm::dot(direction, heading) < 0.0 ? -direction : direction;
}

/// Traces the line of curvature through a point of an iso-surface, without a mesh: with directions from
/// gradient and Hessian, by classical Runge-Kutta steps of fourth order, each of which ends with a projection
/// back onto the surface.
///
/// Lines end at umbilics (as a limit of the measure, and where the direction turns by more than 60 degrees in
/// a step), where the field or the surface ends, and at their greatest length.
/// @param seed near the surface; it is projected, too
/// @param within bool(const glm::dvec3&): where the line may go; false for NaN and infinity
template <Field F, class Within>
FieldStreamline traceOnField(
  const F& field, const glm::dvec3& seed, const FieldTraceOptions& options, const Within& within)
{
  const auto project = [&](const glm::dvec3& position) -> std::optional<glm::dvec3>
  {
    const Projection end = projectToIsoSurface(
      field, options.isoValue, position, options.projectionSteps, options.tolerance * options.step, within);
    return end.converged && within(end.position) ? std::optional(end.position) : std::nullopt;
  };
  FieldStreamline line;
  const std::optional<glm::dvec3> start = project(seed);
  const std::optional<PrincipalCurvature> first = start ? fieldCurvature(field, *start) : std::nullopt;
  if (!first)
  {
    return line;
  }
  const glm::dvec3 forward =
    fieldDirection(field, *start, options.maximum ? first->direction1 : first->direction2, options);
  if (forward == glm::dvec3(0.0))
  {
    line.ends = { LineEnd::Umbilic, LineEnd::Umbilic };
    return line;
  }
  const double near = options.closeDistance * options.step;
  std::array<std::vector<glm::dvec3>, 2> halves;
  for (std::size_t half = 0; half < 2 && !line.closed; ++half)
  {
    line.ends[half] = LineEnd::Length;
    glm::dvec3 at = *start;
    glm::dvec3 heading = half == 0 ? forward : -forward;
    for (double n = 0.0; n < 0.5 * options.maximumLength; ++n)
    {
      const auto direction = [&](const glm::dvec3& position)
      { return fieldDirection(field, position, heading, options); };
      const double h = options.step;
      const glm::dvec3 k1 = direction(at);
      const glm::dvec3 k2 = direction(at + 0.5 * h * k1);
      const glm::dvec3 k3 = direction(at + 0.5 * h * k2);
      const glm::dvec3 k4 = direction(at + h * k3);
      if (k1 == glm::dvec3(0.0) || k2 == glm::dvec3(0.0) || k3 == glm::dvec3(0.0) || k4 == glm::dvec3(0.0) ||
        glm::dot(k1, heading) < 0.5 || glm::dot(k4, k1) < 0.5)
      {
        line.ends[half] = LineEnd::Umbilic;
        break;
      }
      const std::optional<glm::dvec3> next = project(at + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4));
      if (!next)
      {
        line.ends[half] = LineEnd::Border;
        break;
      }
      // Past the plane through the start at right angles to the line?
      const double from = glm::dot(*start - at, forward);
      const double to = glm::dot(*next - *start, forward);
      if (half == 0 && n > 2.0 && from >= 0.0 && to >= 0.0 && from + to > 0.5 * h &&
        glm::distance(at + from / (from + to) * (*next - at), *start) < near)
      {
        line.closed = true;
        line.ends = { LineEnd::Closed, LineEnd::Closed };
        break;
      }
      at = *next;
      heading = k4;
      halves[half].push_back(at);
    }
  }
  line.positions.assign(halves[1].rbegin(), halves[1].rend());
  line.positions.push_back(*start);
  line.positions.insert(line.positions.end(), halves[0].begin(), halves[0].end());
  for (std::size_t i = 0; i < line.positions.size(); ++i)
  {
    line.normals.push_back(-glm::normalize(field.gradient(line.positions[i])));
    line.arcLength.push_back(
      i == 0 ? 0.0 : line.arcLength[i - 1] + glm::distance(line.positions[i - 1], line.positions[i]));
  }
  return line;
}

} // namespace ink
