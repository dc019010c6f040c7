// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/OtsuThreshold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{
namespace
{

TEST(OtsuThreshold, LiesInTheMiddleOfWhatSplitsTwoPeaks)
{
  // Any threshold from 2 to 6 splits them alike.
  EXPECT_EQ(otsuThreshold({ 0, 5, 9, 0, 0, 0, 0, 8, 3, 0 }), 4.0);
}

TEST(OtsuThreshold, HasTheGreatestVarianceBetweenItsParts)
{
  const std::vector<std::int64_t> histogram{ 7, 1, 12, 5, 3, 0, 1, 4, 9, 2 };
  // n0 n1 (m1 - m0)^2, summed up directly.
  const auto variance = [&](std::size_t threshold)
  {
    double count[2] = { 0.0, 0.0 };
    double sum[2] = { 0.0, 0.0 };
    for (std::size_t i = 0; i < histogram.size(); ++i)
    {
      count[i > threshold] += static_cast<double>(histogram[i]);
      sum[i > threshold] += static_cast<double>(histogram[i]) * static_cast<double>(i);
    }
    const double difference = sum[1] / count[1] - sum[0] / count[0];
    return count[0] * count[1] * difference * difference;
  };
  double best = 0.0;
  for (std::size_t i = 0; i + 1 < histogram.size(); ++i)
  {
    best = std::max(best, variance(i));
  }
  EXPECT_NEAR(variance(static_cast<std::size_t>(otsuThreshold(histogram))), best, 1e-9 * best);
}

} // namespace
} // namespace ink
