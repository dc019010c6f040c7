// SPDX-License-Identifier: BSD-3-Clause
#include "ContourTesting.h"

#include "Curves/Contours/GridContours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

using namespace ink::testing;

const double nan = std::numeric_limits<double>::quiet_NaN();

TEST(GridContours, EndsWhereSamplesAreMissing)
{
  auto volume = sampled<float>(cube(33, 2.5), Ball);
  std::vector<std::uint8_t> marks(volume.values.size(), 0);
  for (std::size_t n = 0; n < marks.size(); ++n)
  {
    if (n % 33 < 16)
    {
      marks[n] = 1;
    }
  }
  const Contours hidden =
    GridContours<float>(volume.field({ marks, 1 }), 0.0).find(Eye::along({ 0.0, 0.0, 1.0 }), all);
  for (std::size_t n = 0; n < marks.size(); ++n)
  {
    if (marks[n])
    {
      volume.values[n] =
        n % 2 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    }
  }
  const Contours contours = GridContours<float>(volume.field(), 0.0).find(Eye::along({ 0.0, 0.0, 1.0 }), all);
  expectSame(contours, hidden);
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_FALSE(contours.chains.closed[0]);
  const double border = volume.geometry.toWorld({ 16, 0, 0 }).x;
  EXPECT_NEAR(contours.positions.front().x, border, 1e-12);
  EXPECT_NEAR(contours.positions.back().x, border, 1e-12);
  EXPECT_NEAR(contours.arcLength.back(), pi, 0.1);
  EXPECT_LT(greatestDistance(Circle::of(Ball, Eye::along({ 0.0, 0.0, 1.0 })), contours), 0.05);
  EXPECT_EQ(contours.elements[contours.elements.size() - 1], contours.elements[contours.elements.size() - 2]);
  // Projected, they stay where the field is defined.
  GridContourOptions projected;
  projected.projectionSteps = 4;
  for (const glm::dvec3& p :
    GridContours<float>(volume.field(), 0.0).find(Eye::along({ 0.0, 0.0, 1.0 }), all, projected).positions)
  {
    EXPECT_GE(p.x, border - 1e-12);
  }
}

TEST(GridContours, SelectedCells)
{
  const auto volume = sampled<float>(cube(33, 2.5), Ball);
  const Eye eye = Eye::along({ 0.0, 0.0, 1.0 });
  ink::CellSelection selection;
  selection.begin.x = 16;
  const Contours half = GridContours<float>(volume.field(), 0.0, selection).find(eye, all);
  ASSERT_EQ(half.chains.size(), 1u);
  EXPECT_FALSE(half.chains.closed[0]);
  EXPECT_NEAR(half.arcLength.back(), pi, 0.1);
}

TEST(GridContours, NothingToFind)
{
  const auto expectNone = [](const Contours& contours)
  {
    EXPECT_EQ(contours.chains.size(), 0u);
    EXPECT_TRUE(contours.positions.empty());
    EXPECT_TRUE(contours.elements.empty());
  };
  const auto volume = sampled<float>(cube(33, 2.5), Ball);
  for (const double isoValue : { 10.0, -10.0, nan, std::numeric_limits<double>::infinity() })
  {
    expectNone(GridContours<float>(volume.field(), isoValue).find(BallEyes[0], all));
  }
  // From inside, all of a ball is seen from behind.
  expectNone(GridContours<float>(volume.field(), 0.0).find(Eye::at(Ball.center), all));
  expectNone(GridContours<float>(volume.field(), 0.0).find(Eye::at({ 0.5, 0.3, -0.2 }), all));
  for (const glm::ivec3& n : { glm::ivec3(0), glm::ivec3(1), glm::ivec3(33, 33, 1), glm::ivec3(1, 33, 33) })
  {
    const auto flat = sampled<float>(GridGeometry(n, glm::dvec3(-1.2), glm::dvec3(0.08)), Ball);
    expectNone(GridContours<float>(flat.field(), 0.0).find(BallEyes[0], all));
  }
  const auto constant = Volume<float>(cube(9, 1.0), 3.0f);
  expectNone(GridContours<float>(constant.field(), 3.0).find(BallEyes[0], all));
  expectNone(GridContours<float>(volume.field(), 0.0, {}, nullptr,
    [](double) {
      return false;
    }).find(BallEyes[0], all));
}

TEST(GridContours, TwoSamplesThick)
{
  // A disk of cells: its contour is that of a cylinder, two lines if seen from the side.
  const GridGeometry grid({ 33, 33, 2 }, { -1.25, -1.25, 0.0 }, { 2.5 / 32, 2.5 / 32, 0.1 });
  const auto disk = Volume<float>::from(grid, [](const glm::dvec3& p) { return 1.0 - std::hypot(p.x, p.y); });
  const Contours contours = GridContours<float>(disk.field(), 0.0).find(Eye::along({ 1.0, 0.01, 0.0 }), all);
  ASSERT_EQ(contours.chains.size(), 2u);
  for (const std::size_t chain : { 0u, 1u })
  {
    EXPECT_FALSE(contours.chains.closed[chain]);
    EXPECT_NEAR(contours.arcLength[contours.chains.offsets[chain + 1] - 1], 0.1, 1e-3);
  }
}

TEST(GridContours, SurfaceThroughSamples)
{
  // Integers at an integer iso-value: many nodes at one sample become one point.
  const auto volume = Volume<unsigned char>::from(GridGeometry({ 33, 33, 33 }),
    [](const glm::dvec3& p)
    { return std::max(0.0, 200.0 - 8.0 * (std::abs(p.x - 16) + std::abs(p.y - 16) + std::abs(p.z - 16))); });
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Eye eye = Eye::along(randomDirection(seed));
    const Contours contours = GridContours<unsigned char>(volume.field(), 104.0).find(eye, all);
    EXPECT_GE(contours.chains.size(), 1u);
    for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
    {
      EXPECT_TRUE(contours.chains.closed[chain]);
      for (std::size_t n = contours.chains.offsets[chain] + 1; n < contours.chains.offsets[chain + 1]; ++n)
      {
        EXPECT_NE(contours.positions[n], contours.positions[n - 1]);
      }
    }
  }
}

} // namespace
