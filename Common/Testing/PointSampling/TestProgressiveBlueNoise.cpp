// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/CoveringRadius.h"
#include "PointSampling/PoissonDisk.h"
#include "PointSampling/ProgressiveBlueNoise.h"
#include "PointSampling/WhiteNoise.h"
#include "PowerSpectrum.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace
{

using namespace ink::test;

std::vector<ink::SurfaceSample> sample(const Mesh& mesh, std::size_t count, std::uint64_t seed = 1,
  double candidates = ink::defaultCandidates, const ink::Progress& progress = {})
{
  return ink::sampleProgressively(
    mesh.view(), ink::cumulateArea(mesh.view()), {}, count, candidates, seed, progress);
}

std::vector<glm::dvec3> points(const Mesh& mesh, std::size_t count)
{
  return positionsOf(mesh.view(), sample(mesh, count));
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

std::size_t part(double share, const std::vector<glm::dvec3>& all)
{
  return static_cast<std::size_t>(share * static_cast<double>(all.size()));
}

} // namespace

/// On two triangles that are cut into many pieces, and on many small ones.
TEST(ProgressiveBlueNoise, EveryBeginningIsBlueNoise)
{
  for (const int cells : { 1, 90 })
  {
    const Mesh mesh = square(cells);
    const auto all = points(mesh, 8000);
    ASSERT_EQ(all.size(), 8000u);
    const auto probed = probes(mesh, 5000);
    for (const double share : { 0.01, 0.05, 0.1, 0.17, 0.25, 0.37, 0.5, 0.75, 1.0 })
    {
      const std::size_t count = part(share, all);
      const double lattice = ink::hexagonalDistance(1.0, static_cast<double>(count));
      // A random packing at its limit has 0.8.
      EXPECT_GT(leastDistance(all, count), 0.62 * lattice) << share;
      EXPECT_LT(largestGap(probed, all, count), 1.05 * lattice) << share;
    }
  }
}

TEST(ProgressiveBlueNoise, HasLittlePowerAtLowFrequencies)
{
  const auto all = points(square(30), 2400);
  for (const std::size_t count : { std::size_t(600), all.size() })
  {
    EXPECT_LT(ink::bandPower({ all.data(), count }, 0.0, 0.5).mean, 0.19) << count;
    EXPECT_GT(ink::bandPower({ all.data(), count }, 0.9, 1.2).mean, 1.2) << count;
  }
}

/// More candidates, larger distances.
TEST(ProgressiveBlueNoise, IsTheMoreEvenTheMoreCandidates)
{
  const Mesh mesh = square(20);
  double before = 0.0;
  for (const double candidates : { 2.0, 4.0, 8.0, 24.0 })
  {
    const auto all = positionsOf(mesh.view(), sample(mesh, 6000, 1, candidates));
    const double least = leastDistance(all, all.size());
    EXPECT_GT(least, 1.03 * before) << candidates;
    // One step of the radius more or less.
    EXPECT_NEAR(least, std::sqrt(ink::progressiveCount(candidates) / 6000.0), 0.07 * least) << candidates;
    EXPECT_LE(
      largestGap(probes(mesh, 20000), all, all.size()), ink::progressiveCover(1.0, 6000.0, candidates))
      << candidates;
    before = least;
  }
}

TEST(ProgressiveBlueNoise, MakesTheNumberAskedFor)
{
  for (const Mesh& mesh : { square(1), sphere(60, 30), torus(1.0, 0.3, 100, 30) })
  {
    const auto probed = probes(mesh, 5000);
    for (const std::size_t count : { 1u, 2u, 7u, 100u, 2000u })
    {
      const auto all = points(mesh, count);
      ASSERT_EQ(all.size(), count);
      if (count >= 100)
      {
        EXPECT_LE(largestGap(probed, all, count),
          ink::progressiveCover(areaOf(mesh), double(count), ink::defaultCandidates))
          << count;
        EXPECT_GT(leastDistance(all, count), 0.6 * ink::hexagonalDistance(areaOf(mesh), double(count)))
          << count;
      }
    }
  }
}

TEST(ProgressiveBlueNoise, IsEvenOnASphere)
{
  // As many in each twentieth of the height, though triangles at the poles are thirty times smaller.
  std::vector<double> bins(20);
  const auto all = points(sphere(200, 100), 10000);
  for (const glm::dvec3& p : all)
  {
    ++bins[static_cast<std::size_t>(std::clamp(static_cast<int>(10.0 * (p.z + 1.0)), 0, 19))];
  }
  for (const double bin : bins)
  {
    EXPECT_NEAR(bin, 500.0, 1.5 * std::sqrt(500.0));
  }
}

/// Each side of a sheet that is thinner than the distance between samples has as many as if it were alone.
TEST(ProgressiveBlueNoise, SidesOfASheetDoNotStarveEachOther)
{
  Mesh mesh = square(20);
  const Mesh upper = square(20, 1e-3);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), upper.points.begin(), upper.points.end());
  for (const auto& [a, b, c] : upper.triangles)
  {
    mesh.triangles.push_back({ first + b, first + a, first + c });
  }
  const auto all = points(mesh, 3000);
  for (const std::size_t count : { 100u, 750u, 3000u })
  {
    std::vector<glm::dvec3> below;
    std::copy_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), std::back_inserter(below),
      [](const glm::dvec3& p) { return p.z == 0.0; });
    const double half = 0.5 * static_cast<double>(count);
    EXPECT_NEAR(static_cast<double>(below.size()), half, 0.03 * half + 2.0);
    EXPECT_GT(leastDistance(below, below.size()), 0.58 * ink::hexagonalDistance(1.0, half));
  }
}

TEST(ProgressiveBlueNoise, IsTheSameOnAnyNumberOfThreads)
{
  const Mesh mesh = torus(1.0, 0.3, 60, 30);
  const auto run = [&] { return sample(mesh, 30000); };
  const auto one = onThreads(1, run);
  EXPECT_EQ(one, onThreads(2, run));
  EXPECT_EQ(one, onThreads(2, run));
  EXPECT_NE(one, sample(mesh, 30000, 2));
}

/// As many in each quarter of a square, whatever its triangles: two, needles, tiny ones, and of all sizes.
TEST(ProgressiveBlueNoise, DoesNotDependOnTheTessellation)
{
  Mesh needles;
  needles.addPatch(200, 1, [](double u, double v) { return glm::dvec3(u, v, 0.0); });
  Mesh uneven;
  uneven.addPatch(60, 60, [](double u, double v) { return glm::dvec3(u * u * u, v * v, 0.0); });
  for (const Mesh& mesh : { square(1), square(200), needles, uneven })
  {
    const auto all = points(mesh, 4000);
    ASSERT_EQ(all.size(), 4000u);
    EXPECT_GT(leastDistance(all, all.size()), 0.62 * ink::hexagonalDistance(1.0, 4000.0));
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const auto inside = std::count_if(all.begin(), all.end(),
        [&](const glm::dvec3& p)
        { return (p.x > 0.5) == (quarter % 2 == 1) && (p.y > 0.5) == (quarter > 1); });
      EXPECT_NEAR(static_cast<double>(inside), 1000.0, 30.0);
    }
  }
}

TEST(ProgressiveBlueNoise, OfExtremes)
{
  EXPECT_TRUE(sample(Mesh(), 100).empty());
  Mesh flat;
  flat.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  flat.triangles = { { 0, 1, 2 } };
  EXPECT_TRUE(ink::sampleProgressively(flat.view(), ink::cumulateArea(flat.view()), {}, 100, 8.0, 1).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    Mesh mesh = square(10);
    for (glm::dvec3& p : mesh.points)
    {
      p = scale * p + glm::dvec3(1e7 * scale);
    }
    // Neither a triangle without area nor one with a point that is not finite counts.
    const auto last = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(nan, 0.0, 0.0);
    mesh.triangles.push_back({ 0, 1, last });
    mesh.triangles.push_back({ 3, 3, 4 });
    const auto samples = sample(mesh, 500);
    ASSERT_EQ(samples.size(), 500u) << scale;
    EXPECT_TRUE(
      std::all_of(samples.begin(), samples.end(), [](const auto& one) { return one.triangle < 200; }));
    EXPECT_GT(leastDistance(positionsOf(mesh.view(), samples), 500),
      0.6 * scale * ink::hexagonalDistance(1.0, 500.0));
  }
  // Specks far from each other: at first one in each.
  Mesh specks;
  for (int i = 0; i < 400; ++i)
  {
    const glm::dvec3 at(i % 20, i / 20, 0.0);
    const auto first = static_cast<std::uint32_t>(specks.points.size());
    specks.points.insert(
      specks.points.end(), { at, at + glm::dvec3(1e-4, 0, 0), at + glm::dvec3(0, 1e-4, 0) });
    specks.triangles.push_back({ first, first + 1, first + 2 });
  }
  EXPECT_EQ(sample(specks, 2000).size(), 2000u);
  EXPECT_THROW(sample(specks, 3'000'000'000'000u), std::invalid_argument);
}

TEST(ProgressiveBlueNoise, ReportsProgressAndCanBeStopped)
{
  const Mesh mesh = square(1);
  double last = 0.0;
  int calls = 0;
  const auto whole = sample(mesh, 20000, 1, ink::defaultCandidates,
    [&](double done)
    {
      EXPECT_GE(done, last - 1e-12);
      last = done;
      ++calls;
      return true;
    });
  EXPECT_EQ(whole.size(), 20000u);
  EXPECT_GT(calls, 20);
  EXPECT_GT(last, 0.9);
  EXPECT_LE(last, 1.0);
  EXPECT_TRUE(sample(mesh, 20000, 1, ink::defaultCandidates, [](double done) { return done < 0.6; }).empty());
}
