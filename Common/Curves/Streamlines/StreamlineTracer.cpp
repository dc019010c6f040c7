// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/StreamlineTracer.h"

#include "Curves/Streamlines/MeshWalk.h"
#include "Curves/Streamlines/StreamlineCell.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ink
{

namespace
{

/// No half line has more points.
constexpr int mostSteps = 100'000;

} // namespace

StreamlineTracer::StreamlineTracer(
  const MeshNavigation& mesh, const LineField& field, const TraceOptions& options)
  : Mesh(mesh)
  , Field(field)
  , Options(options)
{
}

glm::dvec3 StreamlineTracer::direction(const MeshPoint& point, const glm::dvec3& heading) const
{
  const StreamlineCell cell(this->Mesh, this->Field, point.triangle, heading);
  return cell.lift(cell.direction(point.weights));
}

LineEnd StreamlineTracer::follow(
  const MeshPoint& seed, const glm::dvec3& heading, double length, const Accept& accept) const
{
  if (!this->Mesh.isUsable(seed.triangle))
  {
    return LineEnd::Border;
  }
  const bool curves = this->Options.integrator == StreamlineIntegrator::RungeKutta4;
  MeshWalk walk(this->Mesh, this->Field, curves, seed, heading);
  TracedPoint last{ seed, walk.cell().chart.position(seed.weights), 0.0 };
  double arc = 0.0;
  glm::dvec3 position = last.position;
  // Crossings without progress, as around a vertex, must not go on forever.
  int crossings = 0;
  for (int n = 0; n < mostSteps; ++n)
  {
    if (walk.cell().isSingular && this->Options.stopAtSingularities)
    {
      return LineEnd::Umbilic;
    }
    if (this->Options.umbilicLimit < 1.0 && !this->Field.umbilics.empty())
    {
      const auto& [a, b, c] = this->Mesh.mesh().triangles[walk.at().triangle];
      const glm::dvec3 corners(this->Field.umbilics[a], this->Field.umbilics[b], this->Field.umbilics[c]);
      if (!(glm::dot(corners, walk.at().weights) <= this->Options.umbilicLimit))
      {
        return LineEnd::Umbilic;
      }
    }
    const glm::dvec2 direction = walk.cell().direction(walk.at().weights);
    if (direction == glm::dvec2(0.0))
    {
      return LineEnd::Umbilic;
    }
    const double left = length - arc;
    const double step =
      std::min({ this->Options.stepFactor * walk.cell().adaptiveStep, this->Options.maximumStep, left });
    int exit = walk.cornerBehind(direction);
    if (exit < 0 || walk.cameInBy(exit))
    {
      if (exit >= 0)
      {
        if (!walk.slide(exit, direction, step))
        {
          return LineEnd::Umbilic;
        }
        exit = -1;
      }
      else
      {
        exit = walk.step(direction, step);
      }
      const glm::dvec3 next = walk.cell().chart.position(walk.at().weights);
      const double advance = glm::distance(next, position);
      arc += advance;
      position = next;
      crossings = advance > 1e-6 * walk.cell().adaptiveStep ? 0 : crossings + 1;
      // What is hardly a step is no point of its own.
      if (arc - last.arc > 1e-3 * step || arc >= length)
      {
        last = { walk.at(), position, arc };
        if (!accept(last))
        {
          return LineEnd::Stopped;
        }
      }
      if (arc >= length * (1.0 - 1e-12))
      {
        return LineEnd::Length;
      }
    }
    else
    {
      ++crossings;
    }
    if (crossings > 1000)
    {
      return LineEnd::Umbilic;
    }
    std::optional<LineEnd> end;
    if (const int vertex = walk.vertex(); vertex >= 0)
    {
      const std::uint32_t point =
        this->Mesh.mesh().triangles[walk.at().triangle][static_cast<std::size_t>(vertex)];
      const glm::dvec3 own = this->Field.along(point, walk.cell().lift(direction));
      end = walk.leaveVertex(vertex, own == glm::dvec3(0.0) ? walk.cell().lift(direction) : own);
    }
    else if (exit >= 0)
    {
      const glm::dvec2 here = walk.cell().direction(walk.at().weights);
      end = walk.leaveByEdge(exit, here == glm::dvec2(0.0) ? direction : here);
    }
    if (end)
    {
      return *end;
    }
  }
  return LineEnd::Length;
}

TracedLine StreamlineTracer::trace(
  const MeshPoint& seed, const glm::dvec3& heading, const Accept& accept) const
{
  TracedLine line;
  if (!this->Mesh.isUsable(seed.triangle))
  {
    return line;
  }
  const glm::dvec3 forward = this->direction(seed, heading);
  if (forward == glm::dvec3(0.0))
  {
    line.ends = { LineEnd::Umbilic, LineEnd::Umbilic };
    return line;
  }
  return traceHalves(seed, this->Mesh.position(seed), forward, this->Options.closeDistance, accept,
    [&](const glm::dvec3& along, const Accept& go)
    { return this->follow(seed, along, 0.5 * this->Options.maximumLength, go); });
}

} // namespace ink
