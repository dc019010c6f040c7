// SPDX-License-Identifier: BSD-3-Clause
// Evenly spaced lines of curvature on iso-surfaces of fields, without a mesh: their distances, as on meshes,
// and the known lines of an ellipsoid and a torus.

#include "Curves/Streamlines/EvenFieldStreamlines.h"

#include "AnalyticFields.h"
#include "LineEvenness.h"
#include "MeshesWithCurvature.h"
#include "SampledVolume.h"
#include "StreamlineDeviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

const EllipsoidShape Ellipsoid;
const EllipsoidField EllipsoidValues{ Ellipsoid.axes };

bool anywhere(const glm::dvec3& p)
{
  return std::isfinite(glm::dot(p, p));
}

SurfaceSamples samplesOf(const Shape& shape)
{
  const TriangleMesh mesh = shape.mesh.view();
  const CumulativeArea areas = cumulateArea(mesh);
  return { positionsOf(mesh, sampleWhiteNoise(mesh, areas, 2000, 3)), areas.area.back() };
}

EvenStreamlineOptions spaced(double spacing)
{
  EvenStreamlineOptions options;
  options.spacing = spacing;
  options.trace.umbilicLimit = 0.98;
  return options;
}

FieldStreamlines linesOfEllipsoid(
  bool maximum, const EvenStreamlineOptions& options, const Progress& progress = {})
{
  const FieldSurface surface{ EllipsoidValues, EllipsoidValues, 0.0, anywhere };
  return evenFieldStreamlines(surface, samplesOf(Ellipsoid.sample(60, 31)), maximum, 0.0, options, progress);
}

} // namespace

TEST(EvenFieldStreamlines, EachPrefixIsEvenAsOnMeshes)
{
  constexpr double spacing = 0.12;
  const Shape shape = Ellipsoid.sample(60, 31);
  for (const bool maximum : { true, false })
  {
    const FieldStreamlines lines = linesOfEllipsoid(maximum, spaced(spacing));
    ASSERT_GT(lines.lines.size(), 30u);
    ASSERT_TRUE(std::is_sorted(lines.priorities.begin(), lines.priorities.end()));
    for (const double share : { 0.1, 0.25, 0.5, 0.75, 1.0 })
    {
      const auto end = std::lower_bound(lines.priorities.begin(), lines.priorities.end(), share);
      const auto count = static_cast<std::size_t>(end - lines.priorities.begin());
      const Evenness even = evenness(shape, lines, count);
      // The bounds are those of meshes, but for the surroundings of umbilics, where lines end.
      // Measured: 1.38.
      EXPECT_LT(even.mean, share < 0.2 ? 0.38 : 0.33) << share;
      EXPECT_LT(even.farthest, 1.5) << share;
      EXPECT_GT(even.closest, 0.46 * spacing) << share;
    }
    const double density = evenness(shape, lines, lines.lines.size()).spacing / spacing;
    EXPECT_GT(density, 0.85);
    EXPECT_LT(density, 1.05);
  }
}

TEST(EvenFieldStreamlines, AreTheLinesOfTheEllipsoid)
{
  const FieldStreamlines lines = linesOfEllipsoid(true, spaced(0.12));
  double worst = 0.0;
  int regular = 0;
  for (std::size_t n = 0; n < lines.lines.size(); ++n)
  {
    TracedLine line;
    for (std::size_t i = lines.lines.offsets[n]; i < lines.lines.offsets[n + 1]; ++i)
    {
      ASSERT_NEAR(EllipsoidValues.value(lines.positions[i]), 0.0, 1e-4);
      ASSERT_NEAR(
        glm::dot(lines.points[i].normal, glm::normalize(EllipsoidValues.gradient(lines.positions[i]))), -1.0,
        1e-9);
      line.points.push_back({ {}, lines.positions[i], 0.0 });
    }
    if (isRegular(Ellipsoid, line, true))
    {
      ++regular;
      for (const TracedPoint& point : line.points)
      {
        worst = std::max(worst, Ellipsoid.deviation(point.position, line.points.front().position, true));
      }
    }
  }
  EXPECT_GT(regular, 10);
  EXPECT_LT(worst, 1e-6); // measured: 2e-8
}

TEST(EvenFieldStreamlines, OfAGrid)
{
  // A torus, denser inside.
  const ink::testing::Torus torus{ 2.0, 0.7 };
  const auto volume = ink::testing::Volume<float>::from(
    GridGeometry({ 60, 60, 20 }, glm::dvec3(-2.95, -2.95, -0.95), glm::dvec3(0.1)),
    [&](const glm::dvec3& p) { return -torus.value(p); });
  const GridField<float> field = volume.field();
  const SurfaceSamples samples = samplesOfGrid(field, 0.0);
  EXPECT_NEAR(samples.area, 4.0 * std::numbers::pi * std::numbers::pi * 2.0 * 0.7, 1.0);
  const FieldStreamlines lines =
    evenFieldStreamlines({ field, field, 0.0, anywhere }, samples, true, 0.0, spaced(0.12));
  const Shape shape = TorusShape().sample(60, 20);
  const Evenness even = evenness(shape, lines, lines.lines.size());
  EXPECT_LT(even.mean, 0.33);
  EXPECT_GT(even.closest, 0.46 * 0.12);
  EXPECT_GT(even.spacing / 0.12, 0.85);
  EXPECT_LT(even.spacing / 0.12, 1.05);
  double worst = 0.0;
  for (std::size_t n = 0; n < lines.lines.size(); ++n)
  {
    const glm::dvec3 first = lines.positions[lines.lines.offsets[n]];
    for (std::size_t i = lines.lines.offsets[n]; i < lines.lines.offsets[n + 1]; ++i)
    {
      worst = std::max(worst, TorusShape().deviation(lines.positions[i], first, true));
    }
  }
  EXPECT_LT(worst, 2e-3); // measured: 4.8e-4
}

TEST(EvenFieldStreamlines, TheSameForAnyNumberOfThreads)
{
  const auto run = [] { return linesOfEllipsoid(true, spaced(0.2)); };
  const FieldStreamlines one = onThreads(1, run);
  EXPECT_GT(one.lines.size(), 20u);
  EXPECT_TRUE(areSame(one, onThreads(2, run)));
}

TEST(EvenFieldStreamlines, WithoutASurfaceOrADirectionThereAreNone)
{
  const FieldSurface surface{ EllipsoidValues, EllipsoidValues, 0.0, anywhere };
  EXPECT_EQ(evenFieldStreamlines(surface, {}, true, 0.0, spaced(0.1)).lines.size(), 0u);
  const ink::testing::Sphere sphere{ glm::dvec3(0.0), 1.0 };
  const SurfaceSamples samples{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 0.0 } }, 4.0 };
  EXPECT_EQ(
    evenFieldStreamlines({ sphere, sphere, 0.0, anywhere }, samples, true, 0.0, spaced(0.1)).lines.size(),
    0u);
  EXPECT_THROW(linesOfEllipsoid(true, spaced(0.0)), std::invalid_argument);
  EXPECT_EQ(linesOfEllipsoid(true, spaced(0.1), [](double done) { return done < 0.1; }).lines.size(), 0u);
}
