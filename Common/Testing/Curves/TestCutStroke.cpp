// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "Curves/Strokes/CutStroke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

std::vector<double> EvenArcLengths(int points, double step, double from = 0.0)
{
  std::vector<double> arcLengths;
  for (int i = 0; i < points; ++i)
  {
    arcLengths.push_back(from + step * i);
  }
  return arcLengths;
}

} // namespace

TEST(CutStroke, PartsCoverTheLine)
{
  const std::vector<double> arcLengths = EvenArcLengths(1001, 0.01, 3.0);
  for (std::uint64_t key = 0; key < 100; ++key)
  {
    const std::vector<std::size_t> cuts = ink::cutStroke(arcLengths, 1.25, key);
    ASSERT_EQ(cuts.size(), 9u) << "8 strokes, key " << key;
    EXPECT_EQ(cuts.front(), 0u);
    EXPECT_EQ(cuts.back(), 1000u);
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      const double length = arcLengths[cuts[i]] - arcLengths[cuts[i - 1]];
      EXPECT_TRUE(length >= 0.2 * 1.25 - 0.011 && length <= 1.8 * 1.25 + 0.011)
        << "stroke " << i << " of key " << key << " is " << length << " long";
    }
  }
}

/// A stroke goes on to the next point after its cut: by its last segment it may be longer.
TEST(CutStroke, UnevenSegments)
{
  constexpr std::size_t segments = 400;
  double longest = 0.0;
  double longestToLastSegment = 0.0;
  for (std::uint64_t key = 0; key < 300; ++key)
  {
    std::vector<double> arcLengths{ 0.0 };
    for (std::size_t i = 0; i < segments; ++i)
    {
      arcLengths.push_back(arcLengths.back() + std::pow(ink::unitDouble(ink::hash(key, i)), 8.0));
    }
    const double mean = arcLengths.back() / segments;
    for (const double wanted : { 0.1 * mean, 2.0 * mean, 10.0 * mean })
    {
      const double counted = std::max(wanted, mean);
      const std::vector<std::size_t> cuts = ink::cutStroke(arcLengths, wanted, key);
      for (std::size_t i = 1; i < cuts.size(); ++i)
      {
        const double begin = arcLengths[cuts[i - 1]];
        longest = std::max(longest, (arcLengths[cuts[i]] - begin) / counted);
        longestToLastSegment = std::max(longestToLastSegment, (arcLengths[cuts[i] - 1] - begin) / counted);
      }
    }
  }
  EXPECT_LT(longestToLastSegment, 1.8);
  EXPECT_GT(longestToLastSegment, 1.7) << "no less than that is sure";
  EXPECT_GT(longest, 2.7) << "with the last segment";
}

/// Ends of neighboring lines lie anywhere.
TEST(CutStroke, KeysDiffer)
{
  const std::vector<double> arcLengths = EvenArcLengths(1001, 0.01);
  std::size_t least = 1000;
  std::size_t most = 0;
  for (std::uint64_t key = 0; key < 200; ++key)
  {
    const std::size_t cut = ink::cutStroke(arcLengths, 5.0, key)[1];
    least = std::min(least, cut);
    most = std::max(most, cut);
  }
  EXPECT_TRUE(least >= 299 && least < 320 && most > 680 && most <= 701) << least << " to " << most;
  EXPECT_EQ(ink::cutStroke(arcLengths, 5.0, 7), ink::cutStroke(arcLengths, 5.0, 7));
}

TEST(CutStroke, Extremes)
{
  const auto cut = [](const std::vector<double>& arcLengths, double length)
  { return ink::cutStroke(arcLengths, length, 0); };
  EXPECT_TRUE(cut({}, 1.0).empty());
  EXPECT_EQ(cut({ 2.0 }, 1.0), (std::vector<std::size_t>{ 0 }));
  EXPECT_EQ(cut({ 0.0, 10.0 }, 1.0), (std::vector<std::size_t>{ 0, 1 })) << "no points between";
  EXPECT_EQ(cut({ 0.0, 1.0, 2.0 }, 0.0), (std::vector<std::size_t>{ 0, 2 })) << "not cut";
  EXPECT_EQ(cut({ 0.0, 1.0, 2.0 }, 2.0), (std::vector<std::size_t>{ 0, 2 })) << "short enough";
  EXPECT_EQ(cut({ 0.0, 0.0, 0.0 }, 1.0), (std::vector<std::size_t>{ 0, 2 })) << "no length";
  const std::size_t many = cut({ 0.0, 1.0, 2.0, 3.0 }, 1e-300).size();
  EXPECT_TRUE(many >= 3 && many <= 4) << "as many as there are segments, or fewer: " << many;
}
