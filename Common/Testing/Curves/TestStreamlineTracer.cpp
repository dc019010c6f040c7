// SPDX-License-Identifier: BSD-3-Clause
// Single lines: against the known lines of curvature of a torus and an ellipsoid, and at what they end.

#include "Curves/Streamlines/StreamlineTracer.h"

#include "StreamlineDeviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

constexpr double infinity = std::numeric_limits<double>::infinity();

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
      options.maximumLength = 10.0;
      const double worst = largestDeviation(torus, shape, maximum, options);
      EXPECT_LT(worst, before / 2.0) << rows << " rows";
      before = worst;
    }
    EXPECT_LT(before, maximum ? 0.001 : 0.02);
  }
}

TEST(StreamlineTracer, DeviationFallsWithTheStep)
{
  // First order with Euler; with Runge and Kutta it is that of the mesh from a quarter of the published step
  // on.
  const EllipsoidShape ellipsoid;
  const Shape shape = ellipsoid.sample(130, 65);
  for (const bool maximum : { true, false })
  {
    std::vector<double> euler;
    std::vector<double> rungeKutta;
    for (const double factor : { 1.0, 0.5, 0.25, 0.125 })
    {
      TraceOptions options;
      options.maximumLength = 4.0;
      options.stepFactor = factor;
      rungeKutta.push_back(largestDeviation(ellipsoid, shape, maximum, options));
      options.integrator = StreamlineIntegrator::Euler;
      euler.push_back(largestDeviation(ellipsoid, shape, maximum, options));
    }
    EXPECT_LT(euler[0], 0.07);
    EXPECT_LT(euler[3], euler[2] / 1.6);
    EXPECT_LT(rungeKutta[1], euler[1] / 8.0);
    EXPECT_LT(rungeKutta[2], 0.003);
    EXPECT_NEAR(rungeKutta[3], rungeKutta[2], 1e-4);
  }
}

TEST(StreamlineTracer, CirclesAreClosed)
{
  const TorusShape torus;
  const Shape shape = torus.sample(120, 40);
  const MeshNavigation navigation(shape.mesh.view(), 180.0);
  const LineField field = fieldOf(shape);
  TraceOptions options;
  options.closeDistance = 0.02;
  const StreamlineTracer tracer(navigation, field, options);
  const TracedLine line = tracer.trace({ 700, { 0.2, 0.3, 0.5 } }, field.directions[0], {});
  EXPECT_TRUE(line.closed);
  EXPECT_EQ(line.ends[0], LineEnd::Closed);
  const double whole =
    line.points.back().arc + glm::distance(line.points.back().position, line.points.front().position);
  EXPECT_NEAR(whole, 2.0 * std::numbers::pi * torus.tube, 0.01);
}

namespace
{

/// A square with one direction everywhere.
Shape uniform(int cells, const glm::dvec3& direction)
{
  Shape shape{ square(cells), {}, {}, {} };
  shape.maximum.assign(shape.mesh.points.size(), glm::normalize(direction));
  return shape;
}

TracedLine traceOn(const Shape& shape, const MeshPoint& seed, const TraceOptions& options = {},
  double featureAngle = 180.0, std::span<const float> umbilics = {})
{
  const MeshNavigation navigation(shape.mesh.view(), featureAngle);
  const LineField field{ shape.maximum, {}, umbilics };
  return StreamlineTracer(navigation, field, options).trace(seed, shape.maximum[0], {});
}

} // namespace

TEST(StreamlineTracer, StraightLinesPassThroughVerticesAndAlongEdges)
{
  // From a vertex along edges, along diagonals, against them, and by tiny amounts off all of these.
  for (const double angle : { 0.0, 45.0, 90.0, 135.0, -45.0, 26.565051177077990 })
  {
    for (const double off : { 0.0, 1e-14, -1e-14, 1e-10, -1e-10, 1e-7, -1e-7 })
    {
      const double turn = angle * std::numbers::pi / 180.0 + off;
      const glm::dvec3 direction(std::cos(turn), std::sin(turn), 0.0);
      const Shape shape = uniform(8, direction);
      // The vertex at (.5, .5).
      const std::uint32_t vertex = 4 * 9 + 4;
      for (std::uint32_t t = 0; t < shape.mesh.triangles.size(); ++t)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          if (shape.mesh.triangles[t][static_cast<std::size_t>(corner)] != vertex)
          {
            continue;
          }
          MeshPoint seed{ t, glm::dvec3(0.0) };
          seed.weights[corner] = 1.0;
          const TracedLine line = traceOn(shape, seed);
          const std::string where = std::to_string(angle) + " degrees + " + std::to_string(off);
          EXPECT_EQ(line.ends[0], LineEnd::Border) << where;
          EXPECT_EQ(line.ends[1], LineEnd::Border) << where;
          const double size = std::max(std::abs(direction.x), std::abs(direction.y));
          EXPECT_NEAR(line.points.back().arc, 1.0 / size, 1e-6) << where;
          for (const TracedPoint& point : line.points)
          {
            const glm::dvec3 offset = point.position - glm::dvec3(0.5, 0.5, 0.0);
            EXPECT_LT(glm::length(offset - glm::dot(offset, direction) * direction), 1e-6) << where;
          }
        }
      }
    }
  }
}

TEST(StreamlineTracer, LinesEndWhereTheyShould)
{
  const Shape shape = uniform(10, { 1.0, 0.1, 0.0 });
  const MeshPoint seed{ 84, { 0.3, 0.3, 0.4 } };
  TraceOptions options;
  options.maximumLength = 0.2;
  const TracedLine cut = traceOn(shape, seed, options);
  EXPECT_NEAR(cut.points.back().arc, 0.2, 1e-12);
  EXPECT_EQ(cut.ends[0], LineEnd::Length);

  // Umbilic to the right of x = .7.
  std::vector<float> umbilics;
  for (const glm::dvec3& p : shape.mesh.points)
  {
    umbilics.push_back(p.x > 0.65 ? 1.0f : 0.0f);
  }
  options = {};
  options.umbilicLimit = 0.5;
  options.maximumStep = 0.01;
  const TracedLine short1 = traceOn(shape, seed, options, 180.0, umbilics);
  EXPECT_NEAR(std::max(short1.points.back().position.x, short1.points.front().position.x), 0.65, 0.02);

  // A fold of 90 degrees at x = .5 is a feature edge of 45 degrees, and none of 100.
  Shape fold = shape;
  for (std::size_t i = 0; i < fold.mesh.points.size(); ++i)
  {
    glm::dvec3& p = fold.mesh.points[i];
    if (p.x > 0.5 + 1e-9)
    {
      p = { 0.5, p.y, p.x - 0.5 };
      fold.maximum[i] = glm::normalize(glm::dvec3(0.0, 0.1, 1.0));
    }
    else if (p.x > 0.5 - 1e-9)
    {
      fold.maximum[i] = glm::normalize(glm::dvec3(1.0, 0.1 * std::sqrt(2.0), 1.0));
    }
  }
  const auto reach = [&](double angle)
  {
    const TracedLine line = traceOn(fold, seed, {}, angle);
    return std::max(line.points.front().position.z, line.points.back().position.z);
  };
  EXPECT_NEAR(reach(45.0), 0.0, 1e-12);
  EXPECT_NEAR(reach(100.0), 0.5, 1e-9);
}

TEST(StreamlineTracer, LinesEndAtSingularTriangles)
{
  // Directions x / 2 turns around the center: an umbilic of index 1/2 (a lemon).
  Shape shape{ square(11), {}, {}, {} };
  for (const glm::dvec3& p : shape.mesh.points)
  {
    const double angle = 0.5 * std::atan2(p.y - 0.5, p.x - 0.48);
    shape.maximum.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  const MeshNavigation navigation(shape.mesh.view(), 180.0);
  const LineField field = fieldOf(shape);
  const StreamlineTracer tracer(navigation, field, {});
  int umbilics = 0;
  for (std::uint32_t t = 0; t < shape.mesh.triangles.size(); ++t)
  {
    const TracedLine line = tracer.trace({ t, { 0.4, 0.3, 0.3 } }, shape.maximum[0], {});
    umbilics += line.ends[0] == LineEnd::Umbilic && line.points.size() == 1 ? 1 : 0;
  }
  EXPECT_EQ(umbilics, 1);
}

TEST(StreamlineTracer, CrossesDoNotCareForNamesAndSigns)
{
  // Random signs and names: the lines of the cross field are the straight ones.
  Shape shape = uniform(10, { 1.0, 0.3, 0.0 });
  shape.minimum.assign(shape.maximum.size(), glm::normalize(glm::dvec3(-0.3, 1.0, 0.0)));
  for (std::size_t i = 0; i < shape.maximum.size(); ++i)
  {
    const std::uint64_t random = hash(3, i);
    if (random & 1)
    {
      std::swap(shape.maximum[i], shape.minimum[i]);
    }
    shape.maximum[i] *= random & 2 ? -1.0 : 1.0;
    shape.minimum[i] *= random & 4 ? -1.0 : 1.0;
  }
  const MeshNavigation navigation(shape.mesh.view(), 180.0);
  const LineField field{ shape.maximum, shape.minimum, {} };
  const glm::dvec3 heading = glm::normalize(glm::dvec3(1.0, 0.3, 0.0));
  const TracedLine line =
    StreamlineTracer(navigation, field, {}).trace({ 90, { 0.3, 0.3, 0.4 } }, heading, {});
  EXPECT_EQ(line.ends[0], LineEnd::Border);
  for (const TracedPoint& point : line.points)
  {
    const glm::dvec3 offset = point.position - line.points.front().position;
    EXPECT_LT(glm::length(offset - glm::dot(offset, heading) * heading), 1e-9);
  }
}

TEST(StreamlineTracer, EndsOnBrokenMeshes)
{
  // Random triangles over few points with random directions: nothing but finite points, and an end.
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    Shape shape;
    for (std::uint64_t i = 0; i < 12; ++i)
    {
      const auto coordinate = [&](std::uint64_t n)
      { return std::floor(4.0 * unitDouble(hash(seed, i, n))) / 4.0; };
      shape.mesh.points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
      const glm::dvec3 v(unitDouble(hash(seed, i, 3)) - 0.5, unitDouble(hash(seed, i, 4)) - 0.5,
        unitDouble(hash(seed, i, 5)) - 0.5);
      shape.maximum.push_back(hash(seed, i, 6) % 8 == 0 ? glm::dvec3(0.0) : glm::normalize(v));
    }
    for (std::uint64_t t = 0; t < 30; ++t)
    {
      const auto corner = [&](std::uint64_t n)
      { return static_cast<std::uint32_t>(hash(seed, 100 + t, n) % 12); };
      shape.mesh.triangles.push_back({ corner(0), corner(1), corner(2) });
    }
    TraceOptions options;
    options.maximumLength = 100.0;
    options.stopAtSingularities = seed % 2 == 0;
    for (std::uint32_t t = 0; t < 30; ++t)
    {
      const TracedLine line = traceOn(shape, { t, { 0.2, 0.5, 0.3 } }, options);
      for (const TracedPoint& point : line.points)
      {
        ASSERT_TRUE(std::isfinite(glm::dot(point.position, point.position)))
          << "mesh " << seed << " triangle " << t;
      }
    }
  }
}
