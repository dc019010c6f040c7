// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoBoundaries.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

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

} // namespace
