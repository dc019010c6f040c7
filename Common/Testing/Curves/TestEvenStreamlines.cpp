// SPDX-License-Identifier: BSD-3-Clause
// Evenly spaced lines: their distances, each prefix, both sides of a wall, threads, meshes without a line.

#include "Curves/Streamlines/EvenStreamlines.h"

#include "HashNoise.h"
#include "LineEvenness.h"
#include "StreamlineShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// The mean of the faces' normals around each point.
std::vector<glm::vec3> meanNormals(const Mesh& mesh)
{
  std::vector<glm::dvec3> sums(mesh.points.size(), glm::dvec3(0.0));
  for (const Triangle& triangle : mesh.triangles)
  {
    const glm::dvec3& origin = mesh.points[triangle[0]];
    for (const std::uint32_t point : triangle)
    {
      sums[point] += glm::cross(mesh.points[triangle[1]] - origin, mesh.points[triangle[2]] - origin);
    }
  }
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& sum : sums)
  {
    normals.emplace_back(glm::normalize(sum));
  }
  return normals;
}

EvenStreamlineOptions spaced(double spacing)
{
  EvenStreamlineOptions options;
  options.spacing = spacing;
  return options;
}

Streamlines linesOf(const Shape& shape, bool maximum, const EvenStreamlineOptions& options)
{
  const MeshNavigation navigation(shape.mesh.view(), 180.0);
  return evenStreamlines(navigation, shape.normals, fieldOf(shape, maximum), options);
}

/// The unit square, with directions along x but for a turn.
Shape field(int cells, double turn = 0.0)
{
  Shape shape{ square(cells), {}, {}, {} };
  for (const glm::dvec3& p : shape.mesh.points)
  {
    const double angle = turn * p.y;
    shape.normals.emplace_back(0.0f, 0.0f, 1.0f);
    shape.maximum.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    shape.minimum.emplace_back(-std::sin(angle), std::cos(angle), 0.0);
  }
  return shape;
}

} // namespace

TEST(EvenStreamlines, ParallelLinesHaveTheirSpacing)
{
  const Shape shape = field(20);
  const Streamlines lines = linesOf(shape, true, spaced(0.03));
  const Evenness all = evenness(shape, lines, lines.lines.size());
  EXPECT_EQ(lines.lines.size(), 33u);
  EXPECT_NEAR(all.mean, 0.25, 0.01); // exactly .25 between lines at equal distances
  EXPECT_GT(all.closest, 0.9 * 0.03);
  for (std::size_t n = 0; n < lines.lines.size(); ++n)
  {
    EXPECT_NEAR(lines.arcLength[lines.lines.offsets[n + 1] - 1], 1.0, 1e-9) << n; // from border to border
  }
}

TEST(EvenStreamlines, NormalsInTheSurfaceDoNotCrowdLines)
{
  // By them, lines beside each other would be above each other.
  Shape shape = field(20);
  const std::size_t lines = linesOf(shape, true, spaced(0.03)).lines.size();
  std::fill(shape.normals.begin(), shape.normals.end(), glm::vec3(0.0f, 1.0f, 0.0f));
  EXPECT_EQ(linesOf(shape, true, spaced(0.03)).lines.size(), lines);
}

TEST(EvenStreamlines, EachPrefixIsEven)
{
  struct Scene
  {
    std::string name;
    Shape shape;
    bool maximum;
    double spacing;
  };
  const Scene scenes[] = { { "turning directions on a square", field(20, 1.5), true, 0.025 },
    { "torus, maximum", TorusShape().sample(60, 20), true, 0.12 },
    { "torus, minimum", TorusShape().sample(60, 20), false, 0.12 },
    { "ellipsoid, maximum", EllipsoidShape().sample(60, 31), true, 0.12 } };
  for (const auto& [name, shape, maximum, spacing] : scenes)
  {
    const Streamlines lines = linesOf(shape, maximum, spaced(spacing));
    ASSERT_TRUE(std::is_sorted(lines.priorities.begin(), lines.priorities.end()));
    ASSERT_EQ(lines.priorities.front(), 0.0f);
    ASSERT_LT(lines.priorities.back(), 1.0f);
    for (const double share : { 0.1, 0.25, 0.5, 0.75, 1.0 })
    {
      const auto end = std::lower_bound(lines.priorities.begin(), lines.priorities.end(), share);
      const auto count = static_cast<std::size_t>(end - lines.priorities.begin());
      const Evenness even = evenness(shape, lines, count);
      const std::string where = name + ", up to " + std::to_string(share);
      // Equal distances would have a mean of .25 and a largest one of .5 and more where lines end; the first
      // tenth are half a dozen lines.
      EXPECT_LT(even.mean, share < 0.2 ? 0.38 : 0.33) << where;
      EXPECT_LT(even.farthest, 1.35) << where;
      EXPECT_GT(even.closest, 0.46 * spacing) << where;
      // Priority is the share of ink, but for one line.
      EXPECT_NEAR(lengthOf(lines, count) / lengthOf(lines, lines.lines.size()), share, 0.08) << where;
    }
    const double density = evenness(shape, lines, lines.lines.size()).spacing / spacing;
    EXPECT_GT(density, 0.85) << name;
    EXPECT_LT(density, 1.05) << name;
  }
}

TEST(EvenStreamlines, SidesOfAThinWallDoNotDisturbEachOther)
{
  constexpr double spacing = 0.05;
  const Shape sheet = field(20);
  Shape wall = sheet;
  const auto half = static_cast<std::uint32_t>(sheet.mesh.points.size());
  for (std::uint32_t i = 0; i < half; ++i)
  {
    wall.mesh.points.push_back(sheet.mesh.points[i] - glm::dvec3(0.0, 0.0, 0.1 * spacing));
    wall.normals.push_back(-sheet.normals[i]);
    wall.maximum.push_back(sheet.maximum[i]);
    wall.minimum.push_back(sheet.minimum[i]);
  }
  for (const auto& [a, b, c] : sheet.mesh.triangles)
  {
    wall.mesh.triangles.push_back({ a + half, c + half, b + half });
  }
  const Streamlines both = linesOf(wall, true, spaced(spacing));
  double front = 0.0;
  double back = 0.0;
  for (std::size_t n = 0; n < both.lines.size(); ++n)
  {
    const std::size_t begin = both.lines.offsets[n];
    (both.positions[begin].z < -1e-6 ? back : front) += both.arcLength[both.lines.offsets[n + 1] - 1];
  }
  // The borders leave room for 18 to 21 lines on each side; disturbed, both together would have that many.
  EXPECT_NEAR(front, 19.5, 1.6);
  EXPECT_NEAR(back, 19.5, 1.6);
}

TEST(EvenStreamlines, LinesOfATorusAreClosed)
{
  const Shape shape = TorusShape().sample(150, 50);
  const Streamlines lines = linesOf(shape, true, spaced(0.1));
  const auto whole = std::count(lines.lines.closed.begin(), lines.lines.closed.end(), 1);
  // At least those of the first spacings, before what is between them is too narrow on the inside.
  EXPECT_GT(whole, 40);
}

TEST(EvenStreamlines, LinesOfANoisyTorusAreEven)
{
  // Noise of 1.4 and 2.9 % of the tube's radius, between points that are a sixteenth of it apart: a tenth and
  // a third of the edges bend by more than 45 degrees. With lines ended there, they were up to 2.9 times as
  // far apart.
  constexpr double spacing = 0.1;
  const TorusShape torus;
  const Shape clean = torus.sample(300, 100);
  for (const double noise : { 0.01, 0.02 })
  {
    Shape rough = clean;
    for (std::size_t i = 0; i < rough.normals.size(); ++i)
    {
      rough.mesh.points[i] += noise * ink::testing::hashNormal(7, i) * glm::dvec3(clean.normals[i]);
    }
    rough.normals = meanNormals(rough.mesh);
    MeshNavigation navigation(rough.mesh.view(), 180.0);
    navigation.cutFeatures(45.0, 2.0 * spacing);
    Streamlines lines = evenStreamlines(navigation, rough.normals, fieldOf(rough), spaced(spacing));
    // As they would be seen: without the noise.
    for (std::size_t n = 0; n < lines.lines.size(); ++n)
    {
      double arc = 0.0;
      for (std::size_t i = lines.lines.offsets[n]; i < lines.lines.offsets[n + 1]; ++i)
      {
        lines.positions[i] = torus.onto(lines.positions[i]);
        arc += i > lines.lines.offsets[n] ? glm::distance(lines.positions[i], lines.positions[i - 1]) : 0.0;
        lines.arcLength[i] = arc;
      }
    }
    const Evenness even = evenness(clean, lines, lines.lines.size());
    EXPECT_NEAR(even.spacing / spacing, 1.0, noise < 0.015 ? 0.1 : 0.25) << noise; // .99, 1.15
    EXPECT_LT(even.mean, 0.3) << noise;                                            // .26
    EXPECT_LT(even.farthest, 1.2) << noise;                                        // .9, 1.1
  }
}

TEST(EvenStreamlines, OptionsAreLimits)
{
  const Shape shape = field(20);
  EvenStreamlineOptions options = spaced(0.05);
  options.trace.maximumLength = 0.2;
  const Streamlines shorter = linesOf(shape, true, options);
  EXPECT_GT(shorter.lines.size(), 80u);
  for (std::size_t n = 0; n < shorter.lines.size(); ++n)
  {
    const double length = shorter.arcLength[shorter.lines.offsets[n + 1] - 1];
    EXPECT_LT(length, 0.2 + 1e-9);
    EXPECT_GE(length, options.minimumLength * options.spacing);
  }
  options = spaced(0.05);
  options.seed = 1;
  EXPECT_FALSE(areSame(linesOf(shape, true, spaced(0.05)), linesOf(shape, true, options)));
}

TEST(EvenStreamlines, AMeshWithoutLinesHasNone)
{
  Shape shape = field(4);
  shape.maximum.assign(shape.maximum.size(), glm::dvec3(0.0)); // a plane: nothing tells directions
  EXPECT_EQ(linesOf(shape, true, spaced(0.1)).lines.size(), 0u);

  EXPECT_EQ(linesOf(Shape(), true, spaced(0.1)).lines.size(), 0u);

  Shape flat = field(4);
  for (glm::dvec3& p : flat.mesh.points)
  {
    p.y = 0.0; // no area
  }
  EXPECT_EQ(linesOf(flat, true, spaced(0.1)).lines.size(), 0u);
}

TEST(EvenStreamlines, BrokenPartsOfAMeshAreLeftOut)
{
  Shape shape = field(20);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  shape.mesh.points[100] = glm::dvec3(nan, 0.0, 0.0);
  shape.mesh.points[250] = shape.mesh.points[251];
  shape.maximum[130] = glm::dvec3(0.0);
  shape.mesh.triangles.push_back({ 5, 5, 5 });
  shape.mesh.triangles.push_back(shape.mesh.triangles[30]); // an edge of three triangles
  const Streamlines lines = linesOf(shape, true, spaced(0.05));
  EXPECT_GT(lengthOf(lines, lines.lines.size()), 12.0);
  for (const glm::dvec3& p : lines.positions)
  {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

TEST(EvenStreamlines, WhatIsWrongIsNamed)
{
  const Shape shape = field(4);
  const auto message = [&](const EvenStreamlineOptions& options, std::size_t directions)
  {
    const MeshNavigation navigation(shape.mesh.view(), 180.0);
    try
    {
      evenStreamlines(
        navigation, shape.normals, { std::span(shape.maximum).first(directions), {}, {} }, options);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::size_t all = shape.maximum.size();
  EXPECT_EQ(message(spaced(0.1), all), "");
  EXPECT_NE(message(spaced(0.1), 3).find("3 directions for 25 points"), std::string::npos);
  EXPECT_NE(message(spaced(0.0), all).find("spacing is 0.0"), std::string::npos);
  EXPECT_NE(message(spaced(1e-6), all).find("larger spacing"), std::string::npos);
}

TEST(EvenStreamlines, StopsWhenAsked)
{
  const Shape shape = field(20);
  const MeshNavigation navigation(shape.mesh.view(), 180.0);
  const Streamlines lines = evenStreamlines(
    navigation, shape.normals, fieldOf(shape), spaced(0.01), [](double done) { return done < 0.1; });
  EXPECT_EQ(lines.lines.size(), 0u);
}

TEST(EvenStreamlines, ProgressRisesToTheWhole)
{
  const Shape shape = TorusShape().sample(60, 20);
  const MeshNavigation navigation(shape.mesh.view(), 180.0);
  double last = 0.0;
  int falls = 0;
  evenStreamlines(navigation, shape.normals, fieldOf(shape), spaced(0.1),
    [&](double done)
    {
      falls += done < last ? 1 : 0;
      last = done;
      return true;
    });
  EXPECT_EQ(falls, 0);
  EXPECT_GT(last, 0.9);
  EXPECT_LE(last, 1.0);
}

TEST(EvenStreamlines, TheSameForAnyNumberOfThreads)
{
  const Shape shape = EllipsoidShape().sample(80, 41);
  const auto run = [&] { return linesOf(shape, true, spaced(0.1)); };
  const Streamlines one = onThreads(1, run);
  const Streamlines two = onThreads(2, run);
  EXPECT_GT(one.lines.size(), 50u);
  EXPECT_TRUE(areSame(one, two));
}
