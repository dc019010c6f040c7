// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/CoveringRadius.h"
#include "PointSampling/WhiteNoise.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace ink::test;

std::vector<ink::SurfaceSample> sample(const Mesh& mesh, std::size_t count, std::uint64_t seed = 1)
{
  return ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), count, seed);
}

/// Pearson's statistic over bins of equal expectation; of `bins` - 1 degrees of freedom.
double chiSquare(const std::vector<int>& counts)
{
  double sum = 0.0;
  for (const int count : counts)
  {
    sum += count;
  }
  const double expected = sum / static_cast<double>(counts.size());
  double result = 0.0;
  for (const int count : counts)
  {
    result += (count - expected) * (count - expected) / expected;
  }
  return result;
}

/// Nine hundred and ninety-nine in a thousand random statistics are within these bounds (normal approximation
/// of Wilson and Hilferty).
void expectPlausible(double statistic, double freedom)
{
  const double z =
    (std::cbrt(statistic / freedom) - (1.0 - 2.0 / (9.0 * freedom))) / std::sqrt(2.0 / (9.0 * freedom));
  EXPECT_LT(std::abs(z), 3.3) << "chi square " << statistic << " of " << freedom << " degrees";
}

} // namespace

TEST(WhiteNoise, IsEvenByAreaOnASphere)
{
  // Triangles near the poles are much smaller, and still the height is distributed evenly (Archimedes).
  const Mesh mesh = sphere(240, 120);
  std::vector<int> cells(20 * 20);
  for (const glm::dvec3& p : positionsOf(mesh.view(), sample(mesh, 200000)))
  {
    const int height = std::clamp(static_cast<int>(10.0 * (p.z / glm::length(p) + 1.0)), 0, 19);
    const int around =
      std::clamp(static_cast<int>(20.0 * (std::atan2(p.y, p.x) / (2.0 * std::numbers::pi) + 0.5)), 0, 19);
    ++cells[20 * height + around];
  }
  expectPlausible(chiSquare(cells), 399);
}

TEST(WhiteNoise, IsEvenInsideOneTriangle)
{
  Mesh mesh;
  mesh.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  mesh.triangles = { { 0, 1, 2 } };
  // The triangle's mirror image makes a square of it.
  std::vector<int> cells(256);
  for (const glm::dvec3& p : positionsOf(mesh.view(), sample(mesh, 100000)))
  {
    EXPECT_TRUE(p.x >= 0.0 && p.y >= 0.0 && p.x + p.y <= 1.0 + 1e-6);
    const int x = std::min(static_cast<int>(16.0 * p.x), 15);
    const int y = std::min(static_cast<int>(16.0 * p.y), 15);
    cells[16 * y + x] += x + y == 15 ? 2 : x + y < 15 ? 1 : 0;
  }
  std::vector<int> inside;
  for (int i = 0; i < 256; ++i)
  {
    if (i % 16 + i / 16 < 15)
    {
      inside.push_back(cells[i]);
    }
  }
  expectPlausible(chiSquare(inside), static_cast<double>(inside.size()) - 1.0);
}

/// Independent: the number of samples in a region is as variable as Poisson's distribution, and the nearest
/// neighbor is at 1 / (2 sqrt(density)) in the mean.
TEST(WhiteNoise, IsIndependent)
{
  const Mesh mesh = square(1);
  const auto points = positionsOf(mesh.view(), sample(mesh, 4000));
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (std::min({ points[i].x, points[i].y, 1.0 - points[i].x, 1.0 - points[i].y }) > 0.05)
    {
      double least = 1.0;
      for (std::size_t j = 0; j < points.size(); ++j)
      {
        least = i == j ? least : std::min(least, glm::distance(points[i], points[j]));
      }
      sum += least;
      ++count;
    }
  }
  EXPECT_NEAR(sum / count * 2.0 * std::sqrt(4000.0), 1.0, 0.04);

  std::vector<int> cells(40 * 40);
  for (const glm::dvec3& p : positionsOf(square(40).view(), sample(square(40), 160000)))
  {
    ++cells[40 * std::min(int(40 * p.y), 39) + std::min(int(40 * p.x), 39)];
  }
  expectPlausible(chiSquare(cells), 1599);
}

TEST(WhiteNoise, DoesNotDependOnTheTessellation)
{
  // The same square in 2 and in 20000 triangles: the same distribution, here of x.
  for (const int cells : { 1, 100 })
  {
    const Mesh mesh = square(cells);
    std::vector<int> bins(50);
    for (const glm::dvec3& p : positionsOf(mesh.view(), sample(mesh, 100000)))
    {
      ++bins[std::min(static_cast<int>(50.0 * p.x), 49)];
    }
    expectPlausible(chiSquare(bins), 49);
  }
}

TEST(WhiteNoise, FollowsADensityOfPoints)
{
  // Density x on the square: x squared is distributed evenly.
  Mesh mesh = square(4);
  for (const glm::dvec3& p : mesh.points)
  {
    mesh.pointDensity.push_back(static_cast<float>(p.x));
  }
  std::vector<int> bins(40);
  for (const glm::dvec3& p : positionsOf(mesh.view(), sample(mesh, 100000)))
  {
    ++bins[std::min(static_cast<int>(40.0 * p.x * p.x), 39)];
  }
  expectPlausible(chiSquare(bins), 39);
}

TEST(WhiteNoise, FollowsADensityOfTriangles)
{
  Mesh mesh = square(1);
  mesh.triangleDensity = { 3.0f, 1.0f };
  const auto samples = sample(mesh, 40000);
  const auto first =
    std::count_if(samples.begin(), samples.end(), [](const auto& one) { return one.triangle == 0; });
  EXPECT_NEAR(first, 30000, 300);
  mesh.triangleDensity = { 0.0f, std::numeric_limits<float>::quiet_NaN() };
  EXPECT_TRUE(sample(mesh, 10).empty());
  mesh.triangleDensity = { -1.0f, 2.0f };
  for (const auto& one : sample(mesh, 100))
  {
    EXPECT_EQ(one.triangle, 1u);
  }
}

TEST(WhiteNoise, IsTheSameOnAnyNumberOfThreads)
{
  const Mesh mesh = torus(2.0, 0.5, 100, 50);
  const auto run = [&] { return sample(mesh, 100001); };
  EXPECT_EQ(onThreads(1, run), onThreads(2, run));
  EXPECT_NE(sample(mesh, 1000, 1), sample(mesh, 1000, 2));
}

TEST(WhiteNoise, PassesOverTrianglesOfNoArea)
{
  Mesh mesh = square(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.points.push_back({ nan, 0, 0 });
  mesh.triangles.insert(mesh.triangles.begin(), { { 0, 0, 1 }, { 0, 1, 4 } });
  mesh.triangles.push_back({ 2, 2, 2 });
  const auto samples = sample(mesh, 1000);
  ASSERT_EQ(samples.size(), 1000u);
  for (const auto& one : samples)
  {
    EXPECT_TRUE(one.triangle == 2 || one.triangle == 3);
  }
  EXPECT_TRUE(sample(Mesh(), 10).empty());
  EXPECT_TRUE(sample(square(1), 0).empty());
}

/// A triangle by its name: as many samples as its area takes, rounded, evenly spread, and the same ones in a
/// piece of the mesh and in another order. In more triangles than one thread takes at a time.
TEST(WhiteNoise, OfNamedTrianglesDependsOnThemAlone)
{
  Mesh mesh = square(100);
  for (glm::dvec3& point : mesh.points)
  {
    point.x *= 0.5 + 0.5 * point.x;
  }
  std::vector<std::uint64_t> names(mesh.triangles.size());
  for (std::size_t t = 0; t < names.size(); ++t)
  {
    names[t] = 7 * t + 3;
  }
  const double perArea = 100000.0;
  const auto whole = ink::sampleWhiteNoise(mesh.view(), names, perArea, 5);
  std::vector<std::vector<ink::SurfaceSample>> inTriangle(names.size());
  std::uint32_t last = 0;
  std::vector<int> cells(5 * 5);
  for (const ink::SurfaceSample& one : whole)
  {
    ASSERT_LT(one.triangle, names.size());
    ASSERT_GE(one.triangle, last);
    last = one.triangle;
    inTriangle[last].push_back(one);
    // An evenly distributed position's root squared and its way along the edge opposite to the first corner
    // are even, too.
    const float root = one.b1 + one.b2;
    const auto bin = [](float even) { return std::min(static_cast<int>(5.0f * even), 4); };
    ++cells[5 * bin(root * root) + bin(root > 0.0f ? one.b2 / root : 0.0f)];
  }
  expectPlausible(chiSquare(cells), 24);
  double total = 0.0;
  for (std::size_t t = 0; t < names.size(); ++t)
  {
    const double exact = perArea * ink::areaOf(mesh.view(), t);
    EXPECT_LT(std::abs(static_cast<double>(inTriangle[t].size()) - exact), 1.0) << t;
    total += exact;
  }
  // Rounded independently, by a variance of at most a quarter a triangle.
  EXPECT_NEAR(whole.size(), total, 3.3 * std::sqrt(0.25 * static_cast<double>(names.size())));

  Mesh piece = mesh;
  std::vector<std::uint64_t> pieceNames;
  piece.triangles.clear();
  for (std::size_t t = names.size(); t-- > 0;)
  {
    if (t % 2 == 0)
    {
      piece.triangles.push_back(mesh.triangles[t]);
      pieceNames.push_back(names[t]);
    }
  }
  std::size_t seen = 0;
  for (ink::SurfaceSample one : ink::sampleWhiteNoise(piece.view(), pieceNames, perArea, 5))
  {
    one.triangle = static_cast<std::uint32_t>(names.size() - 2 - 2 * one.triangle);
    const auto& same = inTriangle[one.triangle];
    EXPECT_NE(std::find(same.begin(), same.end(), one), same.end());
    ++seen;
  }
  std::size_t expected = 0;
  for (std::size_t t = 0; t < names.size(); t += 2)
  {
    expected += inTriangle[t].size();
  }
  EXPECT_EQ(seen, expected);
  EXPECT_TRUE(ink::sampleWhiteNoise(Mesh().view(), {}, perArea, 5).empty());
}

TEST(WhiteNoise, DiscsOfItsCoveringRadiusLeaveNoHoles)
{
  // On a torus, which has no border beyond which discs would miss neighbors.
  const Mesh mesh = torus(1.0, 0.4, 200, 100);
  const auto areas = ink::cumulateArea(mesh.view());
  const auto probes = positionsOf(mesh.view(), sample(mesh, 20000, 99));
  for (const std::size_t count : { 300u, 3000u })
  {
    const auto points = positionsOf(mesh.view(), sample(mesh, count));
    const double cover = ink::whiteNoiseCover(areas.area.back(), static_cast<double>(count));
    const double gap = largestGap(probes, points, count);
    EXPECT_LE(gap, cover) << count;
    EXPECT_GE(gap, 0.5 * cover) << count;
  }
}
