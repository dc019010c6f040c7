// SPDX-License-Identifier: BSD-3-Clause
// The paper's seeds: as many as asked for, inside triangles, more where the surface is curved.

#include "Curves/Streamlines/ScatteredStreamlines.h"

#include "StreamlineShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// A square of small triangles left of x = .5 and large ones right of it.
Mesh unevenSquare()
{
  Mesh mesh;
  mesh.addPatch(40, 80, [](double u, double v) { return glm::dvec3(0.5 * u, v, 0.0); });
  mesh.addPatch(4, 8, [](double u, double v) { return glm::dvec3(0.5 + 0.5 * u, v, 0.0); });
  return mesh;
}

} // namespace

TEST(ScatteredStreamlines, SeedsAreByArea)
{
  const Mesh mesh = unevenSquare();
  const MeshNavigation navigation(mesh.view(), 180.0);
  AreaSeedOptions options;
  options.count = 4000.0;
  options.mostInTriangle = 1000;
  const std::vector<MeshPoint> seeds = areaSeeds(navigation, options);
  // The standard deviation of the number is below its root, 63.
  EXPECT_NEAR(static_cast<double>(seeds.size()), 4000.0, 200.0);
  double left = 0.0;
  glm::dvec3 mean(0.0);
  for (const MeshPoint& seed : seeds)
  {
    EXPECT_GE(std::min({ seed.weights.x, seed.weights.y, seed.weights.z }), 0.0);
    EXPECT_NEAR(seed.weights.x + seed.weights.y + seed.weights.z, 1.0, 1e-12);
    left += navigation.position(seed).x < 0.5 ? 1.0 : 0.0;
    mean += seed.weights / static_cast<double>(seeds.size());
  }
  EXPECT_NEAR(left, 2000.0, 150.0);
  EXPECT_NEAR(mean.x, 1.0 / 3.0, 0.015); // folded, not clamped: no corner is favored
  EXPECT_NEAR(mean.y, 1.0 / 3.0, 0.015);

  // No triangle gets more than m: of the 64 large ones.
  options.mostInTriangle = 3;
  const std::vector<MeshPoint> few = areaSeeds(navigation, options);
  std::vector<int> counts(mesh.triangles.size());
  for (const MeshPoint& seed : few)
  {
    ++counts[seed.triangle];
  }
  EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 3);
}

/// Section 3.1 prints that a point falls into a triangle where r > A_i / A n / m, which makes points of
/// almost all tries, and coordinates that leave the triangle in half of the cases.
TEST(ScatteredStreamlines, AsPrintedSeedsAreTooManyAndOutside)
{
  const Mesh mesh = unevenSquare();
  const MeshNavigation navigation(mesh.view(), 180.0);
  AreaSeedOptions options;
  options.count = 4000.0;
  options.mostInTriangle = 10;
  double printed = 0.0;
  double right = 0.0;
  double outside = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const double share = areaOf(mesh.view(), t) / navigation.area() * options.count / options.mostInTriangle;
    for (std::uint64_t i = 0; i < 10; ++i)
    {
      const double r = unitDouble(hash(1, t, i));
      printed += r > share ? 1.0 : 0.0;
      right += r < share ? 1.0 : 0.0;
      outside += unitDouble(hash(2, t, i)) + unitDouble(hash(3, t, i)) > 1.0 ? 1.0 : 0.0;
    }
  }
  const double tries = 10.0 * static_cast<double>(mesh.triangles.size());
  EXPECT_GT(printed, 0.9 * tries);
  EXPECT_NEAR(outside / tries, 0.5, 0.02);
  // No more than m fall into the large ones, so that fewer than n points do.
  const std::vector<MeshPoint> seeds = areaSeeds(navigation, options);
  EXPECT_NEAR(static_cast<double>(seeds.size()), right, 200.0);
  EXPECT_LT(static_cast<double>(seeds.size()), options.count);
  for (const MeshPoint& seed : seeds)
  {
    ASSERT_GE(std::min({ seed.weights.x, seed.weights.y, seed.weights.z }), 0.0);
  }
}

TEST(ScatteredStreamlines, SeedsAreDenserWhereTheSurfaceIsCurved)
{
  const Mesh mesh = square(40);
  const MeshNavigation navigation(mesh.view(), 180.0);
  std::vector<float> curvature;
  for (const glm::dvec3& p : mesh.points)
  {
    curvature.push_back(p.x < 0.5 ? 2.0f : 0.5f);
  }
  AreaSeedOptions options;
  options.count = 2000.0;
  options.curvature = curvature;
  options.threshold = 1.0;
  options.factor = 3.0;
  double left = 0.0;
  const std::vector<MeshPoint> seeds = areaSeeds(navigation, options);
  for (const MeshPoint& seed : seeds)
  {
    left += navigation.position(seed).x < 0.5 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(left, 3000.0, 200.0);
  EXPECT_NEAR(static_cast<double>(seeds.size()) - left, 1000.0, 150.0);
  options.curvature = std::span(curvature).first(3);
  EXPECT_THROW(areaSeeds(navigation, options), std::invalid_argument);
}

TEST(ScatteredStreamlines, LinesAreThoseOfTheirSeeds)
{
  const TorusShape torus;
  const Shape shape = torus.sample(90, 30);
  const MeshNavigation navigation(shape.mesh.view(), 180.0);
  const LineField field = fieldOf(shape);
  TraceOptions trace;
  trace.maximumLength = 0.6;
  AreaSeedOptions options;
  options.count = 500.0;
  const auto make = [&] { return areaSeeds(navigation, options); };
  const std::vector<MeshPoint> seeds = onThreads(1, make);
  const std::vector<MeshPoint> again = onThreads(2, make);
  ASSERT_EQ(again.size(), seeds.size());
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    ASSERT_EQ(again[i].triangle, seeds[i].triangle);
    ASSERT_EQ(again[i].weights, seeds[i].weights);
  }
  double told = 0.0;
  areaSeeds(navigation, options,
    [&](double share)
    {
      EXPECT_GE(share, told);
      told = share;
      return true;
    });
  EXPECT_GT(told, 0.0);
  EXPECT_TRUE(areaSeeds(navigation, options, [](double) { return false; }).empty());
  const auto run = [&] { return scatteredStreamlines(navigation, field, seeds, trace, 3); };
  const Streamlines lines = onThreads(1, run);
  EXPECT_EQ(lines.lines.size(), seeds.size());
  EXPECT_EQ(lines.positions, onThreads(2, run).positions);
  for (std::size_t n = 0; n < lines.lines.size(); ++n)
  {
    EXPECT_NEAR(lines.arcLength[lines.lines.offsets[n + 1] - 1], 0.6, 1e-6);
    // All lines are equally long, so their order says their priority.
    EXPECT_NEAR(static_cast<double>(lines.priorities[n]),
      static_cast<double>(n) / static_cast<double>(lines.lines.size()), 1e-4);
  }
  EXPECT_NE(scatteredStreamlines(navigation, field, seeds, trace, 4).positions, lines.positions);
}
