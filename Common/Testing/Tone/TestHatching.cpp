// SPDX-License-Identifier: BSD-3-Clause
// How dark hatching is, and how strokes make that up.
#include "Tone/Hatching/Intensity.h"
#include "Tone/Hatching/StrokeWidth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using ink::hatching::Intensity;
using ink::hatching::StrokeWidth;

namespace
{

/// Bit-reversed: every prefix of strokes at i / count is about evenly spaced.
std::vector<float> ProgressivePriorities(int bits)
{
  const int count = 1 << bits;
  std::vector<float> priorities(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    int reversed = 0;
    for (int bit = 0; bit < bits; ++bit)
    {
      reversed |= ((i >> bit) & 1) << (bits - 1 - bit);
    }
    priorities[static_cast<std::size_t>(i)] =
      (static_cast<float>(reversed) + 0.5f) / static_cast<float>(count);
  }
  return priorities;
}

/// The share of paper that parallel strokes cover, as intervals on a circle.
double Coverage(const StrokeWidth& strokes, float coverage, float allSpacing, int bits)
{
  const std::vector<float> priorities = ProgressivePriorities(bits);
  const double period = static_cast<double>(allSpacing) * static_cast<double>(priorities.size());
  std::vector<std::pair<double, double>> intervals;
  for (std::size_t i = 0; i < priorities.size(); ++i)
  {
    const double half = 0.5 * strokes.width(coverage, allSpacing, priorities[i]);
    const double middle = static_cast<double>(allSpacing) * static_cast<double>(i);
    for (const double shift : { -period, 0.0, period })
    {
      intervals.emplace_back(
        std::clamp(middle - half + shift, 0.0, period), std::clamp(middle + half + shift, 0.0, period));
    }
  }
  std::sort(intervals.begin(), intervals.end());
  double covered = 0.0;
  double end = 0.0;
  for (const auto& [from, to] : intervals)
  {
    covered += std::max(to - std::max(from, end), 0.0);
    end = std::max(end, to);
  }
  return covered / period;
}

} // namespace

TEST(Hatching, TruncationWithoutStep)
{
  EXPECT_EQ(ink::hatching::truncated(0.2f, 0.2f), 0.0f);
  EXPECT_EQ(ink::hatching::truncated(0.1f, 0.2f), 0.0f);
  EXPECT_NEAR(ink::hatching::truncated(0.2001f, 0.2f), 0.0f, 2e-4f);
  EXPECT_FLOAT_EQ(ink::hatching::truncated(0.6f, 0.2f), 0.5f);
  EXPECT_FLOAT_EQ(ink::hatching::truncated(1.0f, 0.2f), 1.0f);
  EXPECT_EQ(ink::hatching::truncated(1.0f, 1.0f), 0.0f) << "level 1: nothing is left";
}

/// The terms and their convex combination, by hand.
TEST(Hatching, IntensityIsConvexCombination)
{
  Intensity intensity{ 0.25f, 0.0f, 0.0f, 0.5f, 1.0f };
  EXPECT_FLOAT_EQ(intensity.tone(0.4f, 0.8f), 0.75f * 0.6f + 0.25f * 0.2f);
  EXPECT_FLOAT_EQ(intensity.tone(0.4f, -0.8f), intensity.tone(0.4f, 0.8f)) << "the cosine's sign";
  EXPECT_FLOAT_EQ(intensity.tone(1.0f, 1.0f), 0.0f) << "full light from the viewer";
  EXPECT_FLOAT_EQ(intensity.tone(0.0f, 0.0f), 1.0f);
  EXPECT_FLOAT_EQ(intensity.tone(1.5f, 1.0f), 0.0f) << "more light than full";
  intensity.diffuseTruncation = 0.2f;
  intensity.silhouetteTruncation = 0.5f;
  EXPECT_FLOAT_EQ(intensity.tone(0.4f, 0.8f), 0.75f * 0.5f);
  EXPECT_FLOAT_EQ(intensity.tone(0.85f, 0.6f), 0.0f) << "highlights stay white";
  intensity.darkest = 0.5f;
  EXPECT_FLOAT_EQ(intensity.tone(0.0f, 0.0f), 0.5f);
}

TEST(Hatching, ToneSliderIsMonotone)
{
  Intensity intensity;
  const auto tone = [&](float bias, float lit)
  {
    intensity.bias = bias;
    return intensity.tone(lit, 0.7f);
  };
  for (const float lit : { 0.1f, 0.4f, 0.7f })
  {
    for (int i = 0; i < 20; ++i)
    {
      EXPECT_LE(tone(0.05f * i, lit), tone(0.05f * (i + 1), lit)) << "bias " << 0.05f * i << ", lit " << lit;
    }
    EXPECT_GT(tone(0.0f, lit), 0.0f);
    EXPECT_LT(tone(1.0f, lit), intensity.darkest);
  }
  intensity.bias = 0.25f;
  // Schlick: bias maps 1/2 to b.
  intensity.silhouetteWeight = 0.0f;
  intensity.diffuseTruncation = 0.0f;
  intensity.darkest = 1.0f;
  EXPECT_FLOAT_EQ(intensity.tone(0.5f, 1.0f), 0.25f);
}

/// Crossed at random, both families together make the tone; both grow with it, without a step.
TEST(Hatching, CrosshatchingMakesTheTone)
{
  for (const float crosshatching : { 0.0f, 0.3f, 0.5f, 1.0f })
  {
    const StrokeWidth strokes{ 6.0f, 0.0f, crosshatching };
    float before[2] = { 0.0f, 0.0f };
    for (int i = 0; i <= 100; ++i)
    {
      const float tone = 0.01f * static_cast<float>(i);
      const float first = strokes.coverage(tone, 0);
      const float second = strokes.coverage(tone, 1);
      EXPECT_NEAR((1.0f - first) * (1.0f - second), 1.0f - tone, 1e-5f) << "tone " << tone;
      EXPECT_TRUE(first >= before[0] - 1e-6f && second >= before[1] - 1e-6f) << "tone " << tone;
      // A square root at the very darkest only.
      EXPECT_LT(std::max(first - before[0], second - before[1]), tone > 0.9f ? 0.2f : 0.04f);
      EXPECT_TRUE(tone > 1.0f - crosshatching || second == 0.0f) << "tone " << tone;
      before[0] = first;
      before[1] = second;
    }
  }
}

/// Parallel strokes cover the tone that is wanted, at any zoom: many strokes in a pixel up to one that is
/// left of all.
TEST(Hatching, SameGrayAtAnyZoom)
{
  for (const float leastWidth : { 0.0f, 1.0f, 4.0f })
  {
    const StrokeWidth strokes{ 6.0f, leastWidth, 0.0f };
    double worst = 0.0;
    for (const float coverage : { 0.03f, 0.1f, 0.2f, 0.4f, 0.6f, 0.8f })
    {
      for (double zoom = 0.05; zoom < 40.0; zoom *= 1.07)
      {
        const double found = Coverage(strokes, coverage, static_cast<float>(6.0 * zoom), 12);
        worst = std::max(worst, std::abs(found / coverage - 1.0));
        EXPECT_NEAR(found / coverage, 1.0, 0.05)
          << "coverage " << coverage << " at zoom " << zoom << ", least width " << leastWidth;
      }
    }
    RecordProperty("worst", std::to_string(worst));
  }
}

/// The last strokes that are left get thinner in the lightest tones, down to nothing: they end in points.
TEST(Hatching, StrokesEndInPoints)
{
  const StrokeWidth strokes{ 6.0f, 3.0f, 0.0f };
  for (const float priority : { 0.0f, 0.004f, 0.01f })
  {
    float before = 0.0f;
    for (float coverage = 0.002f; coverage < 0.1f; coverage += 0.002f)
    {
      const float width = strokes.width(coverage, 0.6f, priority);
      EXPECT_GE(width, before) << "coverage " << coverage << ", priority " << priority;
      EXPECT_LT(width - before, 0.1f) << "coverage " << coverage << ", priority " << priority;
      before = width;
    }
    EXPECT_GT(before, 2.0f) << "priority " << priority;
  }
}

/// Where strokes are dense enough those that are full have the width that the spacing asks for.
TEST(Hatching, WidthsAndNumbers)
{
  const StrokeWidth strokes{ 6.0f, 1.5f, 0.0f };
  EXPECT_FLOAT_EQ(strokes.width(0.5f, 0.6f, 0.0f), 3.0f) << "by width";
  EXPECT_FLOAT_EQ(strokes.width(0.1f, 0.6f, 0.0f), 1.5f) << "no thinner than that, but fewer";
  EXPECT_FLOAT_EQ(strokes.width(0.5f, 0.6f, 0.1f), 1.5f) << "half faded at the fraction that is drawn";
  EXPECT_EQ(strokes.width(0.5f, 0.6f, 0.126f), 0.0f);
  EXPECT_FLOAT_EQ(strokes.width(0.5f, 24.0f, 0.9f), 12.0f) << "wider where all are not enough";
  ink::hatching::SpacingRatios ratios;
  ratios.fill(1.8f);
  EXPECT_FLOAT_EQ(strokes.width(0.5f, 0.6f, 0.0f, ratios), 1.8f * 3.0f) << "wider where they are far apart";
  EXPECT_FLOAT_EQ(strokes.width(0.5f, 0.6f, 0.0f, ratios, -0.1f), 1.2f * 3.0f) << "but not over a silhouette";
  EXPECT_EQ(strokes.width(0.0f, 0.6f, 0.0f), 0.0f);
  EXPECT_EQ(strokes.width(0.5f, 0.0f, 0.0f), 0.0f) << "on edge";
  EXPECT_EQ(strokes.width(0.5f, 3.0f, strokes.mostPriority(3.0f) + 1e-4f), 0.0f);
  EXPECT_GT(strokes.width(0.5f, 3.0f, strokes.mostPriority(3.0f) - 0.01f), 0.0f);
}

/// Nothing pops: from zoom to zoom, and from tone to tone, no stroke's width jumps.
TEST(Hatching, NothingPops)
{
  const StrokeWidth strokes{ 6.0f, 1.0f, 0.5f };
  for (int k = 0; k < 20; ++k)
  {
    const float priority = 0.05f * static_cast<float>(k) + 0.01f;
    float before = strokes.width(0.4f, 0.1f, priority);
    for (float spacing = 0.1f; spacing < 60.0f; spacing *= 1.01f)
    {
      const float now = strokes.width(0.4f, spacing, priority);
      EXPECT_LT(std::abs(now - before), std::max(0.15f, 0.02f * now))
        << "priority " << priority << ", spacing " << spacing;
      before = now;
    }
    before = 0.0f;
    for (float coverage = 0.001f; coverage <= 1.0f; coverage *= 1.01f)
    {
      const float now = strokes.width(coverage, 3.0f, priority);
      EXPECT_LT(std::abs(now - before), 0.1f) << "priority " << priority << ", coverage " << coverage;
      before = now;
    }
  }
}

/// Ratios of positions: as they are at their fractions, between them without a step, and widths by them.
TEST(Hatching, SpacingRatios)
{
  using namespace ink::hatching;
  const SpacingRatios ratios{ 1.0f, 2.0f, 0.5f, 1.5f, 0.7f, 0.9f, 2.0f, 1.2f };
  for (std::size_t i = 0; i < ratios.size(); ++i)
  {
    EXPECT_NEAR(spacingRatio(ratios, spacingFraction(i)), ratios[i], 1e-5f);
    EXPECT_NEAR(spacingRatio(evenSpacing, spacingFraction(i)), 1.0f, 1e-6f);
  }
  EXPECT_FLOAT_EQ(presence(spacingFraction(0), 1.0f), 1.0f) << "all strokes are drawn in full";
  EXPECT_LT(presence(0.99f * spacingFraction(0), 1.0f), 1.0f);
  EXPECT_EQ(spacingRatio(ratios, 1e6f), 1.0f);
  EXPECT_EQ(spacingRatio(ratios, 1e-6f), 1.2f);
  const StrokeWidth strokes{ 6.0f, 0.0f, 0.0f };
  for (float fraction = 4.0f; fraction > 0.01f; fraction /= 1.01f)
  {
    const float ratio = spacingRatio(ratios, fraction);
    EXPECT_LT(std::abs(spacingRatio(ratios, fraction / 1.01f) - ratio), 0.05f) << fraction;
    EXPECT_NEAR(strokes.width(0.4f, 6.0f * fraction, 0.3f * fraction, ratios),
      ratio * strokes.width(0.4f, 6.0f * fraction, 0.3f * fraction), 1e-4f)
      << fraction;
  }
}
