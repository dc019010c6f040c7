// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticFields.h"
#include "HashNoise.h"
#include "SampledVolume.h"

#include "Fields/Projection.h"
#include "IsoSurface/ProjectSamples.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::GridGeometry;
using ink::Projection;
const double nan = std::numeric_limits<double>::quiet_NaN();

/// No farther than `reach` from where it started.
template <ink::Field F>
Projection project(const F& field, const glm::dvec3& start, int steps, double isoValue = 0.0,
  double tolerance = 1e-9, double reach = 1.0)
{
  return ink::projectToIsoSurface(field, isoValue, start, steps, tolerance,
    [&](const glm::dvec3& p) { return glm::distance(p, start) <= reach; });
}

/// Another field times a factor; its gradient times one more.
template <class F>
struct Scaled
{
  F field;
  double factor;
  double gradientFactor = 1.0;

  double value(const glm::dvec3& p) const { return this->factor * this->field.value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const
  {
    return this->gradientFactor * this->factor * this->field.gradient(p);
  }
  glm::dmat3 hessian(const glm::dvec3& p) const { return this->factor * this->field.hessian(p); }
};

/// The squared distance from the origin, of which a Newton step is no exact one.
struct Paraboloid
{
  double value(const glm::dvec3& p) const { return glm::dot(p, p); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return 2.0 * p; }
  glm::dmat3 hessian(const glm::dvec3&) const { return glm::dmat3(2.0); }
};

/// The plane x = 0, not defined beyond it.
struct HalfSpace
{
  double value(const glm::dvec3& p) const { return p.x <= 0.0 ? p.x : nan; }
  glm::dvec3 gradient(const glm::dvec3& p) const { return glm::dvec3(p.x <= 0.0 ? 0.6 : nan, 0.0, 0.0); }
  glm::dmat3 hessian(const glm::dvec3&) const { return glm::dmat3(0.0); }
};

/// The plane x = 0 with a slope that falls on either side: from afar, Newton's method alone diverges.
struct ArcTangent
{
  double value(const glm::dvec3& p) const { return std::atan(p.x); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return glm::dvec3(1.0 / (1.0 + p.x * p.x), 0.0, 0.0); }
  glm::dmat3 hessian(const glm::dvec3&) const { return glm::dmat3(0.0); }
};

const Sphere Ball{ { 1.0, -2.0, 3.0 }, 5.0 };
const Torus Ring{ 4.0, 2.0 };

template <class F>
void expectOnSurface(const F& field, double distanceFactor)
{
  std::mt19937 random(7);
  const auto number = [&] { return random() % 2048 / 1024.0 - 1.0; };
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 p = 8.0 * glm::dvec3(number(), number(), number() + 1e-3);
    const double distance = distanceFactor * field.value(p);
    const Projection end = project(field, p, 1);
    SCOPED_TRACE(std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z));
    if (std::abs(distance) < 0.99)
    {
      EXPECT_TRUE(end.converged);
      EXPECT_NEAR(distanceFactor * field.value(end.position), 0.0, 1e-12);
      EXPECT_NEAR(glm::distance(end.position, p), std::abs(distance), 1e-12);
    }
    else if (std::abs(distance) > 1.01)
    {
      EXPECT_FALSE(end.converged);
      EXPECT_EQ(end.position, p);
    }
  }
}

TEST(Projection, FindsTheNearestPointOfAnalyticShapes)
{
  expectOnSurface(Ball, 1.0);
  expectOnSurface(Ring, 1.0);
}

TEST(Projection, KnowsNoUnit)
{
  // Squares of these gradients are no doubles.
  expectOnSurface(Scaled<Torus>{ Ring, 1e200 }, 1e-200);
  expectOnSurface(Scaled<Torus>{ Ring, -1e-200 }, -1e200);
}

TEST(Projection, ConvergesQuadratically)
{
  const glm::dvec3 start(0.3, -0.5, 0.6);
  double before = std::abs(glm::length(start) - 1.0);
  for (int steps = 1; steps <= 3; ++steps)
  {
    const Projection end = project(Paraboloid{}, start, steps, 1.0, 1e-6);
    const double distance = std::abs(glm::length(end.position) - 1.0);
    EXPECT_LT(distance, before * before);
    EXPECT_EQ(end.converged, distance < 1e-6) << steps << " steps";
    before = distance;
  }
  EXPECT_EQ(project(Paraboloid{}, start, 0, 1.0).position, start);
}

TEST(Projection, StopsAtTheTolerance)
{
  const glm::dvec3 start(1.0 + 1e-5, 0.0, 0.0);
  const Projection end = project(Paraboloid{}, start, 8, 1.0, 1e-4);
  EXPECT_TRUE(end.converged);
  EXPECT_EQ(end.position, start);
}

TEST(Projection, HalvesStepsThatAreTooLong)
{
  // Two and a half times too long: whole ones would lead farther and farther away.
  const Projection end = project(Scaled<Sphere>{ Ball, 1.0, 0.4 }, { 6.3, -2.0, 3.0 }, 60, 0.0, 1e-9, 2.0);
  EXPECT_TRUE(end.converged);
  EXPECT_NEAR(Ball.value(end.position), 0.0, 1e-9);
  // Halved twice, then whole again: two more are enough.
  EXPECT_TRUE(project(ArcTangent{}, { 3.0, 0.0, 0.0 }, 5, 0.0, 1e-6, 20.0).converged);
  // Almost twice as long as they should be, which leads closer to the surface, but out of reach.
  const Projection near =
    project(Scaled<Sphere>{ Ball, 1.0, 1.0 / 1.9 }, { 6.5, -2.0, 3.0 }, 2, 0.0, 1e-9, 0.8);
  EXPECT_LT(std::abs(Ball.value(near.position)), 0.03);
  // Or to where the field is not defined.
  const Projection beside = project(HalfSpace{}, { -0.5, 0.0, 0.0 }, 60);
  EXPECT_TRUE(beside.converged);
  EXPECT_NEAR(beside.position.x, 0.0, 1e-9);
}

TEST(Projection, StaysWhereNothingLeadsToASurface)
{
  const glm::dvec3 start(-0.5, 0.25, 0.0);
  const auto expectStart = [&](const Projection& end, const char* what)
  {
    EXPECT_EQ(end.position, start) << what;
    EXPECT_FALSE(end.converged) << what;
  };
  expectStart(project(HalfSpace{}, start, 8, nan), "no iso-value");
  expectStart(project(HalfSpace{}, start, 8, 1.5), "farther away than it may go");
  expectStart(project(Scaled<Sphere>{ Ball, 0.0 }, start, 8, 1.0), "a constant field");
  expectStart(project(Scaled<Sphere>{ Ball, nan }, start, 8), "a field of NaN");
  const glm::dvec3 center = Ball.center;
  EXPECT_EQ(project(Ball, center, 8, 0.0, 1e-9, 100.0).position, center);
  EXPECT_FALSE(project(Ball, glm::dvec3(nan), 8).converged);
}

/// The distances of points from the surface in shortest edges, by the field's own value and slope.
struct Distances
{
  double mean = 0.0;
  double greatest = 0.0;
};

template <class T, class Real>
Distances distancesOf(const ink::GridField<T>& field, double isoValue, const std::vector<Real>& points)
{
  const glm::dvec3 edges = glm::abs(field.geometry().spacing());
  Distances distances;
  for (std::size_t n = 0; n < points.size(); n += 3)
  {
    const glm::dvec3 p(points[n], points[n + 1], points[n + 2]);
    const double distance = std::abs(field.value(p) - isoValue) / glm::length(field.gradient(p)) /
      std::min({ edges.x, edges.y, edges.z });
    distances.mean += 3.0 * distance / static_cast<double>(points.size());
    distances.greatest = std::max(distances.greatest, distance);
  }
  return distances;
}

/// The greatest distances that may be left after 0, 1, 2 and 3 steps.
using Bounds = std::array<double, 4>;

template <class T, class Real, class Function>
void expectWithin(const Bounds& bounds, const GridGeometry& grid, double isoValue, const Function& function)
{
  const auto volume = Volume<T>::from(grid, function);
  const auto samples = sampleIsoSurface<Real>(volume.field(), isoValue);
  ASSERT_GT(samples.size(), 1000u);
  double mean = distancesOf(volume.field(), isoValue, samples.coordinates).mean;
  for (int steps = 0; steps <= 3; ++steps)
  {
    SCOPED_TRACE(std::to_string(steps) + " steps");
    auto points = samples.coordinates;
    ASSERT_TRUE(ink::projectSamples(volume.field(), grid, isoValue, steps, std::span<Real>(points)));
    const Distances left = distancesOf(volume.field(), isoValue, points);
    const double bound = bounds[static_cast<std::size_t>(steps)];
    EXPECT_LT(left.greatest, bound);
    EXPECT_GT(left.greatest, 0.2 * bound) << "a bound that says little";
    EXPECT_TRUE(steps == 0 || left.mean < 0.7 * mean || left.greatest <= ink::ProjectionTolerance);
    EXPECT_EQ(points == samples.coordinates, steps == 0);
    mean = left.mean;
  }
}

double blurred(double distance)
{
  return 0.5 * std::erfc(distance / std::sqrt(2.0));
}

TEST(ProjectSamples, EachStepLeavesATenth)
{
  const GridGeometry grid({ 48, 48, 48 }, glm::dvec3(-23.5));
  const Sphere sphere{ { 0.1, 0.2, 0.3 }, 10.0 };
  const Torus torus{ 14.0, 6.0 };
  const auto step = [&](const glm::dvec3& p) { return 200.0 * blurred(torus.distance(p)); };
  const Bounds ofDistances{ 2e-2, 4e-4, 1.1e-4, 1.1e-4 };
  const Bounds ofScans{ 3e-2, 3e-3, 4e-4, 1.1e-4 };
  expectWithin<float, double>(ofDistances, grid, 0.0, [&](const auto& p) { return sphere.distance(p); });
  expectWithin<float, float>(ofDistances, grid, 0.0, [&](const auto& p) { return torus.distance(p); });
  expectWithin<float, double>(ofScans, grid, 100.0, step);
  expectWithin<double, double>(ofScans, grid, 100.0, step);
  expectWithin<short, double>(ofScans, grid, 2000.5, [&](const auto& p) { return 20.0 * step(p); });
  expectWithin<std::uint8_t, float>(ofScans, grid, 100.5, step);
  const GridGeometry uneven({ 48, 48, 16 }, { -23.5, -23.5, -22.5 }, { 1.0, 1.0, 3.0 });
  expectWithin<float, double>({ 1e-1, 3e-2, 1e-2, 5e-3 }, uneven, 100.0, step);
}

TEST(ProjectSamples, PiecesAndThreadsAgreeToTheBit)
{
  const glm::dvec3 spacing(0.3, 0.7, -0.4);
  // Noise, of which some points leave their cells.
  std::uint64_t index = 0;
  const auto function = [&index](const glm::dvec3&) { return hashNormal(1, index++); };
  const GridGeometry grid({ 30, 20, 25 }, { 5.0, 1.0, 2.0 }, spacing, glm::dmat3(1.0), { -7, 3, 100 });
  const auto volume = Volume<float>::from(grid, function);
  auto points = sampleIsoSurface<double>(volume.field(), 0.25).coordinates;
  const auto before = points;
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  ink::projectSamples(volume.field(), grid, 0.25, 8, std::span<double>(points));
  auto again = before;
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  ink::projectSamples(volume.field(), grid, 0.25, 8, std::span<double>(again));
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(again, points);

  // Two cells around a sample's own, and one more voxel behind them, are all that it depends on.
  int others = 0;
  for (std::size_t n = 0; n < points.size(); n += 3)
  {
    const glm::dvec3 start(before[n], before[n + 1], before[n + 2]);
    const glm::ivec3 cell(glm::floor(grid.toGlobalIndex(start)));
    const glm::ivec3 low = glm::max(cell - 2, grid.first());
    const glm::ivec3 high = glm::min(cell + 3, grid.first() + grid.dimensions() - 1);
    Volume<float> piece(GridGeometry(high - low + 1, grid.origin(), spacing, grid.direction(), low));
    for (std::size_t i = 0; i < piece.values.size(); ++i)
    {
      const glm::ivec3 size = high - low + 1;
      const int at = static_cast<int>(i);
      const glm::ivec3 sample(at % size.x, at / size.x % size.y, at / (size.x * size.y));
      piece.values[i] = volume.values[grid.offset(low - grid.first() + sample)];
    }
    std::vector<double> one(&before[n], &before[n] + 3);
    ink::projectSamples(piece.field(), piece.geometry, 0.25, 8, std::span<double>(one));
    others += !std::equal(one.begin(), one.end(), &points[n]);
  }
  EXPECT_EQ(others, 0) << "of " << points.size() / 3;
}

TEST(ProjectSamples, MovesNothingFarOrWithoutASlope)
{
  const GridGeometry grid({ 12, 12, 12 }, glm::dvec3(0.0), { 1.0, 1.0, 1000.0 });
  const auto plane = Volume<float>::from(grid, [](const glm::dvec3& p) { return p.x; });
  const std::vector<double> start{ 3.5, 4.0, 2000.0, nan, 0.0, 0.0, 5.05, 4.0, 2000.0 };
  auto points = start;
  ASSERT_TRUE(ink::projectSamples(plane.field(), grid, 5.0, 8, std::span<double>(points)));
  // A cell and a half away: less than a cell's diagonal, but more than its edge in this direction.
  EXPECT_EQ(points[0], start[0]);
  EXPECT_TRUE(std::isnan(points[3]));
  // And a twentieth of its shortest edge, far more than the tolerance.
  EXPECT_NEAR(points[6], 5.0, 1e-4);
  // Every central difference of a checkerboard vanishes.
  const auto board = Volume<std::uint8_t>::from(
    grid, [](const glm::dvec3& p) { return (static_cast<int>(p.x + p.y + p.z / 1000.0) & 1) * 255; });
  const auto samples = sampleIsoSurface<double>(board.field(), 100.0);
  points = samples.coordinates;
  ink::projectSamples(board.field(), grid, 100.0, 8, std::span<double>(points));
  int moved = 0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 index = grid.toIndex(samples.point(n));
    const bool inside =
      glm::all(glm::greaterThan(index, glm::dvec3(1.0))) && glm::all(glm::lessThan(index, glm::dvec3(10.0)));
    moved += inside && !std::equal(&points[3 * n], &points[3 * n] + 3, &samples.coordinates[3 * n]);
  }
  EXPECT_EQ(moved, 0);
}

TEST(ProjectSamples, RejectsAndStops)
{
  const GridGeometry grid({ 12, 12, 12 });
  const auto plane = Volume<float>::from(grid, [](const glm::dvec3& p) { return p.x; });
  std::vector<float> points(4);
  EXPECT_THROW(
    ink::projectSamples(plane.field(), grid, 5.0, 1, std::span<float>(points)), std::invalid_argument);
  points.resize(300000, 5.0f);
  EXPECT_FALSE(
    ink::projectSamples(plane.field(), grid, 5.0, 1, std::span<float>(points), [](double) { return false; }));
}

} // namespace
