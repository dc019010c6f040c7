// SPDX-License-Identifier: BSD-3-Clause
// Iso-values of volumes whose noise hides boundaries, or looks like one.

#include "IsoValueVolumes.h"
#include "Statistics/IsoValue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace
{

using namespace ink::testing::iso;
using Boundary = ink::IsoSuggestion::Boundary;

TEST(IsoValueOfNoise, IsNotThatOfTheAir)
{
  // Half as strong as the object: most intersected edges belong to noise at every value up to 50.
  const auto values =
    volume<float>([](double d, std::size_t i) { return 100 * blurredSphere(d, 14) + 25 * (1 + noise(i)); });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_GT(suggestion->value, 50.0);
  EXPECT_LT(suggestion->value, 100.0);
}

TEST(IsoValueOfNoise, FindsBoundariesThatNoiseHides)
{
  // A fifth of the lower step, as a standard deviation: the sum of three numbers in [-1, 1] has one of 1.
  const auto noisy = [](std::size_t i) { return noise(3 * i) + noise(3 * i + 1) + noise(3 * i + 2); };
  const auto values = volume<unsigned char>(
    [&](double d, std::size_t i)
    {
      return std::clamp(
        60 + 80 * blurredSphere(d, 20) + 80 * blurredSphere(d, 10) + 16 * noisy(i), 0.0, 255.0);
    });
  const auto all = suggestAll(values);
  ASSERT_GE(all.size(), 1U);
  EXPECT_EQ(all[0].boundary, Boundary::Outermost);
  EXPECT_NEAR(all[0].value, 100.0, 6.0);
  EXPECT_NEAR(all[0].keptShare, 4.0 / 3.0 * 3.14159265 * std::pow(20.0 / size, 3), 0.03);
  const ink::SliceReader<unsigned char> read = [&](int first, int last)
  { return std::span(values).subspan(first * size * size, (last - first) * size * size); };
  const auto parts = ink::suggestIsoValues(read, cube, 7);
  ASSERT_EQ(parts.size(), all.size());
  EXPECT_EQ(parts[0].value, all[0].value);
}

TEST(IsoValueOfNoise, IsNotHalfWayFromAirToLungs)
{
  // A low dose: that half way is one standard deviation of the noise from the air.
  const auto values = volume<short>(
    [](double d, std::size_t i)
    {
      const double noisy = noise(3 * i) + noise(3 * i + 1) + noise(3 * i + 2);
      return std::max(-1000 + 1000 * blurredSphere(d, 21) - 830 * blurredSphere(d, 15) + 90 * noisy, -1024.0);
    });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::Outermost);
  EXPECT_NEAR(suggestion->value, -450.0, 150.0);
}

TEST(IsoValueOfNoise, IsAroundTheSkinOfANoisyHead)
{
  // An MR head: the lowest boundary, to a dark layer under the skin, is hidden by the noise of the air, whose
  // magnitudes are measured; that of the brain within is clear.
  const auto values = volume<short>(
    [](double d, std::size_t i)
    {
      const double tissue = 160 * blurredSphere(d, 22) + 340 * blurredSphere(d, 17);
      const auto noisy = [i](std::size_t n)
      { return 28 * (noise(6 * i + n) + noise(6 * i + n + 1) + noise(6 * i + n + 2)); };
      return std::hypot(tissue + noisy(0), noisy(3));
    });
  const auto all = suggestAll(values);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NEAR(all[0].value, 100.0, 30.0);
  EXPECT_NEAR(all[0].keptShare, 4.0 / 3.0 * 3.14159265 * std::pow(22.0 / size, 3), 0.03);
  EXPECT_NEAR(all[1].value, 330.0, 70.0);
}

TEST(IsoValueOfNoise, LeavesASurfaceOfManyTissuesWhole)
{
  // As in MR: higher values cut the dark tissues out, with as sharp a surface and more of it.
  const auto values = volume<float>(
    [](double d, std::size_t i)
    {
      const auto wave = [](std::size_t at) { return std::sin(0.9 * static_cast<double>(at)); };
      const double tissue = 60 + 40 * wave(i % size) * wave(i / size % size) * wave(i / size / size);
      return tissue * blurredSphere(d, 20) + 2 * noise(i);
    });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_GT(suggestion->keptShare, 0.95 * 4.0 / 3.0 * 3.14159265 * std::pow(20.0 / size, 3));
}

} // namespace
