// SPDX-License-Identifier: BSD-3-Clause
// Where iso-surfaces of grids end.
#include "ContourTesting.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

using namespace ink::testing;

/// From the nearest of a chain's segments.
double distanceFrom(const Contours& border, const glm::dvec3& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t chain = 0; chain < border.chains.size(); ++chain)
  {
    const std::size_t begin = border.chains.offsets[chain];
    const std::size_t end = border.chains.offsets[chain + 1];
    for (std::size_t n = 0; n < border.chains.segmentCount(chain); ++n)
    {
      const glm::dvec3 a = border.positions[begin + n];
      const glm::dvec3 b = border.positions[begin + n + 1 < end ? begin + n + 1 : begin];
      const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
      least = std::min(least, glm::distance(p, a + t * (b - a)));
    }
  }
  return least;
}

TEST(GridBorder, ClosedSurfacesHaveNone)
{
  const auto floats = sampled<float>(cube(33, 2.5), Ball);
  EXPECT_EQ(GridContours<float>(floats.field(), 0.0).border().chains.size(), 0u);
  const auto bytes = sampled<std::uint8_t>(cube(33, 2.5), Ball, 50.0, 100.0);
  EXPECT_EQ(GridContours<std::uint8_t>(bytes.field(), 100.0).border().chains.size(), 0u);
  EXPECT_EQ(GridContours<float>(floats.field(), 100.0).border().chains.size(), 0u) << "without a surface";
}

/// A ball around a corner of the grid: a quarter of a circle on each of three sides, one line in all.
TEST(GridBorder, CirclesOnTheGridsSides)
{
  const Sphere ball{ glm::dvec3(0.0), 1.0 };
  for (const int samples : { 9, 17, 33 })
  {
    const double step = 1.6 / (samples - 1);
    const GridGeometry grid(glm::ivec3(samples), glm::dvec3(0.0), glm::dvec3(step));
    const auto volume = sampled<double>(grid, ball);
    const Contours border = GridContours<double>(volume.field(), 0.0).border(all);
    ASSERT_EQ(border.chains.size(), 1u);
    EXPECT_TRUE(border.chains.closed[0]);
    EXPECT_EQ(border.kinds[0], ink::ContourKind::Border);
    ASSERT_EQ(border.normals.size(), border.positions.size());
    ASSERT_EQ(border.elements.size(), border.positions.size());
    EXPECT_EQ(border.radialCurvature, std::vector<float>(border.positions.size(), 0.0f));
    double farthest = 0.0;
    for (std::size_t n = 0; n < border.positions.size(); ++n)
    {
      const glm::dvec3& p = border.positions[n];
      EXPECT_EQ(std::min({ p.x, p.y, p.z }), 0.0) << "on a side";
      farthest = std::max(farthest, std::abs(glm::length(p) - 1.0));
      EXPECT_GT(glm::dot(glm::dvec3(border.normals[n]), glm::normalize(p)), 0.97);
      const glm::dvec3 next = border.positions[(n + 1) % border.positions.size()];
      const int cells = samples - 1;
      const auto element = static_cast<int>(border.elements[n]);
      const glm::dvec3 cell(element % cells, element / cells % cells, element / (cells * cells));
      const glm::dvec3 in = glm::abs(grid.toIndex(0.5 * (p + next)) - cell - 0.5);
      EXPECT_LE(std::max({ in.x, in.y, in.z }), 0.5 + 1e-9);
    }
    EXPECT_NEAR(border.arcLength.back() + glm::distance(border.positions.front(), border.positions.back()),
      1.5 * pi, 0.5 * step * step);
    EXPECT_LT(farthest, 0.5 * step * step) << "second order";
  }
}

/// Missing samples, cells that are left out, the grid's border: there silhouettes end, too, and nowhere else.
TEST(GridBorder, SilhouettesEndThere)
{
  const Sphere ball{ { 0.9, 0.1, 0.0 }, 1.0 };
  auto volume = sampled<float>(cube(41, 2.2), ball);
  const glm::ivec3 n = volume.geometry.dimensions();
  volume.at({ 25, 36, 20 }) = std::numeric_limits<float>::quiet_NaN();
  std::vector<std::uint8_t> hidden(volume.values.size(), 0);
  hidden[volume.geometry.offset({ 25, 22, 5 })] = 2;
  std::vector<std::uint8_t> skipped(static_cast<std::size_t>((n.x - 1) * (n.y - 1) * (n.z - 1)), 0);
  for (int x = 25; x < 30; ++x)
  {
    skipped[static_cast<std::size_t>(x + (n.x - 1) * (20 + (n.y - 1) * 35))] = 1;
  }
  ink::CellSelection selection;
  selection.skipped = { skipped, 1 };
  const ink::ElementMarks marks{ hidden, 2 };
  const GridContours<float> finder(volume.field(marks), 0.0, selection);
  const Contours border = finder.border(all);
  EXPECT_EQ(border.chains.size(), 4u);
  for (const std::uint8_t closed : border.chains.closed)
  {
    EXPECT_TRUE(closed);
  }
  int ends = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed)
  {
    const Contours contours = finder.find(Eye::along(randomDirection(seed)));
    for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
    {
      if (!contours.chains.closed[chain])
      {
        ends += 2;
        const auto begin = contours.chains.offsets[chain];
        const auto end = contours.chains.offsets[chain + 1];
        EXPECT_LT(distanceFrom(border, contours.positions[begin]), 1e-9) << seed;
        EXPECT_LT(distanceFrom(border, contours.positions[end - 1]), 1e-9) << seed;
      }
    }
  }
  EXPECT_GT(ends, 100);
}

} // namespace
