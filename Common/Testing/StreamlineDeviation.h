// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StreamlineShapes.h"

#include "Curves/Streamlines/StreamlineTracer.h"

#include <glm/vec2.hpp>

#include <algorithm>

namespace ink::test
{

inline bool isRegular(const TorusShape&, const TracedLine&, bool)
{
  return true;
}

/// Whether a line stays away from the four umbilics, where directions turn at once, and from the planes of
/// symmetry that are lines of curvature themselves, where a parameter's slope is zero.
inline bool isRegular(const EllipsoidShape& ellipsoid, const TracedLine& line, bool maximum)
{
  const glm::dvec3 squares = ellipsoid.axes * ellipsoid.axes;
  return std::all_of(line.points.begin(), line.points.end(),
    [&](const TracedPoint& point)
    {
      const glm::dvec2 both = ellipsoid.parameters(ellipsoid.onto(point.position));
      return both.y - both.x > 1.0 && (maximum ? squares.x - both.y : both.x - squares.z) > 0.5;
    });
}

/// The largest deviation of regular lines, from a hundredth of the triangles, from those that are known.
template <class Known>
double largestDeviation(const Known& known, const Shape& shape, bool maximum, const TraceOptions& options)
{
  const TriangleMesh mesh = shape.mesh.view();
  const MeshNavigation navigation(mesh, 180.0);
  const LineField field = fieldOf(shape, maximum);
  const StreamlineTracer tracer(navigation, field, options);
  double worst = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 97)
  {
    if (!navigation.isUsable(t))
    {
      continue;
    }
    const TracedLine line =
      tracer.trace({ t, { 0.3, 0.45, 0.25 } }, field.directions[mesh.triangles[t][0]], {});
    if (!isRegular(known, line, maximum))
    {
      continue;
    }
    for (const TracedPoint& point : line.points)
    {
      worst = std::max(worst, known.deviation(point.position, line.points[line.seed].position, maximum));
    }
  }
  return worst;
}

} // namespace ink::test
