// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/MaterialValues.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{

/// A peak of 1000 on a floor of 10, over 100 bins.
std::vector<std::int64_t> peakAt(double center, double deviation)
{
  std::vector<std::int64_t> histogram(100);
  for (std::size_t i = 0; i < histogram.size(); ++i)
  {
    const double z = (static_cast<double>(i) - center) / deviation;
    histogram[i] = 10 + std::llround(1000 * std::exp(-0.5 * z * z));
  }
  return histogram;
}

TEST(MaterialValues, AreTheMiddlesOfPeaks)
{
  for (const double center : { 30.0, 47.25, 70.0 })
  {
    for (const bool atEnd : { false, true })
    {
      const auto found = ink::findMaterialValue(peakAt(center, 4.0), { 0, 100 }, atEnd);
      ASSERT_TRUE(found) << center;
      EXPECT_NEAR(*found, center, 0.5);
    }
  }
  EXPECT_NEAR(ink::findMaterialValue(peakAt(47.0, 4.0), { 20, 90 }, false).value_or(0.0), 47.0, 0.5);
}

TEST(MaterialValues, AreNotFoundBesideTheBoundary)
{
  // What falls off from the boundary on has no peak of its own.
  EXPECT_FALSE(ink::findMaterialValue(peakAt(0.0, 30.0), { 0, 100 }, false));
  EXPECT_FALSE(ink::findMaterialValue(peakAt(99.0, 30.0), { 0, 100 }, true));
  EXPECT_TRUE(ink::findMaterialValue(peakAt(99.0, 30.0), { 0, 100 }, false));
  EXPECT_TRUE(ink::findMaterialValue(peakAt(0.0, 30.0), { 0, 100 }, true));
  EXPECT_FALSE(ink::findMaterialValue(peakAt(50.0, 1e3), { 0, 100 }, false)) << "a peak that hardly rises";
}

TEST(MaterialValues, NeedBinsAndVoxels)
{
  EXPECT_FALSE(ink::findMaterialValue(peakAt(53.0, 1.0), { 50, 57 }, false));
  EXPECT_FALSE(ink::findMaterialValue(peakAt(53.0, 1.0), { 50, 50 }, false));
  EXPECT_FALSE(ink::findMaterialValue(std::vector<std::int64_t>(100), { 0, 100 }, false));
}

} // namespace
