// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/SampleGroups.h"

#include "Core/Hash.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <vector>

namespace
{

using ink::groupSamples;
using ink::SampleGroups;

double randomOf(std::uint64_t n, std::uint64_t which)
{
  return static_cast<double>(ink::hash(n, which) >> 11) * 0x1p-53;
}

/// On the unit sphere, evenly.
std::vector<glm::vec3> makeSphere(std::size_t count)
{
  std::vector<glm::vec3> points;
  for (std::size_t n = 0; n < count; ++n)
  {
    const double z = 2.0 * randomOf(n, 0) - 1.0;
    const double angle = 2.0 * std::numbers::pi * randomOf(n, 1);
    const double r = std::sqrt(1.0 - z * z);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return points;
}

} // namespace

TEST(SampleGroups, HoldEachSampleOnceInOrder)
{
  const auto points = makeSphere(20000);
  const SampleGroups groups = groupSamples(points, points, 0.1f);
  ASSERT_EQ(groups.samples.size(), points.size());
  EXPECT_EQ(groups.begins.front(), 0u);
  EXPECT_EQ(groups.begins.back(), points.size());
  for (std::size_t g = 0; g + 1 < groups.begins.size(); ++g)
  {
    EXPECT_LT(groups.begins[g], groups.begins[g + 1]);
    EXPECT_TRUE(std::is_sorted(
      groups.samples.begin() + groups.begins[g], groups.samples.begin() + groups.begins[g + 1]));
  }
  auto sorted = groups.samples;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t n = 0; n < sorted.size(); ++n)
  {
    ASSERT_EQ(sorted[n], n);
  }
}

TEST(SampleGroups, AreNeighborsOnOneSide)
{
  // Two sheets that are much closer than a cube is wide.
  std::vector<glm::vec3> points = makeSphere(10000);
  std::vector<glm::vec3> normals = points;
  for (std::size_t n = 0; n < 10000; ++n)
  {
    points.push_back(0.999f * points[n]);
    normals.push_back(-normals[n]);
  }
  constexpr float edge = 0.15f;
  const SampleGroups groups = groupSamples(points, normals, edge);
  for (std::size_t g = 0; g + 1 < groups.begins.size(); ++g)
  {
    for (std::size_t i = groups.begins[g] + 1; i < groups.begins[g + 1]; ++i)
    {
      const std::uint32_t a = groups.samples[groups.begins[g]];
      const std::uint32_t b = groups.samples[i];
      const glm::vec3 apart = glm::abs(points[a] - points[b]);
      EXPECT_LE(std::max({ apart.x, apart.y, apart.z }), edge);
      EXPECT_EQ(a < 10000, b < 10000) << "the two sides are never in one group";
      EXPECT_GT(glm::dot(normals[a], normals[b]), 0.8f);
    }
  }
}

TEST(SampleGroups, HaveAboutAsManySamplesAsAskedFor)
{
  const std::size_t count = 200000;
  const auto points = makeSphere(count);
  const double area = 4.0 * std::numbers::pi / static_cast<double>(count);
  for (const double wanted : { 4.0, 8.0, 30.0 })
  {
    const SampleGroups groups = groupSamples(points, points, ink::groupEdge(area, wanted));
    const double mean = static_cast<double>(count) / static_cast<double>(groups.begins.size() - 1);
    // Cubes with so few samples that they have none are no groups; directions divide cubes.
    EXPECT_NEAR(mean / wanted, 1.0, 0.2) << "wanted " << wanted << ", found " << mean;
  }
}

TEST(SampleGroups, AreTheSameForAnyNumberOfThreads)
{
  const auto points = makeSphere(100000);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const SampleGroups one = groupSamples(points, points, 0.02f);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  const SampleGroups two = groupSamples(points, points, 0.02f);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(one.samples, two.samples);
  EXPECT_EQ(one.begins, two.begins);
}

TEST(SampleGroups, OfNothingAndOfOneSample)
{
  EXPECT_EQ(groupSamples({}, {}, 1.0f).begins, std::vector<std::size_t>{ 0 });
  const std::vector<glm::vec3> one(1, glm::vec3(3.0f));
  EXPECT_EQ(groupSamples(one, one, 1.0f).begins, (std::vector<std::size_t>{ 0, 1 }));
}
