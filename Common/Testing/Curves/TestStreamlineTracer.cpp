// SPDX-License-Identifier: BSD-3-Clause
// Single lines: against the known lines of curvature of a torus and an ellipsoid, and at what they end.

#include "Curves/Streamlines/StreamlineTracer.h"

#include "StreamlineShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace
{

using namespace ink;
using namespace ink::test;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool isRegular(const TorusShape&, const TracedLine&, bool)
{
  return true;
}

/// Whether a line stays away from the four umbilics, where directions turn at once, and from the planes of
/// symmetry that are lines of curvature themselves, where a parameter's slope is zero.
bool isRegular(const EllipsoidShape& ellipsoid, const TracedLine& line, bool maximum)
{
  const glm::dvec3 squares = ellipsoid.axes * ellipsoid.axes;
  return std::all_of(line.points.begin(), line.points.end(),
    [&](const TracedPoint& point)
    {
      const glm::dvec2 both = ellipsoid.parameters(ellipsoid.onto(point.position));
      return both.y - both.x > 1.0 && (maximum ? squares.x - both.y : both.x - squares.z) > 0.5;
    });
}

/// The largest deviation of lines from some triangles.
template <class Known>
double worstDeviation(
  const Known& known, const Shape& shape, bool maximum, const TraceOptions& options, double* closed = nullptr)
{
  const TriangleMesh mesh = shape.mesh.view();
  const MeshNavigation navigation(mesh, 180.0);
  const LineField field = fieldOf(shape, maximum);
  const StreamlineTracer tracer(navigation, field, options);
  double worst = 0.0;
  int closedLines = 0;
  int lines = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 97)
  {
    if (!navigation.isUsable(t))
    {
      continue;
    }
    const TracedLine line = tracer.trace({ t, { 0.3, 0.45, 0.25 } }, field.directions[mesh.triangles[t][0]], {});
    if (!isRegular(known, line, maximum))
    {
      continue;
    }
    for (const TracedPoint& point : line.points)
    {
      worst = std::max(worst, known.deviation(point.position, line.points[line.seed].position, maximum));
    }
    closedLines += line.closed ? 1 : 0;
    ++lines;
  }
  if (closed)
  {
    *closed = static_cast<double>(closedLines) / lines;
  }
  return worst;
}

} // namespace

TEST(StreamlineTracer, LinesOfATorusAreItsCircles)
{
  const TorusShape torus;
  for (const bool maximum : { true, false })
  {
    double before = infinity;
    for (const int rows : { 16, 32, 64 })
    {
      const Shape shape = torus.sample(3 * rows, rows);
      TraceOptions options;
      options.maximumLength = 30.0;
      options.closeDistance = 0.05;
      double closed = 0.0;
      const double worst = worstDeviation(torus, shape, maximum, options, &closed);
      options.integrator = StreamlineIntegrator::Euler;
      double closedEuler = 0.0;
      const double euler = worstDeviation(torus, shape, maximum, options, &closedEuler);
      std::printf("max %d rows %d: rk4 %g closed %g, euler %g closed %g\n", maximum, rows, worst, closed, euler, closedEuler);
      EXPECT_LT(worst, before);
      before = worst;
    }
  }
}

TEST(StreamlineTracer, LinesOfAnEllipsoidAreOnConfocalQuadrics)
{
  const EllipsoidShape ellipsoid;
  for (const bool maximum : { true, false })
  {
    for (const int rows : { 33, 65, 129 })
    {
      const Shape shape = ellipsoid.sample(2 * rows, rows);
      for (const double factor : { 2.0, 1.0, 0.5, 0.25, 0.125 })
      {
        TraceOptions options;
        options.maximumLength = 4.0;
        options.stepFactor = factor;
        const double worst = worstDeviation(ellipsoid, shape, maximum, options);
        options.integrator = StreamlineIntegrator::Euler;
        const double euler = worstDeviation(ellipsoid, shape, maximum, options);
        std::printf("max %d rows %d factor %g: rk4 %g euler %g\n", maximum, rows, factor, worst, euler);
      }
    }
  }
}
