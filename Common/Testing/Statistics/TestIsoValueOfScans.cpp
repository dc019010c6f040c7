// SPDX-License-Identifier: BSD-3-Clause
// Scans as they come: padded, cropped, without a boundary that is clear.
#include "IsoValueVolumes.h"
#include "Statistics/IsoValue.h"
#include "Statistics/OtsuThreshold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

namespace
{

using namespace ink::testing::iso;
using Boundary = ink::IsoSuggestion::Boundary;

int column(std::size_t i)
{
  return static_cast<int>(i) % size;
}

/// Of the magnitude of a signal without any: of Rayleigh's distribution.
double airOfMR(std::size_t i)
{
  return 14.0 * std::sqrt(-2.0 * std::log(0.5 + 0.4999 * noise(i)));
}

/// Smooth in space, from -1 to 1. @param scale below 1: longer waves
double waves(std::size_t i, double scale = 1.0)
{
  const double x = scale * column(i);
  const double y = scale * (static_cast<int>(i) / size % size);
  const double z = scale * (static_cast<int>(i) / size / size);
  return std::sin(1.1 * x + 0.3 * y) * std::sin(1.2 * y - 0.2 * z) * std::sin(1.3 * z + 0.1 * x);
}

/// From 1 to 0, which it is from a radius on, evenly over a width.
double ramp(double distance, double radius, double width)
{
  return std::clamp((radius - distance) / width, 0.0, 1.0);
}

} // namespace

TEST(IsoValueOfScans, IsNotTheEdgeOfPadding)
{
  // The corners are padded with 0, as where a scan was turned; the rest of the air is noise.
  for (const int farthest : { 18, 20, 22 })
  {
    const auto values = volume<short>(
      [farthest](double d, std::size_t i)
      {
        const int row = static_cast<int>(i) / size % size;
        const bool isPadding = std::abs(column(i) - size / 2) + std::abs(row - size / 2) > farthest;
        return isPadding ? 0.0 : std::max(airOfMR(i), 300.0 * blurredSphere(d, 12) + 8.0 * noise(i));
      });
    const auto suggestion = suggest(values);
    ASSERT_TRUE(suggestion);
    EXPECT_EQ(suggestion->boundary, Boundary::Outermost);
    EXPECT_GT(suggestion->value, 90.0) << farthest;
    EXPECT_LT(suggestion->value, 250.0) << farthest;
  }
}

TEST(IsoValueOfScans, IsThatOfAChestInAPaddedFieldOfView)
{
  // The lungs are as noisy as the air around, and most of what is measured.
  const auto chest = volume<short>(
    [](double d, std::size_t i)
    {
      const double body = 1000.0 * blurredSphere(d, 23) - 850.0 * blurredSphere(d, 20);
      return std::max(-1024.0, -1000.0 + body + (d < 20 ? 110.0 : 30.0) * noise(i));
    });
  for (const short padding : { -1500, -2000, -3024 })
  {
    auto padded = chest;
    for (std::size_t i = 0; i < padded.size(); ++i)
    {
      const int row = static_cast<int>(i) / size % size;
      padded[i] = std::hypot(column(i) - size / 2, row - size / 2) > 22 ? padding : padded[i];
    }
    const auto suggestion = suggest(padded);
    ASSERT_TRUE(suggestion);
    EXPECT_EQ(suggestion->boundary, Boundary::Outermost) << padding;
    EXPECT_GT(suggestion->value, -800.0) << padding;
    EXPECT_LT(suggestion->value, -200.0) << padding;
  }
}

TEST(IsoValueOfScans, AreBoneAfterSkinInCT)
{
  // Spongy bone varies from voxel to voxel, so that it has no clear boundary.
  const auto trunk = [](double unit)
  {
    return suggestAll(volume<short>(
      [unit](double d, std::size_t i)
      {
        const double bone = d < 6 ? 250.0 + 250.0 * noise(i / 3) : 0.0;
        return unit * (-1000.0 + 1040.0 * blurredSphere(d, 18) + bone + 30.0 * noise(i));
      }));
  };
  const auto suggestions = trunk(1.0);
  ASSERT_GE(suggestions.size(), 2U);
  EXPECT_EQ(suggestions[0].boundary, Boundary::Outermost);
  EXPECT_LT(suggestions[0].value, -200.0);
  EXPECT_EQ(suggestions[1].boundary, Boundary::Bone);
  EXPECT_EQ(suggestions[1].value, 200.0);
  EXPECT_NEAR(suggestions[1].keptShare, 0.6 * 4.19 * 6 * 6 * 6 / (size * size * size), 0.004);
  // In other units it is not known where bone is.
  for (const auto& other : trunk(2.0))
  {
    EXPECT_NE(other.boundary, Boundary::Bone);
  }
}

TEST(IsoValueOfScans, IsThatAroundAllWhereNothingElseIsMeasured)
{
  // What a mask leaves of temperatures has no boundary within it.
  const auto masked =
    volume<short>([](double d, std::size_t i) { return d < 15 ? -200.0 + 30.0 * waves(i) : -9999.0; });
  const auto suggestion = suggest(masked);
  ASSERT_TRUE(suggestion);
  EXPECT_LT(suggestion->value, -230.0);
}

TEST(IsoValueOfScans, IsWithinTheBoxThatPaddingLeaves)
{
  // A slab through a head, of which no more is left above and below than 0.
  const auto values = [](auto zero, int thick)
  {
    return volume<decltype(zero)>(
      [zero, thick](double d, std::size_t i)
      {
        const int slice = static_cast<int>(i) / size / size;
        const bool isPadding = std::abs(2 * slice - size + 1) > thick;
        const double value = 400.0 * blurredSphere(d, 14) + 12.0 + 8.0 * noise(i);
        return static_cast<double>(isPadding ? zero : static_cast<decltype(zero)>(value));
      });
  };
  const auto check = [](const std::optional<ink::IsoSuggestion>& found)
  {
    ASSERT_TRUE(found);
    EXPECT_EQ(found->boundary, Boundary::Outermost);
    EXPECT_GT(found->value, 150.0);
    EXPECT_LT(found->value, 280.0);
    EXPECT_LT(found->keptShare, 0.1) << "of all voxels";
    EXPECT_GT(found->keptShare, 0.02);
  };
  check(suggest(values(short(0), 6)));
  check(suggest(values(0.0F, 6)));
}

TEST(IsoValueOfScans, OfABoxOfNoiseIsItsEdge)
{
  const auto found = suggest(volume<short>([](double, std::size_t i)
    { return std::min(column(i), size - 1 - column(i)) < 8 ? 0.0 : 400.0 + 40.0 * noise(i); }));
  ASSERT_TRUE(found);
  EXPECT_GT(found->value, 0.0);
  EXPECT_LT(found->value, 370.0);
}

TEST(IsoValueOfScans, IsNotTheScrapsOfTheBrightestSpots)
{
  // Tissue whose spots are the steeper the brighter they are, and fades towards the air.
  const auto values = volume<unsigned char>(
    [](double d, std::size_t i)
    {
      const double fades = ramp(d, 20.0, 8.0);
      return 2.0 + noise(i) + fades * 25.0 * std::exp(2.2 * waves(i) * waves(i) * waves(i));
    });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_GT(suggestion->keptShare, 0.1);
}

TEST(IsoValueOfScans, IsAnInnerOneWhereAllSidesCutTheOutermost)
{
  // Tissue from side to side, with air and something dense in it, as a cropped chest.
  const auto chest = [](double d, std::size_t i)
  { return -850.0 * blurredSphere(d, 22) + 2800.0 * blurredSphere(d, 9) + 10.0 * noise(i); };
  const std::vector<float> cropped = volume<float>(chest);
  const auto suggestions = suggestAll(cropped);
  ASSERT_EQ(suggestions.size(), 2U);
  EXPECT_EQ(suggestions[0].boundary, Boundary::Densest);
  EXPECT_GT(suggestions[0].value, 0.0);
  EXPECT_LT(suggestions[0].value, 1900.0);
  EXPECT_EQ(suggestions[1].boundary, Boundary::Outermost);
  // The same through slices, and with air at one side alone.
  const std::size_t slice = static_cast<std::size_t>(size) * size;
  const ink::SliceReader<float> read = [&](int first, int last)
  { return std::span<const float>(cropped).subspan(slice * first, slice * (last - first)); };
  EXPECT_EQ(ink::suggestIsoValues(read, cube, 5).front().value, suggestions[0].value);
  std::vector<float> open = cropped;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    open[i] = column(i) < 2 ? -850.0F : open[i];
  }
  EXPECT_EQ(suggest(open)->boundary, Boundary::Outermost);
  // Or between slices that are padded.
  std::vector<float> padded = cropped;
  std::fill_n(padded.begin(), 4 * slice, -1200.0F);
  std::fill_n(padded.rbegin(), 4 * slice, -1200.0F);
  EXPECT_EQ(suggest(padded)->boundary, Boundary::Densest);
  EXPECT_NEAR(suggest(padded)->value, suggestions[0].value, 200.0);
}

TEST(IsoValueOfScans, IsTheOutermostOneThatAllSidesCutWhereOthersKeepNearlyAsMuch)
{
  const auto suggestions = suggestAll(volume<float>(
    [](double d, std::size_t i) {
      return -850.0 * blurredSphere(2.0 * d, 38.4) - 600.0 * blurredSphere(2.0 * d, 43.8) + 10.0 * noise(i);
    }));
  ASSERT_EQ(suggestions.size(), 2U);
  EXPECT_EQ(suggestions[0].boundary, Boundary::Outermost);
  EXPECT_LT(suggestions[0].keptShare, 1.25 * suggestions[1].keptShare);
}

TEST(IsoValueOfScans, OfDensitiesAroundZeroIsNotWhereTheSignChanges)
{
  // As maps of crystals and of molecules: noise around 0, and some blobs above it.
  const auto values =
    volume<float>([](double d, std::size_t i) { return 0.4 * waves(i) + 0.9 * std::exp(-0.02 * d * d); });
  for (const ink::IsoSuggestion& one : suggestAll(values))
  {
    EXPECT_NE(one.boundary, Boundary::Sign);
    EXPECT_GT(one.value, 0.15);
    EXPECT_LT(one.value, 1.0);
  }
}

TEST(IsoValueOfScans, OfTissueWithoutABoundaryIsBelowItsBrightParts)
{
  // Skin without a sharp edge around tissue with bright parts, which Otsu's threshold cuts out.
  const auto values = volume<unsigned char>(
    [](double d, std::size_t i)
    {
      const double skin = ramp(d, 20.0, 4.0);
      const double within = ramp(d, 17.0, 4.0);
      const double w = waves(i);
      return 2.0 + noise(i) + 10.0 * skin + within * (10.0 * (1.0 + w) + 15.0 * std::exp(3.0 * w * w * w));
    });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::None);
  std::vector<std::int64_t> histogram(256);
  for (const unsigned char value : values)
  {
    ++histogram[value];
  }
  const double otsu = ink::otsuThreshold(histogram);
  const auto kept = std::count_if(values.begin(), values.end(), [&](unsigned char v) { return v > otsu; });
  EXPECT_GT(suggestion->keptShare, 1.08 * static_cast<double>(kept) / static_cast<double>(values.size()));
}

TEST(IsoValueOfScans, IsTheSkinWhereTheBrainIsBrighter)
{
  // As in FLAIR: dark bone within dim skin, and a brain with folds, by which steps become larger up to it.
  const auto values = volume<short>(
    [](double d, std::size_t i)
    {
      const double w = waves(i);
      return airOfMR(i) / 3.0 + (60.0 + 70.0 * (1.0 + w)) * ramp(d, 21.0, 3.0) * (1.0 - ramp(d, 18.0, 1.5)) +
        (260.0 + 60.0 * w) * ramp(d, 16.0 + 1.5 * w, 1.5);
    });
  expectBetween(suggest(values), Boundary::Outermost, 10.0, 60.0);
}

TEST(IsoValueOfScans, IsTheSkinWhereNoBoundaryIsClear)
{
  // As the one before, but the skin's brightness varies from 0 on, by which no value has the sharpest edge.
  const auto values = volume<short>(
    [](double d, std::size_t i)
    {
      const double w = waves(i);
      return airOfMR(i) / 3.0 +
        (10.0 + 45.0 * (1.0 + w) * (1.0 + w)) * ramp(d, 21.0, 2.0) * (1.0 - ramp(d, 18.0, 2.0)) +
        (220.0 + 60.0 * w) * ramp(d, 16.0 + 3.0 * w, 4.0);
    });
  expectBetween(suggest(values), Boundary::None, 15.0, 45.0);
}

TEST(IsoValueOfScans, OfVesselsInNoisyTissueIsTheirs)
{
  // As in an angiography, whose threshold by Otsu is between tissue and what is beside it.
  const auto suggestionFor = [](double brightness, double size, double noisy)
  {
    return suggest(volume<short>(
      [&](double d, std::size_t i)
      {
        const double tissue = std::clamp(static_cast<double>(column(i)) / 24.0, 0.0, 1.0);
        return 15.0 + 110.0 * tissue + noisy * noise(i) + brightness * std::exp(-0.5 * d * d / size / size);
      }));
  };
  expectBetween(suggestionFor(500.0, 4.0, 15.0), Boundary::None, 160.0, 400.0);
  const auto glow = suggestionFor(80.0, 12.0, 5.0);
  ASSERT_TRUE(glow);
  EXPECT_EQ(glow->boundary, Boundary::None);
  EXPECT_LT(glow->value, 125.0);
}

TEST(IsoValueOfScans, OfDarkSpotsInWhatIsSaturatedIsBetweenBoth)
{
  // Otsu's threshold leaves one value above it, which cannot be split.
  const auto values = volume<unsigned char>(
    [](double, std::size_t i) { return noise(i) < 0.6 ? 255.0 : 100.0 + 60.0 * noise(i + 1000000); });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_GT(suggestion->value, 100.0);
}

TEST(IsoValueOfScans, OfDifferencesAroundABackgroundOfZeroIsPositive)
{
  // As statistics of a brain, cut out by a mask: no surface is where they change their sign.
  const auto map = [](double d, std::size_t i) { return d > 18.0 ? 0.0 : 4.0 * waves(i) + 0.3 * noise(i); };
  const std::vector<ink::IsoSuggestion> suggestions = suggestAll(volume<float>(map));
  ASSERT_EQ(suggestions.size(), 1U);
  EXPECT_EQ(suggestions.front().boundary, Boundary::None);
  EXPECT_TRUE(suggestions.front().isLobe);
  EXPECT_GT(suggestions.front().value, 0.5);
  EXPECT_LT(suggestions.front().value, 2.0);
  // Of negative ones alone, one is still given.
  const auto negative =
    suggest(volume<float>([&](double d, std::size_t i) { return std::min(map(d, i), 0.0); }));
  ASSERT_TRUE(negative);
  EXPECT_LT(negative->value, 0.0);
}

TEST(IsoValueOfScans, OfFewPositiveValuesAmongNegativeOnesIsPositive)
{
  // The surface around all of them, which has less area, is that of no positive ones.
  const auto suggestion = suggest(volume<float>(
    [](double d, std::size_t i)
    {
      const double g = 2.8 * waves(i, 0.4);
      const double positive = 0.45 * std::pow(std::max(g - 0.71, 0.0), 2.0);
      const double within = 1.0 / (1.0 + std::exp((d - 21.65) / 0.52));
      const double value = within * (positive - 0.91 / (1.0 + std::exp((g - 0.41) / 0.1)));
      return value < 0.01 && within < 0.01 ? 0.0 : value;
    }));
  ASSERT_TRUE(suggestion);
  EXPECT_TRUE(suggestion->isLobe);
  EXPECT_GT(suggestion->value, 0.1);
}
