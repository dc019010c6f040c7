// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/FieldTracer.h"

#include "Core/UnitOrZero.h"
#include "Curvature/FieldCurvature.h"
#include "Fields/Projection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

/// No half line has more points.
constexpr double mostFieldSteps = 2e6;

glm::dvec3 tangentPart(const glm::dvec3& vector, const glm::dvec3& normal)
{
  return unitOrZero(vector - glm::dot(vector, normal) * normal);
}

} // namespace

FieldTracer::FieldTracer(const FieldSurface& surface, const FieldTraceOptions& options)
  : Surface(surface)
  , Options(options)
{
}

std::optional<FieldPoint> FieldTracer::project(const glm::dvec3& position) const
{
  const Projection end = projectToIsoSurface(this->Surface.values, this->Surface.isoValue, position,
    this->Options.projectionSteps, this->Options.tolerance * this->Options.step, this->Surface.within);
  if (!end.converged || !this->Surface.within(end.position))
  {
    return std::nullopt;
  }
  const glm::dvec3 gradient = this->Surface.values.gradient(end.position);
  const double slope = glm::length(gradient);
  return slope > 0.0 && std::isfinite(slope) ? std::optional<FieldPoint>({ end.position, -gradient / slope })
                                             : std::nullopt;
}

SurfaceDirection FieldTracer::directionAt(const glm::dvec3& position, const glm::dvec3& heading) const
{
  const std::optional<PrincipalCurvature> here = fieldCurvature(this->Surface.form, position);
  const double measure = here ? here->umbilicMeasure(this->Options.negligible) : 1.0;
  if (!here || measure > this->Options.umbilicLimit)
  {
    return { glm::dvec3(0.0), 1.0f };
  }
  const glm::dvec3& direction = this->Options.maximum ? here->direction1 : here->direction2;
  return { glm::dot(direction, heading) < 0.0 ? -direction : direction, static_cast<float>(measure) };
}

LineEnd FieldTracer::follow(const FieldPoint& seed, const glm::dvec3& toward, const Accept& accept) const
{
  const double h = this->Options.step;
  glm::dvec3 at = seed.position;
  glm::dvec3 heading = toward;
  double arc = 0.0;
  const double count = std::min(0.5 * this->Options.maximumLength, mostFieldSteps);
  for (double n = 0.0; n < count; ++n)
  {
    const auto direction = [&](const glm::dvec3& position)
    { return this->directionAt(position, heading).direction; };
    const glm::dvec3 k1 = direction(at);
    const glm::dvec3 k2 = direction(at + 0.5 * h * k1);
    const glm::dvec3 k3 = direction(at + 0.5 * h * k2);
    const glm::dvec3 k4 = direction(at + h * k3);
    if (k1 == glm::dvec3(0.0) || k2 == glm::dvec3(0.0) || k3 == glm::dvec3(0.0) || k4 == glm::dvec3(0.0) ||
      glm::dot(k1, heading) < 0.5 || glm::dot(k4, k1) < 0.5)
    {
      return LineEnd::Umbilic;
    }
    const std::optional<FieldPoint> next = this->project(at + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4));
    if (!next)
    {
      return LineEnd::Border;
    }
    arc += glm::distance(at, next->position);
    if (!accept({ *next, next->position, arc }))
    {
      return LineEnd::Stopped;
    }
    at = next->position;
    heading = k4;
  }
  return LineEnd::Length;
}

TracedFieldLine FieldTracer::trace(
  const FieldPoint& seed, const glm::dvec3& heading, const Accept& accept) const
{
  const glm::dvec3 forward = this->directionAt(seed.position, heading).direction;
  if (forward == glm::dvec3(0.0))
  {
    TracedFieldLine line;
    line.ends = { LineEnd::Umbilic, LineEnd::Umbilic };
    return line;
  }
  return traceHalves(seed, seed.position, forward, this->Options.closeDistance * this->Options.step, accept,
    [&](const glm::dvec3& along, const Accept& go) { return this->follow(seed, along, go); });
}

std::optional<SurfaceArrival<FieldPoint>> FieldTracer::walk(
  const FieldPoint& from, const glm::dvec3& direction, double distance) const
{
  FieldPoint at = from;
  glm::dvec3 heading = tangentPart(direction, at.normal);
  const double count = std::ceil(distance / this->Options.step);
  if (heading == glm::dvec3(0.0) || !(count < mostFieldSteps))
  {
    return std::nullopt;
  }
  for (double n = 0.0; n < count; ++n)
  {
    const std::optional<FieldPoint> next = this->project(at.position + distance / count * heading);
    if (!next)
    {
      return std::nullopt;
    }
    at = *next;
    heading = tangentPart(heading, at.normal);
  }
  return SurfaceArrival<FieldPoint>{ at, heading };
}

} // namespace ink
