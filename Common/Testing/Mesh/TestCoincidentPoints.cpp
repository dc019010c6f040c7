// SPDX-License-Identifier: BSD-3-Clause
// Points that are one but for rounding: against comparing all with all, and very many at one position.

#include "Mesh/CoincidentPoints.h"

#include "Core/Hash.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace
{

using namespace ink;

std::vector<std::uint32_t> allOf(const std::vector<glm::dvec3>& points)
{
  std::vector<std::uint32_t> named(points.size());
  std::iota(named.begin(), named.end(), 0u);
  return named;
}

} // namespace

TEST(CoincidentPoints, AreThoseThatRoundingMovedApart)
{
  // Up to five copies of positions that are farther from each other, each moved by less than half of it.
  constexpr double distance = 1e-6;
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> expected;
  const auto random = [](std::uint64_t a, std::uint64_t b) { return unitDouble(hash(1, a, b)); };
  for (std::uint64_t i = 0; i < 4000; ++i)
  {
    // Sites in planes of a coarse grid, in which faces of boxes lie.
    const std::uint64_t site = hash(2, i) % 1000;
    const glm::dvec3 at(static_cast<double>(site % 10), static_cast<double>(site / 10 % 10),
      1e7 + static_cast<double>(site / 100));
    points.push_back(
      at + 0.45 * distance * (2.0 * glm::dvec3(random(i, 3), random(i, 4), random(i, 5)) - 1.0));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::uint32_t first = 0;
    while (glm::distance(points[first], points[i]) > 0.5)
    {
      ++first;
    }
    expected.push_back(first);
  }
  EXPECT_EQ(coincidentPoints(points, allOf(points), distance), expected);
  // Of some points only, in any order.
  std::vector<std::uint32_t> named = allOf(points);
  std::reverse(named.begin(), named.end());
  std::reverse(expected.begin(), expected.end());
  EXPECT_EQ(coincidentPoints(points, named, distance), expected);
  EXPECT_EQ(coincidentPoints(points, std::vector<std::uint32_t>{ 7, 9 }, 100.0 * distance).size(), 2u);
}

TEST(CoincidentPoints, WhatIsFartherApartDoesNot)
{
  const std::vector<glm::dvec3> points = { { 0.0, 0.0, 0.0 }, { 0.9, -0.9, 0.9 }, { 1.1, 0.0, 0.0 },
    { 0.0, 0.0, -1.01 } };
  EXPECT_EQ(coincidentPoints(points, allOf(points), 1.0), (std::vector<std::uint32_t>{ 0, 0, 2, 3 }));
  EXPECT_EQ(coincidentPoints(points, allOf(points), 0.0), allOf(points));
  EXPECT_TRUE(coincidentPoints(points, {}, 1.0).empty());
  EXPECT_DOUBLE_EQ(coincidenceDistance({ 0.0, 0.0, 1.0 }, { 1.0, 5.0, 2.0 }), 5e-6);
}

/// Each is compared with one, not with all.
TEST(CoincidentPoints, ManyAtOnePosition)
{
  const std::vector<glm::dvec3> points(1'000'000, glm::dvec3(0.1, 0.2, 0.3));
  const std::vector<std::uint32_t> found = coincidentPoints(points, allOf(points), 1e-6);
  EXPECT_TRUE(std::all_of(found.begin(), found.end(), [](std::uint32_t first) { return first == 0; }));
}
