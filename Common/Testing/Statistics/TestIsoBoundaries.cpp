// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoBoundaries.h"
#include "Statistics/ThresholdSharpness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

namespace
{

/// Surfaces with an area of 1000 edges from threshold 50 on, and of 700 below.
ink::IsoStatistics holesFrom50(std::int64_t meanStepBelow)
{
  ink::IsoStatistics statistics({ 0.0, 1.0, 100 });
  statistics.voxels.assign(100, 400);
  statistics.voxels[0] = 60000;
  for (std::size_t i = 0; i < statistics.edges.size(); ++i)
  {
    statistics.edges[i] = i < 50 ? 700 : 1000;
    statistics.steps[i] = statistics.edges[i] * (i < 50 ? meanStepBelow : 100);
  }
  return statistics;
}

double mended(const ink::IsoStatistics& statistics)
{
  ink::IsoBoundary boundary{ 60.0, 60, 0.0, 52, 70 };
  ink::mendBoundary(statistics, boundary);
  EXPECT_EQ(boundary.threshold, static_cast<double>(boundary.index));
  return boundary.threshold;
}

TEST(IsoBoundaries, OneWithHolesMovesDownToWhereItIsSomewhatLessSharp)
{
  EXPECT_EQ(mended(holesFrom50(90)), 49.0);
  EXPECT_EQ(mended(holesFrom50(72)), 49.0);
  EXPECT_EQ(mended(holesFrom50(68)), 60.0) << "too far";
}

TEST(IsoBoundaries, OneThatAMaskCutsStaysWhereItIsSharp)
{
  ink::IsoStatistics statistics = holesFrom50(90);
  statistics.maskEdges.assign(statistics.maskEdges.size(), 50);
  EXPECT_EQ(mended(statistics), 49.0) << "as at the sides of a head";
  statistics.maskEdges.assign(statistics.maskEdges.size(), 150);
  EXPECT_EQ(mended(statistics), 60.0);
}

TEST(IsoBoundaries, OneWithHolesStopsAtNoise)
{
  ink::IsoStatistics statistics = holesFrom50(90);
  for (std::size_t i = 0; i < 52; ++i)
  {
    statistics.speckEdges[i] = statistics.edges[i] / 4;
  }
  EXPECT_EQ(mended(statistics), 60.0);
}

/// Steps that become larger up to threshold 85, of a material whose edge is at thresholds 10 to 14, with an
/// area of 700 edges there and of 1000 above.
ink::IsoStatistics brightestAt85(std::int64_t voxelsAbove, std::int64_t stepAtEdge = 60)
{
  ink::IsoStatistics statistics({ 0.0, 1.0, 100 });
  statistics.voxels.assign(100, 600);
  statistics.voxels[0] = 60000;
  for (std::size_t i = 0; i < statistics.edges.size(); ++i)
  {
    const auto at = static_cast<std::int64_t>(i);
    statistics.edges[i] = i < 10 ? 1000 : i < 15 ? 700 : i < 40 ? 1000 : 400;
    const std::int64_t step = i < 85 ? stepAtEdge + (100 - stepAtEdge) * at / 85 : 100 - 4 * (at - 85);
    statistics.steps[i] = statistics.edges[i] * step;
    if (i > 75)
    {
      statistics.voxels[i] = voxelsAbove / 24;
    }
  }
  return statistics;
}

std::vector<double> boundariesOf(const ink::IsoStatistics& statistics)
{
  std::vector<double> thresholds;
  for (const ink::IsoBoundary& one : ink::findBoundaries(statistics, ink::keptShares(statistics.voxels)))
  {
    thresholds.push_back(one.threshold);
  }
  return thresholds;
}

TEST(IsoBoundaries, TheBrightestSpotsAreWithinASurfaceThatIsWhole)
{
  const std::vector<double> found = boundariesOf(brightestAt85(2000));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], 14.0) << "the highest threshold where the area is the least";
  EXPECT_NEAR(found[1], 85.0, 5.0);
  EXPECT_EQ(boundariesOf(brightestAt85(200000)).size(), 1U) << "in what fills the volume";
  EXPECT_EQ(boundariesOf(brightestAt85(2000, 30)).size(), 1U)
    << "vessels are much sharper than what is around";
  ink::IsoStatistics masked = brightestAt85(2000);
  for (std::size_t i = 0; i < 20; ++i)
  {
    masked.maskEdges[i] = masked.edges[i] / 5;
    masked.maskSteps[i] = masked.steps[i] / 5;
  }
  EXPECT_EQ(boundariesOf(masked).size(), 1U) << "the edge of a field of view";
}

/// Steps as above, of something that keeps half of the surface around it.
ink::IsoStatistics halfWithin(std::int64_t stepAtEdge = 20)
{
  ink::IsoStatistics statistics = brightestAt85(0, stepAtEdge);
  statistics.voxels[90] = 40000;
  return statistics;
}

TEST(IsoBoundaries, WhatIsWithinASurfaceIsNotTheOutermost)
{
  const std::vector<double> found = boundariesOf(halfWithin());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], 14.0) << "the highest threshold where the area is the least";
  EXPECT_NEAR(found[1], 85.0, 5.0);
  EXPECT_EQ(boundariesOf(halfWithin(0)).size(), 1U) << "air that varies";
  ink::IsoStatistics most = halfWithin();
  most.voxels[0] += 400000;
  most.voxels[90] = 200000;
  EXPECT_EQ(boundariesOf(most).size(), 1U) << "what keeps most of it is the same";
  ink::IsoStatistics large = halfWithin();
  for (std::size_t i = 0; i < 40; ++i)
  {
    large.edges[i] *= 2;
    large.steps[i] *= 2;
  }
  EXPECT_EQ(boundariesOf(large).size(), 1U) << "lungs have more area";
  ink::IsoStatistics filled = halfWithin();
  filled.voxels[0] = 22000;
  EXPECT_EQ(boundariesOf(filled).size(), 1U) << "noise that fills the volume";
  ink::IsoStatistics high = halfWithin();
  high.voxels[90] = 20000;
  for (std::size_t i = 0; i < 76; ++i)
  {
    const std::int64_t step = high.steps[i] / high.edges[i];
    high.edges[i] = i >= 50 && i < 55 ? 700 : 1000;
    high.steps[i] = high.edges[i] * step;
  }
  EXPECT_EQ(boundariesOf(high).size(), 1U) << "tissue within tissue";
}

TEST(IsoBoundaries, WhatIsSharperThanWhatIsAroundItIsTheOutermostWhereItIsSmall)
{
  ink::IsoStatistics vessels = halfWithin(30);
  vessels.voxels[90] = 10000;
  EXPECT_EQ(boundariesOf(vessels).size(), 1U);
  ink::IsoStatistics fat = halfWithin(60);
  fat.voxels[90] = 10000;
  EXPECT_EQ(boundariesOf(fat).size(), 2U);
}

/// But less than a sixth of it is no brain.
TEST(IsoBoundaries, WhatIsWithinAMaskIsTheOutermost)
{
  const auto masked = [](std::int64_t voxelsWithin)
  {
    ink::IsoStatistics statistics = halfWithin(30);
    statistics.voxels[90] = voxelsWithin;
    for (std::size_t i = 0; i < 20; ++i)
    {
      statistics.maskEdges[i] = statistics.edges[i] / 5;
      statistics.maskSteps[i] = statistics.steps[i] / 5;
    }
    return boundariesOf(statistics).size();
  };
  EXPECT_EQ(masked(40000), 1U);
  EXPECT_EQ(masked(10000), 1U);
  EXPECT_EQ(masked(5000), 2U);
}

TEST(IsoBoundaries, AHazeAroundABoundaryIsNone)
{
  const auto withHaze = [](std::int64_t hazeStep, std::int64_t voxelsInside)
  {
    ink::IsoStatistics statistics({ 0.0, 1.0, 100 });
    statistics.voxels.assign(100, 100);
    statistics.voxels[0] = 60000;
    statistics.voxels[40] = 20000;
    statistics.voxels[90] = voxelsInside;
    for (std::size_t i = 0; i < statistics.edges.size(); ++i)
    {
      const auto at = static_cast<std::int64_t>(i);
      const std::int64_t step = i < 40 ? hazeStep - std::abs(at - 20) / 2 : 100 - 4 * std::abs(at - 60);
      statistics.edges[i] = 1000;
      statistics.steps[i] = 1000 * std::max<std::int64_t>(step, 1);
    }
    return boundariesOf(statistics);
  };
  EXPECT_EQ(withHaze(14, 20000), (std::vector{ 60.0 }));
  EXPECT_EQ(withHaze(60, 20000).size(), 2U) << "as skin around bone";
  EXPECT_EQ(withHaze(14, 500).size(), 2U) << "around something small";
}

/// Of least area up to 35, somewhat more up to 37, 1.2 times as much up to 39, and then so much up to the
/// inner boundary at 80.
std::optional<ink::IsoBoundary> aroundBelow(std::int64_t hill, bool isClear)
{
  ink::IsoStatistics statistics({ 0.0, 1.0, 100 });
  statistics.voxels.assign(100, 400);
  statistics.voxels[0] = 60000;
  for (std::size_t i = 0; i < statistics.edges.size(); ++i)
  {
    statistics.edges[i] = i < 36 ? 1000
      : i < 38                   ? 1050
      : i < 40                   ? std::min<std::int64_t>(1200, hill)
      : i < 75                   ? hill
                                 : 1000;
    statistics.steps[i] = statistics.edges[i] * 100;
  }
  return ink::findSurfaceAround(
    { 80.0, 80, 0.0, 75, 90 }, statistics, ink::keptShares(statistics.voxels), isClear);
}

TEST(IsoBoundaries, AroundAClearOneMoreAreaHasToFollowThanAroundAnUnclearOne)
{
  EXPECT_FALSE(aroundBelow(1220, true));
  const auto unclear = aroundBelow(1220, false);
  ASSERT_TRUE(unclear);
  EXPECT_EQ(unclear->threshold, 37.0) << "half way to the hill";
  const auto clear = aroundBelow(1300, true);
  ASSERT_TRUE(clear);
  EXPECT_EQ(clear->threshold, 39.0);
  EXPECT_FALSE(aroundBelow(1100, false));
}

} // namespace
