// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Periodogram.h"

#include <glm/gtc/constants.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace
{

constexpr int length = 150;

/// Noise beside what `of` says of each place.
template <class Of>
void addSeries(ink::Periodogram& periodogram, std::size_t begin, const Of& of)
{
  std::minstd_rand random(static_cast<unsigned int>(begin + 1));
  std::normal_distribution<double> noise(0.0, 0.2);
  std::vector<double> values;
  for (std::size_t i = begin; i < begin + length; ++i)
  {
    values.push_back(3.0 + of(static_cast<double>(i)) + noise(random));
  }
  periodogram.add(begin, values);
}

} // namespace

TEST(Periodogram, FindsWhatRepeats)
{
  for (const double period : { 2.3, 4.0, 5.27, 9.0 })
  {
    ink::Periodogram periodogram;
    for (const std::size_t begin : { 0U, 7U, 40U })
    {
      addSeries(
        periodogram, begin, [&](double i) { return std::cos(2.0 * glm::pi<double>() * (i - 1.5) / period); });
    }
    const auto peak = periodogram.findPeak(0.1, 0.5, length);
    EXPECT_NEAR(1.0 / peak.frequency, period, 0.01 * period);
    EXPECT_GT(peak.prominence, 100.0) << period;
    EXPECT_NEAR(periodogram.firstMaximum(1.0 / period), 1.5, 0.1) << period;
    EXPECT_NEAR(peak.amplitude, 1.0, 0.05) << period;
  }
}

TEST(Periodogram, WhatJumpsIsFoundOnceNotAtItsMultiples)
{
  ink::Periodogram periodogram;
  addSeries(periodogram, 0, [](double i) { return std::fmod(i, 7.0) < 0.5 ? 4.0 : 0.0; });
  EXPECT_NEAR(1.0 / periodogram.findPeak(0.1, 0.5, length).frequency, 7.0, 0.05);
}

TEST(Periodogram, SeriesNeedNotRepeatAtTheSamePlaces)
{
  ink::Periodogram periodogram;
  for (const double shift : { 0.0, 2.5 })
  {
    addSeries(
      periodogram, 0, [=](double i) { return std::cos(2.0 * glm::pi<double>() * (i - shift) / 5.0); });
  }
  EXPECT_NEAR(1.0 / periodogram.findPeak(0.1, 0.5, length).frequency, 5.0, 0.05);
}

TEST(Periodogram, NothingRepeatsInNoise)
{
  ink::Periodogram periodogram;
  EXPECT_EQ(periodogram.findPeak(0.1, 0.5, length).prominence, 0.0);
  EXPECT_EQ(periodogram.power(0.2), 0.0);
  for (const std::size_t begin : { 0U, 1U, 2U, 3U, 4U })
  {
    addSeries(periodogram, begin, [](double) { return 0.0; });
  }
  EXPECT_LT(periodogram.findPeak(0.1, 0.5, length).prominence, 12.0);
}
