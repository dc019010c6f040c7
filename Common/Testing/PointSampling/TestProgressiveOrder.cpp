// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PoissonDisk.h"
#include "PointSampling/ProgressiveOrder.h"
#include "PointSampling/WhiteNoise.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{

using namespace ink::test;

std::vector<glm::vec3> toFloat(const std::vector<glm::dvec3>& points)
{
  return { points.begin(), points.end() };
}

std::vector<glm::dvec3> inOrder(
  const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& order)
{
  std::vector<glm::dvec3> result;
  std::transform(
    order.begin(), order.end(), std::back_inserter(result), [&](std::uint32_t i) { return points[i]; });
  return result;
}

bool isPermutation(std::vector<std::uint32_t> order, std::size_t count)
{
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  return order == all;
}

/// The least distance among a beginning, against that of a hexagonal lattice of as many points.
double ratio(const std::vector<glm::dvec3>& points, double share, double area)
{
  const auto count = static_cast<std::size_t>(share * static_cast<double>(points.size()));
  return leastDistance(points, count) / ink::hexagonalDistance(area, static_cast<double>(count));
}

} // namespace

TEST(ProgressiveOrder, MakesEveryBeginningOfBlueNoiseBlueNoise)
{
  const Mesh mesh = square(1);
  const auto points = positionsOf(mesh.view(),
    ink::samplePoissonDisk(mesh.view(), ink::cumulateArea(mesh.view()), 0.013, ink::defaultCoverageSlack, 1)
      .samples);
  const std::vector<std::uint32_t> order = ink::progressiveOrder(toFloat(points), {}, {}, 1);
  ASSERT_TRUE(isPermutation(order, points.size()));
  const auto sorted = inOrder(points, order);
  const auto probed =
    positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), 5000, 9));
  for (const double share : { 0.05, 0.1, 0.17, 0.25, 0.37, 0.5, 0.75, 1.0 })
  {
    // 0.8 is what a random packing has at its limit, here 0.1 of independent points.
    EXPECT_GT(ratio(sorted, share, 1.0), 0.58) << share;
    const auto count = static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
    EXPECT_LT(largestGap(probed, sorted, count), 1.05 * ink::hexagonalDistance(1.0, double(count))) << share;
  }
}

TEST(ProgressiveOrder, MakesBeginningsOfWhiteNoiseBlueNoise)
{
  const Mesh mesh = square(1);
  const auto points =
    positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), 8000, 1));
  const auto sorted = inOrder(points, ink::progressiveOrder(toFloat(points), {}, {}, 1));
  EXPECT_GT(ratio(sorted, 0.05, 1.0), 0.6);
  EXPECT_GT(ratio(sorted, 0.25, 1.0), 0.5);
  // As they come, the points have nothing of it.
  EXPECT_LT(ratio(points, 0.25, 1.0), 0.1);
}

TEST(ProgressiveOrder, MakesBeginningsOfALatticeBlueNoise)
{
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 6400; ++i)
  {
    points.emplace_back(i % 80, i / 80, 0.0);
  }
  const auto sorted = inOrder(points, ink::progressiveOrder(toFloat(points), {}, {}, 4));
  for (const double share : { 0.05, 0.25 })
  {
    EXPECT_GT(ratio(sorted, share, 6400.0), 0.55) << share;
  }
}

TEST(ProgressiveOrder, SpreadsOverBothSidesOfASheet)
{
  const Mesh mesh = square(1);
  auto points =
    positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), 3000, 1));
  std::vector<glm::vec3> normals(3000, glm::vec3(0, 0, 1));
  for (std::size_t i = 0; i < 3000; ++i)
  {
    points.push_back(points[i] - glm::dvec3(0, 0, 1e-3));
    normals.emplace_back(0, 0, -1);
  }
  const auto order = ink::progressiveOrder(toFloat(points), normals, {}, 1);
  for (const std::size_t count : { 60u, 600u, 3000u })
  {
    const auto above =
      std::count_if(order.begin(), order.begin() + count, [](std::uint32_t i) { return i < 3000; });
    EXPECT_NEAR(static_cast<double>(above), 0.5 * count, 0.05 * count + 2.0);
  }
  // Each side for itself is spread.
  std::vector<glm::dvec3> upper;
  for (std::size_t i = 0; i < 300; ++i)
  {
    if (order[i] < 3000)
    {
      upper.push_back(points[order[i]]);
    }
  }
  EXPECT_GT(ratio(upper, 1.0, 1.0), 0.5);
}

TEST(ProgressiveOrder, SpreadsOverSheetsThatFaceTheSameWay)
{
  // Each point of a lattice has another right above it.
  constexpr std::uint32_t count = 144;
  const glm::vec3 normal(0.6f, 0.0f, 0.8f);
  const glm::vec3 along(0.8f, 0.0f, -0.6f);
  std::vector<glm::vec3> points;
  for (std::uint32_t i = 0; i < 2 * count; ++i)
  {
    points.push_back(static_cast<float>(i % 12) * along + glm::vec3(0.0f, i % count / 12, 0.0f) +
      (i < count ? 0.0f : 0.1f) * normal);
  }
  const auto pairsAmongFirst = [&](const std::vector<glm::vec3>& normals)
  {
    const std::vector<std::uint32_t> order = ink::progressiveOrder(points, normals, {}, 1);
    std::vector<int> found(count, 0);
    std::for_each(order.begin(), order.begin() + count / 2, [&](std::uint32_t i) { ++found[i % count]; });
    return std::count(found.begin(), found.end(), 2);
  };
  std::vector<glm::vec3> normals(points.size(), normal);
  // Both of a pair come at the same radius: of the first 72, nearly all are 36 pairs.
  EXPECT_GT(pairsAmongFirst(normals), 30);
  EXPECT_EQ(pairsAmongFirst({}), 0);
  // Seen from one of them, the other is right above it, but not the other way round: one sheet.
  std::fill(normals.begin() + count, normals.end(), 0.743f * normal + 0.669f * along);
  EXPECT_EQ(pairsAmongFirst(normals), 0);
}

TEST(ProgressiveOrder, KeepsDistancesInProportionToTheRadii)
{
  const Mesh mesh = square(1);
  const auto points =
    positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), 8000, 1));
  std::vector<float> radii;
  for (const glm::dvec3& p : points)
  {
    radii.push_back(p.x > 0.5 ? 1.0f : 3.0f);
  }
  const auto sorted = inOrder(points, ink::progressiveOrder(toFloat(points), {}, radii, 1));
  const auto right =
    std::count_if(sorted.begin(), sorted.begin() + 400, [](const auto& p) { return p.x > 0.5; });
  EXPECT_NEAR(static_cast<double>(right), 360.0, 15.0); // 9 : 1
}

TEST(ProgressiveOrder, DoesNotDependOnWhereThePointsAre)
{
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> moved;
  for (int i = 0; i < 900; ++i)
  {
    points.emplace_back(i % 30, i / 30, 0.0f);
    moved.push_back(points.back() + glm::vec3(256.0f, -512.0f, 1024.0f)); // exact
  }
  EXPECT_EQ(ink::progressiveOrder(moved, {}, {}, 1), ink::progressiveOrder(points, {}, {}, 1));
}

TEST(ProgressiveOrder, DoesNotDependOnUnits)
{
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> small;
  std::vector<float> radii;
  std::vector<float> smallRadii;
  for (int i = 0; i < 900; ++i)
  {
    points.emplace_back(i % 30, i / 30, 0.0f);
    radii.push_back(i % 7 ? 1.0f : 3.0f);
    small.push_back(points.back() / 1024.0f); // exact
    smallRadii.push_back(radii.back() / 1024.0f);
  }
  EXPECT_EQ(ink::progressiveOrder(small, {}, smallRadii, 1), ink::progressiveOrder(points, {}, radii, 1));
}

TEST(ProgressiveOrder, IsTheSameOnAnyNumberOfThreads)
{
  const Mesh mesh = sphere(40, 20);
  const auto points = toFloat(
    positionsOf(mesh.view(), ink::sampleWhiteNoise(mesh.view(), ink::cumulateArea(mesh.view()), 20000, 1)));
  const auto run = [&] { return ink::progressiveOrder(points, {}, {}, 1); };
  const auto one = onThreads(1, run);
  EXPECT_EQ(one, onThreads(2, run));
  EXPECT_NE(one, ink::progressiveOrder(points, {}, {}, 2));
}

TEST(ProgressiveOrder, OfExtremes)
{
  EXPECT_TRUE(ink::progressiveOrder({}, {}, {}, 1).empty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec3> same(100, glm::vec3(3.0f));
  EXPECT_TRUE(isPermutation(ink::progressiveOrder(same, {}, {}, 1), 100));
  const std::vector<glm::vec3> broken{ { nan, 0, 0 }, { 1, 2, 3 }, { 0, infinite, 0 }, { 1, 2, 4 } };
  const auto order = ink::progressiveOrder(broken, {}, {}, 1);
  EXPECT_TRUE(isPermutation(order, 4));
  EXPECT_TRUE(order[0] % 2 == 1 && order[1] % 2 == 1);
  // Copies come after what is different.
  std::vector<glm::vec3> copies(50, glm::vec3(0.0f));
  copies.emplace_back(1, 0, 0);
  copies.emplace_back(0, 1, 0);
  const auto first = ink::progressiveOrder(copies, {}, {}, 1);
  EXPECT_TRUE(isPermutation(first, 52));
  EXPECT_TRUE(std::count_if(first.begin(), first.begin() + 3, [](std::uint32_t i) { return i >= 50; }) == 2);
  for (const float scale : { 1e-30f, 1e30f })
  {
    std::vector<glm::vec3> line;
    for (int i = 0; i < 64; ++i)
    {
      line.emplace_back(scale * i, 0, 0);
    }
    EXPECT_TRUE(isPermutation(ink::progressiveOrder(line, {}, {}, 1), 64));
  }
}

TEST(ProgressiveOrder, TakesEveryPointOfFullAndOfPartBlocks)
{
  for (const std::size_t count : { 4095u, 4096u, 4097u, 8193u })
  {
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < count; ++i)
    {
      points.emplace_back(count - i, 0.0f, 0.0f);
    }
    EXPECT_TRUE(isPermutation(ink::progressiveOrder(points, {}, {}, 1), count)) << count;
  }
}

TEST(ProgressiveOrder, CanBeStopped)
{
  const std::vector<glm::vec3> points{ { 0, 0, 0 }, { 1, 0, 0 } };
  EXPECT_TRUE(ink::progressiveOrder(points, {}, {}, 1, [](double) { return false; }).empty());
}
