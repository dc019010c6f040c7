// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/CoveringRadius.h"
#include "PointSampling/PoissonDisk.h"
#include "PointSampling/PoissonDiskCount.h"
#include "PointSampling/WhiteNoise.h"
#include "PowerSpectrum.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace
{

using namespace ink::test;

ink::PoissonDisk sample(
  const Mesh& mesh, double radius, std::uint64_t seed = 1, double gap = ink::defaultCoverageSlack)
{
  return ink::samplePoissonDisk(mesh.view(), ink::cumulateArea(mesh.view()), radius, gap, seed);
}

/// Random positions on the mesh, many more than samples.
std::vector<glm::dvec3> probes(const Mesh& mesh, std::size_t count)
{
  return positionsOf(
    mesh.view(), ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), count, 77));
}

double areaOf(const Mesh& mesh)
{
  return ink::cumulateArea(mesh.view()).area.back();
}

void append(Mesh& mesh, const Mesh& other)
{
  const auto count = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles)
  {
    mesh.triangles.push_back({ a + count, b + count, c + count });
  }
}

} // namespace

/// No two too near, no room for another, and as many as a random packing has at its limit.
TEST(PoissonDisk, IsSaturatedInThePlane)
{
  for (const int cells : { 1, 70 })
  {
    const Mesh mesh = square(cells);
    const double radius = 0.02;
    const auto samples = sample(mesh, radius).samples;
    const auto points = positionsOf(mesh.view(), samples);
    EXPECT_GE(leastDistance(points, points.size()), radius * (1.0 - 1e-5)) << cells;
    EXPECT_LE(largestGap(probes(mesh, 20000), points, points.size()),
      ink::poissonDiskCover(radius, ink::defaultCoverageSlack))
      << cells;
    // The border adds a little.
    const double ratio = radius / ink::hexagonalDistance(1.0, static_cast<double>(points.size()));
    EXPECT_GT(ratio, 0.76) << cells;
    EXPECT_LT(ratio, 0.82) << cells;
  }
}

/// Two triangles of some thousands of radii.
TEST(PoissonDisk, IsExactInLargeTriangles)
{
  Mesh strip;
  strip.addPatch(1, 1, [](double u, double v) { return glm::dvec3(u, 4e-4 * v, 0.0); });
  const double radius = 2e-4;
  const auto points = positionsOf(strip.view(), sample(strip, radius).samples);
  EXPECT_GT(points.size(), 8000u);
  EXPECT_GE(leastDistance(points, points.size()), 0.999 * radius);
}

/// The larger the coverage slack, the fewer samples; the covering radius holds.
TEST(PoissonDisk, LeavesGapsAsWideAsAskedFor)
{
  for (const Mesh& mesh : { square(1), sphere(60, 30) })
  {
    const double radius = 0.03 * std::sqrt(areaOf(mesh));
    std::size_t before = std::numeric_limits<std::size_t>::max();
    for (const double gap : { 0.02, 0.06, 0.2, 0.5, 1.0 })
    {
      const auto points = positionsOf(mesh.view(), sample(mesh, radius, 1, gap).samples);
      EXPECT_LT(points.size(), before) << gap;
      before = points.size();
      EXPECT_GE(leastDistance(points, points.size()), 0.99 * radius) << gap;
      EXPECT_LE(largestGap(probes(mesh, 5000), points, points.size()), ink::poissonDiskCover(radius, gap))
        << gap;
      const auto fitted = ink::fittedCount(gap) * areaOf(mesh) / (radius * radius);
      EXPECT_NEAR(static_cast<double>(points.size()), fitted, 0.12 * fitted) << gap;
      const auto counted =
        ink::samplePoissonDiskCount(mesh.view(), ink::cumulateArea(mesh.view()), {}, 500, gap, 3);
      const auto some = positionsOf(mesh.view(), counted.samples);
      ASSERT_EQ(some.size(), 500u);
      EXPECT_LE(largestGap(probes(mesh, 5000), some, 500), ink::poissonDiskCover(areaOf(mesh), 500.0, gap))
        << gap;
    }
  }
}

TEST(PoissonDisk, IsSaturatedOnCurvedSurfaces)
{
  const std::pair<Mesh, double> cases[] = { { sphere(160, 80), 0.08 }, { torus(1.0, 0.4, 120, 60), 0.08 },
    { sphere(40, 20), 0.05 } };
  for (const auto& [mesh, radius] : cases)
  {
    const auto samples = sample(mesh, radius).samples;
    const auto points = positionsOf(mesh.view(), samples);
    // A chord is a little shorter than its arc.
    EXPECT_GE(leastDistance(points, points.size()), 0.99 * radius);
    EXPECT_LE(largestGap(probes(mesh, 20000), points, points.size()),
      ink::poissonDiskCover(radius, ink::defaultCoverageSlack));
    EXPECT_GT(radius / ink::hexagonalDistance(areaOf(mesh), static_cast<double>(points.size())), 0.74);
  }
}

TEST(PoissonDisk, HasLittlePowerAtLowFrequencies)
{
  const Mesh mesh = square(30);
  const auto blue = positionsOf(mesh.view(), sample(mesh, 0.035).samples);
  const auto white = probes(mesh, blue.size());
  EXPECT_GT(ink::bandPower(white, 0.0, 0.5).mean, 0.7);
  EXPECT_LT(ink::bandPower(blue, 0.0, 0.5).mean, 0.15);
  EXPECT_GT(ink::bandPower(blue, 0.9, 1.2).mean, 1.3);
  // A lattice would have some hundred times the mean in a few directions.
  EXPECT_LT(ink::bandPower(blue, 0.9, 1.2).most, 20.0);
}

TEST(PoissonDisk, IsEvenOnASphere)
{
  // As many in each twentieth of the height, more evenly so than independent samples, though triangles at
  // the poles are thirty times smaller.
  const Mesh mesh = sphere(200, 100);
  const auto points = positionsOf(mesh.view(), sample(mesh, 0.03).samples);
  std::vector<double> bins(20);
  for (const glm::dvec3& p : points)
  {
    ++bins[std::clamp(static_cast<int>(10.0 * (p.z + 1.0)), 0, 19)];
  }
  const double expected = static_cast<double>(points.size()) / 20.0;
  for (const double bin : bins)
  {
    EXPECT_NEAR(bin, expected, 1.5 * std::sqrt(expected));
  }
}

/// Each sheet gets its samples as if it were alone, with the same and with opposite normals.
TEST(PoissonDisk, SheetsCloserThanTheRadiusDoNotStarveEachOther)
{
  const double radius = 0.05;
  const double alone = static_cast<double>(sample(square(20), radius).samples.size());
  for (const bool opposite : { false, true })
  {
    Mesh mesh = square(20);
    Mesh upper = square(20, 0.1 * radius);
    for (ink::Triangle& triangle : upper.triangles)
    {
      if (opposite)
      {
        std::swap(triangle[0], triangle[1]);
      }
    }
    append(mesh, upper);
    const auto samples = sample(mesh, radius).samples;
    const auto below = static_cast<double>(
      std::count_if(samples.begin(), samples.end(), [](const auto& one) { return one.triangle < 800; }));
    EXPECT_NEAR(below, alone, 0.06 * alone);
    EXPECT_NEAR(static_cast<double>(samples.size()) - below, alone, 0.06 * alone);
  }
}

/// A sheet folded on itself with a gap of a tenth of the radius has as many samples as unfolded.
TEST(PoissonDisk, FoldsDoNotStarveThemselves)
{
  const double radius = 0.04;
  const double bend = 0.05 * radius;
  const double length = 2.0;
  Mesh flat;
  flat.addPatch(300, 20, [=](double u, double v) { return glm::dvec3(u * length, v, 0.0); });
  Mesh folded;
  folded.addPatch(300, 20,
    [=](double u, double v)
    {
      const double s = u * length - 0.5 * (length - std::numbers::pi * bend);
      const double angle = std::clamp(s / bend, 0.0, std::numbers::pi);
      const double straight = s < 0.0 ? s : std::min(0.0, std::numbers::pi * bend - s);
      return glm::dvec3(straight + bend * std::sin(angle), v, -bend * std::cos(angle));
    });
  // The surface rolls up without being stretched, save for the corners cut at the bend.
  ASSERT_NEAR(areaOf(folded), areaOf(flat), 0.02);
  const auto expected = static_cast<double>(sample(flat, radius).samples.size());
  const auto found = static_cast<double>(sample(folded, radius).samples.size());
  EXPECT_NEAR(found, expected, 0.05 * expected);
}

/// Layers of a roll: one surface, everywhere the same side up.
TEST(PoissonDisk, RollsDoNotStarveThemselves)
{
  const double pitch = 0.02; // from layer to layer, a fifth of the radius
  Mesh roll;
  roll.addPatch(900, 10,
    [=](double u, double v)
    {
      const double angle = 6.0 * std::numbers::pi * u;
      const double out = 0.5 + pitch * angle / (2.0 * std::numbers::pi);
      return glm::dvec3(out * std::cos(angle), out * std::sin(angle), v);
    });
  const double radius = 0.1;
  const auto count = static_cast<double>(sample(roll, radius).samples.size());
  EXPECT_GT(count * radius * radius / areaOf(roll), 0.66);
}

TEST(PoissonDisk, KeepsTheSmallerRadiusWhereDensityVaries)
{
  // Four times the density on the right: half the distance.
  Mesh mesh = square(20);
  for (const ink::Triangle& t : mesh.triangles)
  {
    const double x = (mesh.points[t[0]].x + mesh.points[t[1]].x + mesh.points[t[2]].x) / 3.0;
    mesh.triangleDensity.push_back(x > 0.5 ? 4.0f : 1.0f);
  }
  const double radius = 0.03;
  const auto areas = ink::cumulateArea(mesh.view());
  const ink::LocalRadius local(mesh.view(), areas, radius);
  EXPECT_NEAR(local.at(1.0f) / local.at(4.0f), 2.0, 1e-6);
  const auto points = positionsOf(mesh.view(), sample(mesh, radius).samples);
  std::vector<glm::dvec3> left;
  std::vector<glm::dvec3> right;
  for (const glm::dvec3& p : points)
  {
    if (p.x != 0.5)
    {
      (p.x > 0.5 ? right : left).push_back(p);
    }
  }
  EXPECT_GE(leastDistance(left, left.size()), local.at(1.0f) * (1.0 - 1e-5));
  EXPECT_GE(leastDistance(right, right.size()), local.at(4.0f) * (1.0 - 1e-5));
  EXPECT_NEAR(static_cast<double>(right.size()) / static_cast<double>(left.size()), 4.0, 0.5);
  for (const bool isRight : { false, true })
  {
    std::vector<glm::dvec3> inside;
    for (const glm::dvec3& p : probes(square(1), 10000))
    {
      if ((p.x > 0.5) == isRight)
      {
        inside.push_back(p);
      }
    }
    EXPECT_LE(largestGap(inside, points, points.size()),
      ink::poissonDiskCover(local.at(isRight ? 4.0f : 1.0f), ink::defaultCoverageSlack));
  }
}

TEST(PoissonDisk, LeavesOutWhereThereIsNoDensity)
{
  Mesh mesh = square(10);
  for (const glm::dvec3& p : mesh.points)
  {
    mesh.pointDensity.push_back(p.x < 0.45 ? 0.0f : 1.0f);
  }
  const auto points = positionsOf(mesh.view(), sample(mesh, 0.03).samples);
  EXPECT_GT(points.size(), 100u);
  for (const glm::dvec3& p : points)
  {
    EXPECT_GT(p.x, 0.4 - 1e-6);
  }
}

TEST(PoissonDisk, IsTheSameOnAnyNumberOfThreads)
{
  const Mesh mesh = torus(1.0, 0.3, 60, 30);
  const auto run = [&] { return sample(mesh, 0.02).samples; };
  const auto one = onThreads(1, run);
  EXPECT_EQ(one, onThreads(2, run));
  EXPECT_NE(one, sample(mesh, 0.02, 2).samples);
  const auto count = [&]
  {
    return ink::samplePoissonDiskCount(
      mesh.view(), ink::cumulateArea(mesh.view()), {}, 3000, ink::defaultCoverageSlack, 5)
      .samples;
  };
  EXPECT_EQ(onThreads(1, count), onThreads(2, count));
}

TEST(PoissonDisk, DoesNotDependOnTheTessellation)
{
  // As many on a square of 2, of 200, of 20000 triangles, and in needles of 1 : 200.
  const double radius = 0.03;
  const auto expected = static_cast<double>(sample(square(1), radius).samples.size());
  Mesh needles;
  needles.addPatch(200, 1, [](double u, double v) { return glm::dvec3(u, v, 0.0); });
  for (const Mesh& mesh : { square(10), square(100), needles })
  {
    EXPECT_NEAR(static_cast<double>(sample(mesh, radius).samples.size()), expected, 0.05 * expected);
  }
}

TEST(PoissonDisk, MakesTheNumberAskedFor)
{
  const Mesh meshes[] = { square(1), sphere(60, 30), torus(1.0, 0.05, 100, 8) };
  for (const Mesh& mesh : meshes)
  {
    const auto areas = ink::cumulateArea(mesh.view());
    const auto probed = probes(mesh, 5000);
    for (const std::size_t count : { 1u, 2u, 7u, 100u, 2000u })
    {
      const auto result =
        ink::samplePoissonDiskCount(mesh.view(), areas, {}, count, ink::defaultCoverageSlack, 3);
      ASSERT_EQ(result.samples.size(), count);
      if (count >= 100)
      {
        const auto points = positionsOf(mesh.view(), result.samples);
        // Through space it is shorter from one side of the torus to the other.
        const double chord = &mesh == &meshes[2] ? 0.6 : 0.98;
        EXPECT_GE(leastDistance(points, count), chord * result.radius) << count;
        EXPECT_LE(largestGap(probed, points, count),
          ink::poissonDiskCover(areas.area.back(), double(count), ink::defaultCoverageSlack))
          << count;
      }
    }
  }
}

TEST(PoissonDisk, OfFewOrNoTriangles)
{
  EXPECT_TRUE(sample(Mesh(), 0.1).samples.empty());
  Mesh one;
  one.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  one.triangles = { { 0, 1, 2 } };
  EXPECT_EQ(sample(one, 10.0).samples.size(), 1u);
  EXPECT_GT(sample(one, 0.1).samples.size(), 30u);
  // Each of 400 pieces has room for one.
  Mesh pieces;
  for (int i = 0; i < 400; ++i)
  {
    Mesh piece = one;
    for (glm::dvec3& p : piece.points)
    {
      p = 0.01 * p + glm::dvec3(0.02 * (i % 20), 0.02 * (i / 20), 0.0);
    }
    append(pieces, piece);
  }
  EXPECT_EQ(sample(pieces, 0.1).samples.size(), 400u);
}

TEST(PoissonDisk, SaysWhenTheRadiusIsTooSmall)
{
  EXPECT_THROW(sample(square(1), 1e-9), std::invalid_argument);
}

TEST(PoissonDisk, CanBeStopped)
{
  const Mesh mesh = square(1);
  const auto stop = [](double) { return false; };
  EXPECT_TRUE(ink::samplePoissonDisk(
    mesh.view(), ink::cumulateArea(mesh.view()), 0.02, ink::defaultCoverageSlack, 1, stop)
                .stopped);
}
