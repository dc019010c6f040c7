// SPDX-License-Identifier: BSD-3-Clause
// Lu et al. 2003, Table 1, row by row, and what goes with it.
#include "Tone/DotCoverage.h"
#include "Tone/HlsColor.h"
#include "Tone/Power.h"
#include "Tone/Stipple/Boundary.h"
#include "Tone/Stipple/Distance.h"
#include "Tone/Stipple/Interior.h"
#include "Tone/Stipple/Lighting.h"
#include "Tone/Stipple/ProjectedSize.h"
#include "Tone/Stipple/Resolution.h"
#include "Tone/Stipple/Silhouette.h"
#include "Tone/Stipple/SmallElements.h"
#include "Tone/Stipple/WarmCool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

TEST(ToneFactors, PowersAreFinite)
{
  EXPECT_FLOAT_EQ(ink::power(0.25f, 0.5f), 0.5f);
  EXPECT_EQ(ink::power(0.0f, 0.0f), 1.0f);
  EXPECT_EQ(ink::power(0.0f, -2.0f), 0.0f);
  EXPECT_EQ(ink::power(-0.3f, 0.5f), 0.0f);
}

TEST(ToneFactors, Boundary)
{
  const ink::stipple::Boundary boundary{ true, 0.25f, 2.0f, 2.0f };
  EXPECT_FLOAT_EQ(boundary.factor(1.0f, 0.0f), 0.25f);
  EXPECT_FLOAT_EQ(boundary.factor(0.5f, 0.5f), 0.5f * (0.25f + 2.0f * 0.25f));
  EXPECT_FLOAT_EQ(boundary.factor(0.0f, 1.0f), 0.0f);
  EXPECT_EQ((ink::stipple::Boundary{ false, 0.25f, 2.0f, 2.0f }).factor(0.5f, 0.5f), 1.0f);
}

TEST(ToneFactors, Silhouette)
{
  const ink::stipple::Silhouette silhouette{ true, 0.1f, 3.0f, 0.5f };
  EXPECT_FLOAT_EQ(silhouette.factor(1.0f, 0.0f), 3.1f);
  EXPECT_FLOAT_EQ(silhouette.factor(1.0f, -1.0f), 0.1f);
  EXPECT_FLOAT_EQ(silhouette.factor(0.5f, -0.25f), 0.5f * (0.1f + 3.0f * 0.5f));
  EXPECT_EQ((ink::stipple::Silhouette{ false, 0.1f, 3.0f, 0.5f }).factor(0.5f, 0.5f), 1.0f);
}

TEST(ToneFactors, Resolution)
{
  const ink::stipple::Resolution resolution{ true, -2.0f, 1.0f };
  EXPECT_FLOAT_EQ(resolution.distanceFactor(3.0f, 3.0f), 1.0f);
  EXPECT_FLOAT_EQ(resolution.distanceFactor(6.0f, 3.0f), 0.25f);
  EXPECT_FLOAT_EQ(resolution.slantFactor(0.4f), 0.4f);
  EXPECT_EQ(resolution.slantFactor(-0.4f), 0.0f);
  EXPECT_EQ((ink::stipple::Resolution{ true, -2.0f, 0.0f }).slantFactor(0.0f), 1.0f);
  const ink::stipple::Resolution off{ false, -2.0f, 1.0f };
  EXPECT_EQ(off.distanceFactor(6.0f, 3.0f) * off.slantFactor(0.4f), 1.0f);
}

TEST(ToneFactors, Distance)
{
  const ink::stipple::Distance distance{ true, 2.0f, 0.5f };
  EXPECT_FLOAT_EQ(distance.factor(-1.0f), 0.0f);
  EXPECT_FLOAT_EQ(distance.factor(0.0f), 1.0f);
  EXPECT_FLOAT_EQ(distance.factor(0.5f), 1.25f);
  EXPECT_FLOAT_EQ(distance.factor(-0.5f), 0.75f);
  EXPECT_FLOAT_EQ(distance.factor(7.0f), 2.0f);
  EXPECT_FLOAT_EQ(distance.sizeFactor(-1.0f), 0.5f);
  EXPECT_EQ((ink::stipple::Distance{ false, 2.0f, 0.5f }).factor(-1.0f), 1.0f);
  EXPECT_EQ((ink::stipple::Distance{ false, 2.0f, 0.5f }).sizeFactor(-1.0f), 1.0f);
}

TEST(ToneFactors, Interior)
{
  const ink::stipple::Interior interior{ true, 2.0f, 0.5f };
  EXPECT_FLOAT_EQ(interior.factor(0.5f), 0.25f);
  EXPECT_FLOAT_EQ(interior.sizeFactor(0.5f), 1.0f - 0.5f * 0.75f);
  EXPECT_EQ((ink::stipple::Interior{ false, 2.0f, 0.5f }).factor(0.0f), 1.0f);
}

TEST(ToneFactors, Lighting)
{
  const ink::stipple::Lighting lighting{ true, 2.0f, 0.5f, false };
  const glm::vec3 normal(0.0f, 0.0f, 1.0f);
  const ink::Light sun{ { 0.0f, std::sqrt(0.75f), 0.5f, 0.0f }, 1.0f };
  EXPECT_NEAR(lighting.lit({ &sun, 1 }, { 1.0f, 2.0f, -3.0f }, normal), 0.25f, 1e-6f);
  EXPECT_FLOAT_EQ(lighting.factor(0.25f), 0.75f);
  // What faces away from the light keeps all of its stipples.
  EXPECT_EQ(lighting.lit({ &sun, 1 }, glm::vec3(0.0f), -normal), 0.0f);
  EXPECT_EQ(lighting.factor(0.0f), 1.0f);
  // A lamp, and more light than full light.
  const ink::Light lamps[2] = { { { 1.0f, 2.0f, 5.0f, 1.0f }, 0.4f }, { { 1.0f, 2.0f, 5.0f, 1.0f }, 3.0f } };
  EXPECT_FLOAT_EQ(lighting.lit({ lamps, 1 }, { 1.0f, 2.0f, -3.0f }, normal), 0.4f);
  EXPECT_EQ(lighting.lit(lamps, { 1.0f, 2.0f, -3.0f }, normal), 1.0f);
  EXPECT_EQ(lighting.lit({}, { 1.0f, 2.0f, -3.0f }, normal), 0.0f);
  // The front-facing rule.
  EXPECT_TRUE(lighting.faces(0.6f));
  EXPECT_FALSE(lighting.faces(0.4f));
  EXPECT_TRUE((ink::stipple::Lighting{ false, 2.0f, 0.5f, false }).faces(-1.0f));
  EXPECT_FLOAT_EQ((ink::stipple::Lighting{ true, 2.0f, 0.5f, true }).factor(0.25f), 0.25f);
  EXPECT_EQ((ink::stipple::Lighting{ false, 2.0f, 0.5f, true }).factor(0.25f), 1.0f);
}

TEST(ToneFactors, MaximumStipplesIsTheProjectedArea)
{
  EXPECT_FLOAT_EQ(ink::stipple::maximumStipples(3.0f, 1.0f, 1.0f), 9.0f);
  EXPECT_FLOAT_EQ(ink::stipple::maximumStipples(3.0f, 6.0f, 1.0f), 0.25f);
  EXPECT_FLOAT_EQ(ink::stipple::maximumStipples(3.0f, 1.0f, 4.0f), 2.25f);
  EXPECT_EQ(ink::stipple::maximumStipples(3.0f, std::numeric_limits<float>::min(), 2.0f), 5e11f);
}

TEST(ToneFactors, ListsAreAsLongAsTheProjectionHasPixels)
{
  EXPECT_EQ(ink::stipple::projectedListLength(3.0f, 1.0f, 64), 9);
  EXPECT_EQ(ink::stipple::projectedListLength(0.5f, 0.2f, 64), 6);
  EXPECT_EQ(ink::stipple::projectedListLength(0.52f, 0.2f, 64), 7);
  EXPECT_EQ(ink::stipple::projectedListLength(0.3f, 1.0f, 64), 1);
  EXPECT_EQ(ink::stipple::projectedListLength(9.0f, 1.0f, 64), 64);
  EXPECT_EQ(ink::stipple::projectedListLength(1.0f, 0.0f, 64), 64);
}

TEST(SmallElements, WeightGrowsAsElementsShrink)
{
  ink::stipple::SmallElements small;
  small.minimumCoverage = 5.0f;
  EXPECT_EQ(small.weight(100.0f), 0.0f);
  EXPECT_EQ(small.weight(5.0f), 0.0f);
  EXPECT_EQ(small.weight(3.0f), 0.5f);
  EXPECT_EQ(small.weight(1.0f), 1.0f);
  EXPECT_EQ(small.weight(0.01f), 1.0f);
}

/// Section 5.2: the number of stipples is the weighted sum of T, with a weight of 1, and the random value,
/// which counts the more the smaller elements are, never more than T does, and adds nothing on average.
TEST(SmallElements, NumberIsTheWeightedSumOfToneAndRandomValue)
{
  const ink::stipple::SmallElements small{ ink::stipple::SmallElements::Way::probability, 9.0f, 0.0f };
  const auto number = [&](float tone, float random, float weight)
  {
    float sum = 0.0f;
    for (int rank = 0; rank < 8; ++rank)
    {
      sum += small.part(tone, rank, random, weight);
    }
    return sum;
  };
  for (const float tone : { 1.2f, 2.5f, 3.9f })
  {
    for (const float weight : { 0.0f, 0.25f, 0.6f, 1.0f })
    {
      double mean = 0.0;
      const int steps = 200;
      for (int i = 0; i < steps; ++i)
      {
        const float random = (static_cast<float>(i) + 0.5f) / steps;
        const float sum = tone + weight * (random - 0.5f);
        EXPECT_EQ(number(tone, random, weight), std::floor(sum + 0.5f))
          << "T " << tone << ", random " << random << ", weight " << weight;
        mean += static_cast<double>(sum) / steps;
      }
      EXPECT_NEAR(mean, tone, 1e-5);
    }
  }
}

/// What the minimum coverage is about: at the defaults parts of stipples are pale ones in elements of any
/// size.
TEST(SmallElements, SizeDoesNotMatterAtTheDefaults)
{
  const auto differ = [](const ink::stipple::SmallElements& small)
  {
    float most = 0.0f;
    for (float tone = 0.0f; tone < 3.0f; tone += 0.05f)
    {
      most = std::max(most, std::abs(small.part(tone, 1, 0.2f, 0.0f) - small.part(tone, 1, 0.2f, 1.0f)));
    }
    return most;
  };
  EXPECT_EQ(differ(ink::stipple::SmallElements()), 0.0f);
  EXPECT_GT(differ({ ink::stipple::SmallElements::Way::intensity, 9.0f, 0.5f }), 0.1f);
  EXPECT_GT(differ({ ink::stipple::SmallElements::Way::probability, 9.0f, 1.0f }), 0.1f);
}

/// In both ways as much ink as the tone asks for, whatever the tone.
TEST(SmallElements, KeepTheTone)
{
  for (float tone : { 0.0f, 0.1f, 0.5f, 0.93f, 1.0f, 2.4f })
  {
    for (auto way :
      { ink::stipple::SmallElements::Way::intensity, ink::stipple::SmallElements::Way::probability })
    {
      for (float fade : { 0.0f, 0.3f, 1.0f })
      {
        const ink::stipple::SmallElements small{ way, 9.0f, fade };
        double sum = 0.0;
        const int steps = 1000;
        for (int i = 0; i < steps; ++i)
        {
          for (int rank = 0; rank < 5; ++rank)
          {
            sum += small.part(tone, rank, (i + 0.5f) / steps, 1.0f);
          }
        }
        EXPECT_NEAR(sum / steps, tone, 2e-3) << "tone " << tone << ", way " << int(way) << ", fade " << fade;
      }
    }
  }
}

TEST(SmallElements, IntensityIsTheFractionAndProbabilityIsAllOrNothing)
{
  const ink::stipple::SmallElements intensity{ ink::stipple::SmallElements::Way::intensity, 9.0f, 0.2f };
  EXPECT_FLOAT_EQ(intensity.part(1.3f, 0, 0.7f, 1.0f), 1.0f);
  EXPECT_NEAR(intensity.part(1.3f, 1, 0.7f, 1.0f), 0.3f, 1e-6f);
  EXPECT_EQ(intensity.part(1.3f, 2, 0.7f, 1.0f), 0.0f);
  const ink::stipple::SmallElements probability{ ink::stipple::SmallElements::Way::probability, 9.0f, 1.0f };
  EXPECT_EQ(probability.part(1.3f, 1, 0.6f, 1.0f), 0.0f);
  EXPECT_EQ(probability.part(1.3f, 1, 0.8f, 1.0f), 1.0f);
  // Large elements: rounded, or faded in.
  EXPECT_EQ((ink::stipple::SmallElements{ ink::stipple::SmallElements::Way::probability, 9.0f, 0.0f })
              .part(1.3f, 1, 0.9f, 0.0f),
    0.0f);
  EXPECT_NEAR(probability.part(1.3f, 1, 0.9f, 0.0f), 0.3f, 1e-6f);
}

/// No ink where there should be none, and never less with a larger tone.
TEST(SmallElements, PartsAreMonotone)
{
  for (auto way :
    { ink::stipple::SmallElements::Way::intensity, ink::stipple::SmallElements::Way::probability })
  {
    for (float weight : { 0.0f, 0.3f, 0.7f, 1.0f })
    {
      for (float random : { 0.0f, 0.4f, 0.999f })
      {
        const ink::stipple::SmallElements small{ way, 9.0f, 0.5f };
        EXPECT_EQ(small.part(0.0f, 0, random, weight), 0.0f);
        float last = 0.0f;
        for (float tone = 0.0f; tone < 3.0f; tone += 0.05f)
        {
          const float now = small.part(tone, 1, random, weight);
          EXPECT_GE(now, last);
          EXPECT_LE(now, small.part(tone, 0, random, weight));
          last = now;
        }
      }
    }
  }
}

TEST(HlsColor, KnownColors)
{
  const auto expectRgb = [](const ink::HlsColor& hls, const glm::vec3& rgb)
  {
    const glm::vec3 found = ink::rgbFromHls(hls);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(found[i], rgb[i], 1e-5f) << "channel " << i << " of hue " << hls.hue;
    }
    const ink::HlsColor back = ink::hlsFromRgb(rgb);
    EXPECT_NEAR(back.lightness, hls.lightness, 1e-5f);
    EXPECT_NEAR(back.saturation, hls.saturation, 1e-5f);
    EXPECT_NEAR(back.hue, hls.hue, 1e-5f);
  };
  expectRgb({ 0.0f, 0.5f, 1.0f }, { 1.0f, 0.0f, 0.0f });
  expectRgb({ 1.0f / 3.0f, 0.5f, 1.0f }, { 0.0f, 1.0f, 0.0f });
  expectRgb({ 2.0f / 3.0f, 0.5f, 1.0f }, { 0.0f, 0.0f, 1.0f });
  expectRgb({ 1.0f / 6.0f, 0.25f, 1.0f }, { 0.5f, 0.5f, 0.0f });
  expectRgb({ 11.0f / 12.0f, 0.5f, 1.0f }, { 1.0f, 0.0f, 0.5f });
  expectRgb({ 0.0f, 0.3f, 0.0f }, { 0.3f, 0.3f, 0.3f });
  expectRgb({ 0.0f, 0.75f, 0.5f }, { 0.875f, 0.625f, 0.625f });
}

TEST(HlsColor, BlendsTheShorterWayAround)
{
  const ink::HlsColor magenta{ 5.0f / 6.0f, 0.2f, 0.4f };
  const ink::HlsColor yellow{ 1.0f / 6.0f, 0.6f, 1.0f };
  const ink::HlsColor middle = ink::mixHls(magenta, yellow, 0.5f);
  EXPECT_NEAR(std::min(middle.hue, 1.0f - middle.hue), 0.0f, 1e-6f);
  EXPECT_NEAR(middle.lightness, 0.4f, 1e-6f);
  EXPECT_NEAR(middle.saturation, 0.7f, 1e-6f);
  EXPECT_FLOAT_EQ(ink::mixHls({ 0.0f, 0.5f, 0.0f }, yellow, 0.3f).hue, yellow.hue);
  EXPECT_FLOAT_EQ(ink::mixHls(yellow, { 0.0f, 0.5f, 0.0f }, 0.3f).hue, yellow.hue);
}

TEST(WarmCool, FollowsLightAndDepth)
{
  ink::stipple::WarmCool colors;
  colors.amount = 1.0f;
  const auto expect = [](const glm::vec3& found, const ink::HlsColor& expected)
  {
    const glm::vec3 rgb = ink::rgbFromHls(expected);
    EXPECT_NEAR(found.r, rgb.r, 1e-5f);
    EXPECT_NEAR(found.g, rgb.g, 1e-5f);
    EXPECT_NEAR(found.b, rgb.b, 1e-5f);
  };
  const glm::vec3 own(0.2f, 0.4f, 0.6f);
  expect(colors.color(own, 1.0f, -1.0f), colors.warm);
  expect(colors.color(own, -1.0f, 1.0f), colors.cool);
  colors.tone = 0.0f;
  colors.distance = 1.0f;
  expect(colors.color(own, -1.0f, 1.0f), colors.warm);
  expect(colors.color(own, 1.0f, -1.0f), colors.cool);
  colors.amount = 0.0f;
  EXPECT_EQ(colors.color(own, 1.0f, 1.0f), own);
  colors.amount = 1.0f;
  colors.distance = 0.0f;
  EXPECT_EQ(colors.color(own, 1.0f, 1.0f), own);
}

TEST(WarmCool, WeighsLightAndDepthAndKeepsAPartOfTheOwnColor)
{
  ink::stipple::WarmCool colors;
  colors.amount = 0.3f;
  colors.tone = 2.0f;
  colors.distance = 1.0f;
  const glm::vec3 own(0.2f, 0.4f, 0.6f);
  const auto expect = [&](float lightCosine, float depth, float warmth)
  {
    const glm::vec3 found = colors.color(own, lightCosine, depth);
    const glm::vec3 blended = ink::rgbFromHls(ink::mixHls(colors.cool, colors.warm, warmth));
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(found[i], 0.7f * own[i] + 0.3f * blended[i], 1e-6f) << lightCosine << ' ' << depth;
    }
  };
  expect(0.5f, -0.2f, (2.0f * 0.75f + 0.4f) / 3.0f);
  expect(-1.0f, 5.0f, 1.0f / 3.0f);
  expect(1.0f, -5.0f, 2.0f / 3.0f);
}

/// The sum of a dot's pixels, averaged over where in a pixel its center lies.
TEST(DotCoverage, AreaIsExactOnAverage)
{
  for (float diameter : { 0.1f, 0.5f, 1.0f, 1.3f, 2.0f, 3.7f, 9.0f })
  {
    const ink::DotShape dot = ink::dotShape(diameter);
    double sum = 0.0;
    const int positions = 32;
    const int reach = 8;
    for (int position = 0; position < positions * positions; ++position)
    {
      const float x = (position % positions + 0.5f) / positions;
      const float y = (position / positions + 0.5f) / positions;
      for (int j = -reach; j <= reach; ++j)
      {
        for (int i = -reach; i <= reach; ++i)
        {
          sum += ink::dotCoverage(dot, std::hypot(i - x, j - y));
        }
      }
    }
    const double area = 0.25 * std::numbers::pi * diameter * diameter;
    EXPECT_NEAR(sum / (positions * positions) / area, 1.0, 2e-3) << "diameter " << diameter;
  }
  EXPECT_EQ(ink::dotShape(0.0f).intensity, 0.0f);
}

TEST(DotCoverage, ThinnedDotsKeepTheirInk)
{
  const float least = 0.03f;
  for (const float intensity : { 0.02f, 0.001f, 3e-5f })
  {
    const std::uint32_t count = 100000;
    double sum = 0.0;
    for (std::uint32_t index = 12345; index < 12345 + count; ++index)
    {
      const float thinned = ink::thinnedIntensity(intensity, least, index);
      EXPECT_TRUE(thinned == 0.0f || thinned == least);
      sum += thinned;
    }
    // As even as whole dots can be.
    EXPECT_NEAR(sum, count * intensity, 3.0 * least) << "intensity " << intensity;
  }
  EXPECT_EQ(ink::thinnedIntensity(0.0f, least, 0), 0.0f);
  EXPECT_EQ(ink::thinnedIntensity(0.0f, 0.0f, 0), 0.0f);
  EXPECT_EQ(ink::thinnedIntensity(least, least, 1), least);
  EXPECT_EQ(ink::thinnedIntensity(0.7f, least, 1), 0.7f);
  EXPECT_EQ(ink::thinnedIntensity(1e-6f, 0.0f, 1), 1e-6f);
}
