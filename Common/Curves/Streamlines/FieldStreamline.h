// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Streamlines/FieldTracer.h"
#include "Fields/Field.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <vector>

namespace ink
{

/// A line of curvature on the iso-surface of a field.
struct FieldStreamline
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals; ///< unit length, against the gradient
  std::vector<double> arcLength;   ///< from the first point, in world units
  bool closed = false;             ///< then the last point is joined to the first
  std::array<LineEnd, 2> ends{};   ///< along the direction at the seed, and against it
};

/// Traces the line of curvature through a point of an iso-surface, without a mesh; see FieldTracer.
/// @param seed near the surface; it is projected, too
/// @param within bool(const glm::dvec3&): where the line may go; false for NaN and infinity
template <Field F, class Within>
FieldStreamline traceOnField(
  const F& field, const glm::dvec3& seed, const FieldTraceOptions& options, const Within& within)
{
  const FieldTracer tracer({ FieldView(field), FieldView(field), options.isoValue, within }, options);
  FieldStreamline line;
  const std::optional<FieldPoint> start = tracer.project(seed);
  if (!start)
  {
    return line;
  }
  const TracedFieldLine traced = tracer.trace(*start, glm::dvec3(0.0), {});
  line.closed = traced.closed;
  line.ends = traced.ends;
  for (const TracedPointOn<FieldPoint>& point : traced.points)
  {
    line.positions.push_back(point.position);
    line.normals.push_back(point.at.normal);
    line.arcLength.push_back(point.arc);
  }
  return line;
}

} // namespace ink
