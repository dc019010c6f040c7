// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curvature/PrincipalCurvature.h"
#include "Curves/Streamlines/LineSurface.h"
#include "Curves/Streamlines/TracedLine.h"
#include "Fields/FieldView.h"

#include <glm/vec3.hpp>

#include <functional>
#include <optional>

namespace ink
{

/// The iso-surface of a field, and what its curvature is of: the same field or, where that is noisy, a
/// smoothed one. Those that the views are of have to outlive it.
struct FieldSurface
{
  FieldView values; ///< greater on the inside
  FieldView form;   ///< its curvature is followed
  double isoValue = 0.0;
  /// Where the surface is; false for NaN and infinity.
  std::function<bool(const glm::dvec3&)> within;
};

struct FieldTraceOptions
{
  double isoValue = 0.0;
  bool maximum = true;        ///< along maximum or minimum curvature
  double step = 1.0;          ///< in world units
  double maximumLength = 1e3; ///< in steps; of a line, each of its halves has half of it
  double umbilicLimit = 0.98; ///< lines end where the umbilic measure is more
  double negligible = 0.0;    ///< a curvature that counts as none, in 1 / world unit
  double closeDistance = 0.0; ///< in steps: a line that passes its start in this distance is closed
  int projectionSteps = 20;   ///< of Newton's method after each step
  double tolerance = 1e-6;    ///< in steps: how far points may be from the surface
};

/// A point of an iso-surface.
struct FieldPoint
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 normal{ 0.0 }; ///< unit length, against the gradient
};

using TracedFieldLine = TracedLineOn<FieldPoint>;

/// Integrates lines of curvature on the iso-surface of a field, without a mesh: with directions from gradient
/// and Hessian, by classical Runge-Kutta steps of fourth order, each of which ends with a projection back
/// onto the surface.
///
/// Lines end at umbilics (as a limit of the measure, and where the direction turns by more than 60 degrees in
/// a step), where the field or the surface ends, and at their greatest length.
class FieldTracer
{
public:
  using Accept = AcceptPoint<FieldPoint>;

  /// `options.isoValue` does not count.
  FieldTracer(const FieldSurface& surface, const FieldTraceOptions& options);

  /// The point of the surface that is nearest along the gradient; nothing if none is found.
  std::optional<FieldPoint> project(const glm::dvec3& position) const;

  /// The direction of the line through a position that is closer to a heading, and how little it is defined;
  /// zero where it is not.
  SurfaceDirection directionAt(const glm::dvec3& position, const glm::dvec3& heading) const;

  /// One half of a line.
  LineEnd follow(const FieldPoint& seed, const glm::dvec3& toward, const Accept& accept) const;

  /// Both halves, see traceHalves.
  TracedFieldLine trace(const FieldPoint& seed, const glm::dvec3& heading, const Accept& accept) const;

  /// Where one gets going straight on along the surface, by steps that are turned back into it.
  std::optional<SurfaceArrival<FieldPoint>> walk(
    const FieldPoint& from, const glm::dvec3& direction, double distance) const;

private:
  FieldSurface Surface;
  FieldTraceOptions Options;
};

} // namespace ink
