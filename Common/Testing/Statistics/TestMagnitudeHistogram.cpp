// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/MagnitudeHistogram.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

std::vector<float> counted(int count, float unit)
{
  std::vector<float> values;
  for (int n = 0; n < count; ++n)
  {
    values.push_back(unit * static_cast<float>(n));
  }
  return values;
}

} // namespace

TEST(MagnitudeHistogram, FindsQuantilesInAnyUnit)
{
  for (const float unit : { 1e-30f, 1.0f, 1e30f })
  {
    ink::MagnitudeHistogram histogram;
    histogram.add(counted(10000, unit));
    for (const double share : { 0.01, 0.25, 0.5, 0.9, 0.99 })
    {
      const double expected = 10000.0 * share * unit;
      EXPECT_LE(histogram.quantile(share), 1.001 * expected) << share << " in " << unit;
      EXPECT_GE(histogram.quantile(share), expected / 1.009) << share << " in " << unit;
    }
    EXPECT_NEAR(histogram.quantile(1.0) / (9999.0f * unit), 1.0, 1.0 / 128.0);
    EXPECT_EQ(histogram.quantile(0.0), 0.0f);
  }
}

TEST(MagnitudeHistogram, FindsQuantilesOfTheUpperPart)
{
  ink::MagnitudeHistogram histogram;
  histogram.add(counted(1000, 1.0f));
  EXPECT_NEAR(histogram.quantile(0.5, 512.0f), 756.0, 756.0 / 100.0);
}

TEST(MagnitudeHistogram, AddsUpInAnyOrder)
{
  const std::vector<float> values = counted(5000, 0.37f);
  ink::MagnitudeHistogram whole;
  whole.add(values);
  ink::MagnitudeHistogram front;
  ink::MagnitudeHistogram back;
  front.add(std::span(values).first(1234));
  back.add(std::span(values).subspan(1234));
  back.add(front);
  EXPECT_EQ(back.count(), whole.count());
  for (double share = 0.0; share <= 1.0; share += 0.01)
  {
    EXPECT_EQ(back.quantile(share), whole.quantile(share));
  }
}

TEST(MagnitudeHistogram, TakesWhatFloatsThereAre)
{
  using Limits = std::numeric_limits<float>;
  ink::MagnitudeHistogram histogram;
  EXPECT_EQ(histogram.quantile(0.5), 0.0f);
  const std::vector<float> odd{ -1.0f, Limits::quiet_NaN(), -0.0f, 0.0f, Limits::infinity(), Limits::max(),
    Limits::denorm_min() };
  histogram.add(odd);
  EXPECT_EQ(histogram.count(), 5u);
  EXPECT_EQ(histogram.quantile(0.3), 0.0f);
  EXPECT_EQ(histogram.quantile(1.0), Limits::infinity());
}

TEST(MagnitudeHistogram, TravelsAsItsBins)
{
  ink::MagnitudeHistogram sent;
  sent.add(counted(5000, 0.37f));
  ink::MagnitudeHistogram received;
  received.setBins(sent.bins());
  EXPECT_EQ(received.count(), sent.count());
  EXPECT_EQ(received.quantile(0.3), sent.quantile(0.3));
  EXPECT_THROW(received.setBins(sent.bins().first(7)), std::invalid_argument);
}
