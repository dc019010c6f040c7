// SPDX-License-Identifier: BSD-3-Clause
// Estimates of known noise.

#include "AnalyticFields.h"
#include "HashNoise.h"
#include "SampledMeshes.h"
#include "SampledVolume.h"
#include "Statistics/NoiseEstimate.h"
#include "VolumeFraction.h"

#include <glm/common.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace
{

using namespace ink::testing;
using ink::estimateNoise;
using ink::GridGeometry;

GridGeometry centered(int n, const glm::dvec3& spacing = glm::dvec3(1.0))
{
  return GridGeometry(glm::ivec3(n), -0.5 * spacing * (n - 1.0), spacing);
}

/// `low` outside and `low` + `step` inside, blurred by .7 voxels, with noise.
template <class T, class Shape>
Volume<T> blurred(const GridGeometry& geometry, const Shape& shape, double low, double step, double noise)
{
  std::uint64_t n = 0;
  return Volume<T>::from(geometry,
    [&](const glm::dvec3& p)
    {
      const double value =
        low + step * 0.5 * std::erfc(shape.distance(p) / 0.99) + noise * hashNormal(3, n++);
      return std::is_integral_v<T> ? std::round(value) : value;
    });
}

TEST(NoiseEstimate, DoesNotDependOnThreads)
{
  const Volume<float> volume = blurred<float>(centered(56), Sphere{ glm::dvec3(0.3), 16.0 }, 0.0, 1.0, 0.05);
  const auto run = [&]
  {
    const ink::NoiseEstimate found = estimateNoise(volume.field(), 0.5);
    return std::array{ found.noise, found.quantum, found.step, found.thickness, found.keeping,
      found.sharpness };
  };
  EXPECT_EQ(ink::test::onThreads(1, run), ink::test::onThreads(3, run));
}

TEST(NoiseEstimate, IsTheSameFromAFewSlicesAtATime)
{
  // Not all samples are looked at. A wall along the slices over a block: so few that counting fewer of its
  // samples on one side would hide that it is thin. And a missing sample.
  const GridGeometry geometry({ 90, 80, 71 }, glm::dvec3(-44.5, -39.5, -35.0));
  const auto check = [&]<class T>(Volume<T> volume)
  {
    const ink::NoiseEstimate whole = estimateNoise(volume.field(), 0.5);
    EXPECT_EQ(whole.thickness, 4.0);
    const std::size_t slice = 90 * 80;
    for (const int atOnce : { 10, 13, 70, 71, 100 })
    {
      int calls = 0;
      const ink::SliceReader<T> read = [&](int first, int last)
      {
        ++calls;
        EXPECT_LE(last - first, atOnce);
        const std::span<const T> all(volume.values);
        return all.subspan(
          static_cast<std::size_t>(first) * slice, static_cast<std::size_t>(last - first) * slice);
      };
      const ink::NoiseEstimate found = estimateNoise(read, { 90, 80, 71 }, atOnce, 0.5);
      EXPECT_EQ(found.noise, whole.noise) << atOnce;
      EXPECT_EQ(found.step, whole.step) << atOnce;
      EXPECT_EQ(found.quantum, whole.quantum) << atOnce;
      EXPECT_EQ(found.thickness, whole.thickness) << atOnce;
      EXPECT_EQ(found.keeping, whole.keeping) << atOnce;
      EXPECT_EQ(found.roughness, whole.roughness) << atOnce;
      EXPECT_EQ(found.bend, whole.bend) << atOnce;
      EXPECT_EQ(calls, atOnce >= 71 ? 1 : atOnce == 70 ? 2 : atOnce == 13 ? 18 : 69) << atOnce;
    }
  };
  struct
  {
    double distance(const glm::dvec3& p) const
    {
      const double wall = std::max(std::abs(p.z - 11.5) - 2.0, p.x + 19.0);
      return std::min(wall, p.z + 12.4);
    }
  } wall;
  Volume<float> volume = blurred<float>(geometry, wall, 0.0, 1.0, 0.03);
  volume.values[90 * 80 * 35 + 90 * 40 + 45] = std::numeric_limits<float>::quiet_NaN();
  check(volume);
  check(blurred<std::int16_t>(geometry, wall, -20.0, 40.0, 1.0));
  const ink::SliceReader<float> unread = [](int, int) { return std::span<const float>(); };
  EXPECT_THROW(estimateNoise(unread, { 90, 80, 71 }, 9, 0.5), std::invalid_argument);
}

TEST(NoiseEstimate, FindsKnownNoiseWithin10Percent)
{
  const Torus thin{ 20.0, 1.5 };
  const Sphere ball{ glm::dvec3(0.3), 16.0 };
  for (const double noise : { 0.02, 0.05, 0.1 })
  {
    const auto check = [&](const ink::NoiseEstimate& found, double step)
    {
      EXPECT_NEAR(found.noise, noise * step, 0.1 * noise * step) << noise;
      EXPECT_NEAR(found.step, step, 0.1 * step) << noise;
    };
    check(estimateNoise(blurred<float>(centered(56), ball, 0.0, 1.0, noise).field(), 0.5), 1.0);
    check(
      estimateNoise(blurred<std::int16_t>(centered(56), ball, -1000.0, 2000.0, 2000.0 * noise).field(), 0.0),
      2000.0);
    check(estimateNoise(blurred<std::uint8_t>(centered(56), ball, 50.0, 140.0, 140.0 * noise).field(), 120.0),
      140.0);
    // A tube of three voxels does not reach the whole step.
    const auto found = estimateNoise(blurred<float>(centered(56), thin, 0.0, 1.0, noise).field(), 0.5);
    EXPECT_NEAR(found.noise, noise, 0.1 * noise) << "around a thin tube";
  }
}

TEST(NoiseEstimate, NothingIsFoundInCleanValues)
{
  const auto volume = blurred<float>(centered(48), Sphere{ glm::dvec3(0.2), 15.0 }, 0.0, 1.0, 0.0);
  const ink::NoiseEstimate found = estimateNoise(volume.field(), 0.5);
  EXPECT_LT(found.noise, 0.002);
  EXPECT_EQ(found.quantum, 0.0);
  EXPECT_EQ(ink::suggestSmoothing(found, glm::dvec3(1.0)), 0.0);
}

TEST(NoiseEstimate, VolumeFractionsAreSharp)
{
  const Sphere ball{ glm::dvec3(0.3), 15.0 };
  const auto fractions = [&](double low, double step, double noise)
  {
    std::uint64_t n = 0;
    return Volume<float>::from(centered(48),
      [&](const glm::dvec3& p)
      { return low + step * (volumeFraction(ball, p) + noise * hashNormal(3, n++)); });
  };
  for (const double noise : { 0.0, 0.02 })
  {
    const ink::NoiseEstimate found = estimateNoise(fractions(-3.0, 8.0, noise).field(), 1.0);
    EXPECT_NEAR(found.sharpness, 0.62, 0.04) << noise;
    EXPECT_FALSE(found.labels);
    EXPECT_EQ(ink::suggestSmoothing(found, glm::dvec3(1.0)), ink::sharpSmoothing) << noise;
  }
  const ink::NoiseEstimate scan =
    estimateNoise(blurred<float>(centered(48), ball, 0.0, 1.0, 0.0).field(), 0.5);
  EXPECT_NEAR(scan.sharpness, 0.38, 0.03);
  EXPECT_EQ(ink::suggestSmoothing({ .step = 1.0, .thickness = 2.0, .sharpness = 0.6 }, glm::dvec3(1.0)), 1.0)
    << "thin parts";
  EXPECT_EQ(ink::suggestSmoothing({ .step = 1.0, .sharpness = 0.5 }, glm::dvec3(1.0)), 0.0) << "a sharp scan";
}

TEST(NoiseEstimate, MasksThatCutThroughAGradualTransitionShowTheGrid)
{
  // A ball that fades over eight voxels, and beyond half of it is 0, as means of many brains are masked.
  const Sphere ball{ glm::dvec3(0.2), 15.0 };
  const auto fading = [&](double masked)
  {
    return Volume<float>::from(centered(48),
      [&](const glm::dvec3& p)
      {
        const double value = std::clamp(0.5 - ball.distance(p) / 8.0, 0.0, 1.0);
        return value < masked ? 0.0 : value;
      });
  };
  const ink::NoiseEstimate whole = estimateNoise(fading(0.0).field(), 0.6);
  EXPECT_EQ(whole.cut, 0.0);
  EXPECT_EQ(ink::suggestSmoothing(whole, glm::dvec3(1.0)), 0.0);
  const ink::NoiseEstimate cut = estimateNoise(fading(0.5).field(), 0.6);
  EXPECT_LT(cut.sharpness, 0.55) << "not by that";
  EXPECT_GT(cut.cut, 0.7);
  EXPECT_FALSE(cut.labels);
  EXPECT_EQ(ink::suggestSmoothing(cut, glm::dvec3(1.0)), ink::sharpSmoothing);
  EXPECT_EQ(ink::suggestSmoothing({ .step = 1.0, .sharpness = 0.4, .cut = 0.4 }, glm::dvec3(1.0)), 0.0)
    << "here and there";
  EXPECT_EQ(ink::suggestSmoothing(
              { .step = 1.0, .usualThickness = 4.0, .sharpness = 0.4, .cut = 0.8 }, glm::dvec3(1.0)),
    0.0)
    << "thin parts";
}

TEST(NoiseEstimate, TiltedSlicesThatWereResampledShowTheGrid)
{
  // Each sample is that of the nearest slice; slices are three samples apart, and aligned with no axis.
  const Sphere ball{ glm::dvec3(0.2), 20.0 };
  const glm::dvec3 across = glm::normalize(glm::dvec3(0.2, 0.3, 1.0));
  const auto sliced = [&](double distance)
  {
    return Volume<float>::from(centered(64),
      [&](const glm::dvec3& p)
      {
        const double height = glm::dot(p, across);
        const double slice = distance > 0.0 ? distance * std::round(height / distance) : height;
        return 0.5 * std::erfc(ball.distance(p + (slice - height) * across) / (0.7 * std::sqrt(2.0)));
      });
  };
  const ink::NoiseEstimate whole = estimateNoise(sliced(0.0).field(), 0.5);
  EXPECT_LT(whole.roughness, 0.1);
  EXPECT_EQ(ink::suggestSmoothing(whole, glm::dvec3(1.0)), 0.0);
  const ink::NoiseEstimate resampled = estimateNoise(sliced(3.0).field(), 0.5);
  EXPECT_GT(resampled.roughness, 0.2);
  EXPECT_LT(resampled.bend, 0.1);
  EXPECT_LT(resampled.sharpness, 0.55) << "not by that";
  EXPECT_EQ(ink::suggestSmoothing(resampled, glm::dvec3(1.0)), ink::sharpSmoothing);

  const auto with = [](double roughness, double bend, double thickness, double noise = 0.0)
  {
    return ink::suggestSmoothing({ .noise = noise,
                                   .step = 1.0,
                                   .thickness = thickness,
                                   .usualThickness = thickness,
                                   .sharpness = 0.4,
                                   .roughness = roughness,
                                   .bend = bend },
      glm::dvec3(1.0));
  };
  EXPECT_EQ(with(0.2, 0.05, 5.0), ink::sharpSmoothing);
  EXPECT_EQ(with(0.16, 0.08, 5.0), 0.0) << "hardly rough";
  EXPECT_EQ(with(0.3, 0.15, 5.0), 0.0) << "bends, too";
  EXPECT_EQ(with(0.2, 0.05, 1.0), 0.5) << "thin parts";
  EXPECT_EQ(with(0.1, 0.02, 5.0), ink::sharpSmoothing) << "hardly bends";
  EXPECT_LT(with(0.1, 0.02, 5.0, 0.01), ink::sharpSmoothing) << "noise makes a third of it";
  EXPECT_EQ(with(0.1, 0.05, 5.0), 0.0);
  EXPECT_EQ(with(0.06, 0.0, 5.0), 0.0);
  double before = 0.0;
  for (const double roughness : { 0.08, 0.1, 0.12, 0.15 })
  {
    const double smoothing = with(roughness, 0.035, 5.0);
    EXPECT_GT(smoothing, before) << roughness;
    EXPECT_LE(smoothing, ink::sharpSmoothing) << roughness;
    before = smoothing;
  }
}

TEST(NoiseEstimate, NoiseThatNeighborsShareIsSeenBySurfacesNormals)
{
  // As MR that was reconstructed on a grid of 1.4 times as many samples along each axis.
  constexpr double finer = 1.4;
  const Sphere ball{ glm::dvec3(0.2), 24.0 };
  const auto measured = [](const glm::ivec3& at)
  { return 0.12 * hashNormal(5, static_cast<std::uint64_t>((at.z * 64 + at.y) * 64 + at.x)); };
  const auto noise = [&](const glm::dvec3& p)
  {
    const glm::dvec3 position = p / finer + 32.0;
    const glm::ivec3 first(glm::floor(position));
    const glm::dvec3 share = position - glm::dvec3(first);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 weight = glm::mix(1.0 - share, share, glm::dvec3(step));
      sum += weight.x * weight.y * weight.z * measured(first + step);
    }
    return sum;
  };
  const auto volume = Volume<float>::from(centered(64),
    [&](const glm::dvec3& p)
    { return 0.5 * std::erfc(ball.distance(p) / (0.7 * finer * std::sqrt(2.0))) + noise(p); });
  ink::NoiseEstimate found = estimateNoise(volume.field(), 0.5);
  const double suggested = ink::suggestSmoothing(found, glm::dvec3(1.0));
  EXPECT_GT(suggested, 0.9);
  found.roughness = 0.0;
  EXPECT_LT(ink::suggestSmoothing(found, glm::dvec3(1.0)), 0.7 * suggested) << "by second differences";
}

TEST(NoiseEstimate, SamplesThatWerePickedFromFinerOnesShowTheGrid)
{
  const Sphere ball{ glm::dvec3(0.2), 24.0 };
  const auto behind = [&](double pointSpread)
  {
    const auto volume = Volume<float>::from(centered(64),
      [&](const glm::dvec3& p)
      { return 0.5 * std::erfc(ball.distance(p) / (pointSpread * std::sqrt(2.0))); });
    return estimateNoise(volume.field(), 0.5);
  };
  const ink::NoiseEstimate picked = behind(0.4);
  EXPECT_LT(picked.sharpness, 0.55) << "not by that";
  EXPECT_LT(picked.roughness, 0.11);
  EXPECT_EQ(ink::suggestSmoothing(picked, glm::dvec3(1.0)), ink::sharpSmoothing);
  EXPECT_EQ(ink::suggestSmoothing(behind(0.6), glm::dvec3(1.0)), 0.0);
}

TEST(NoiseEstimate, OneNoisySideCountsHalf)
{
  // As in MR with masked air: zero outside.
  const Sphere ball{ glm::dvec3(0.3), 18.0 };
  auto volume = blurred<float>(centered(56), ball, 0.0, 1.0, 0.06);
  for (float& value : volume.values)
  {
    value = value < 0.3f ? 0.0f : value;
  }
  const ink::NoiseEstimate found = estimateNoise(volume.field(), 0.5);
  EXPECT_NEAR(found.noise, 0.06, 0.01);
}

TEST(NoiseEstimate, GrayLevelsAreFound)
{
  const Sphere ball{ glm::dvec3(0.3), 18.0 };
  EXPECT_EQ(
    estimateNoise(blurred<std::uint8_t>(centered(48), ball, 10.0, 100.0, 1.0).field(), 60.0).quantum, 1.0);
  // 12 bits in the upper bits of 16.
  auto volume = blurred<std::uint16_t>(centered(48), ball, 100.0, 900.0, 20.0);
  for (std::uint16_t& value : volume.values)
  {
    value = static_cast<std::uint16_t>(16 * value);
  }
  EXPECT_EQ(estimateNoise(volume.field(), 8000.0).quantum, 16.0);
}

TEST(NoiseEstimate, SuggestsMoreForMoreNoise)
{
  const glm::dvec3 cubes(1.0);
  double last = 0.0;
  for (const double noise : { 0.005, 0.02, 0.05, 0.1, 0.2 })
  {
    const double suggested = ink::suggestSmoothing({ noise, 1.0, 0.0 }, cubes);
    EXPECT_GT(suggested, last) << noise;
    EXPECT_EQ(ink::suggestSmoothing({ 1e-9 * noise, 1e-9, 0.0 }, 1e6 * cubes), suggested)
      << "units do not matter";
    last = suggested;
  }
  EXPECT_LE(last, 2.0);
  EXPECT_EQ(ink::suggestSmoothing({}, cubes), 0.0) << "no surface";
  EXPECT_GT(ink::suggestSmoothing({ 0.4, 40.0, 1.0 }, cubes), 0.5) << "terraces of 40 gray levels";
  EXPECT_EQ(ink::suggestSmoothing({ 1.2, 1000.0, 1.0 }, cubes), 0.0) << "1000 gray levels";
  EXPECT_EQ(ink::suggestSmoothing({ 1.2, 1000.0, 1.0 }, { 1.0, -1.0, 1.5 }), 1.0) << "slices";
  EXPECT_EQ(ink::suggestSmoothing({ 1.2, 1000.0, 1.0 }, { 1e-3, 1.0, 1.0 }), 2.0) << "at most";
  EXPECT_EQ(ink::suggestSmoothing({ 1.2, 1000.0, 1.0 }, { 1.0, 1.0, 3.0 }), 2.0) << "thick parts";
  EXPECT_EQ(ink::suggestSmoothing({ 1.2, 1000.0, 1.0, 2.0, 3.0 }, { 1.0, 1.0, 3.0 }), 1.0)
    << "slices of thin parts";
  EXPECT_EQ(ink::suggestSmoothing({ 1.2, 1000.0, 1.0, 2.0 }, { 1.0, 1.0, 3.0 }), 1.65)
    << "slices of thick parts and a few thin ones";
  EXPECT_EQ(
    ink::suggestSmoothing({ .step = 1.0, .sharpness = 0.6 }, { 2.0, 1.0, 2.0 }), 2.0 * ink::sharpSmoothing)
    << "sharp steps of voxels that are short along one axis";
  EXPECT_EQ(ink::suggestSmoothing({ .step = 1.0, .sharpness = 0.6 }, { 1.0, 1e-3, 1.0 }), 4.0) << "at most";
}

TEST(NoiseEstimate, WhatIsInsideIsNotThin)
{
  // A thick shell, and within it a thin one, to which no line from outside leads, but for a hole in the thick
  // one.
  const auto volume = [](bool open)
  {
    return Volume<float>::from(GridGeometry(glm::ivec3(64)),
      [open](const glm::dvec3& p)
      {
        const glm::dvec3 d = p - 31.5;
        const double r = glm::length(d);
        const bool thick = r > 20.0 && r < 29.0 && !(open && d.x > 0.0);
        return thick || std::abs(r - 17.0) < 1.0 ? 1000.0F : 0.0F;
      });
  };
  EXPECT_EQ(estimateNoise(volume(false).field(), 500.0).thickness, ink::NoiseEstimate::thickEnough);
  EXPECT_LE(estimateNoise(volume(true).field(), 500.0).thickness, 3.0);
}

TEST(NoiseEstimate, SharpSlicesFarApartAskForMore)
{
  const glm::dvec3 slices(1.0, 1.0, 8.0);
  const auto suggested = [&](double sharpness, double thickness = ink::NoiseEstimate::thickEnough)
  {
    return ink::suggestSmoothing({ .step = 1.0,
                                   .thickness = thickness,
                                   .usualThickness = thickness,
                                   .sharpnessAlong = { 0.3, 0.3, sharpness } },
      slices);
  };
  EXPECT_EQ(suggested(0.45), 2.0);
  EXPECT_EQ(suggested(0.6), 4.0);
  EXPECT_EQ(suggested(0.5, 2.0), 1.0);
  EXPECT_NEAR(suggested(0.51, 2.0), 2.0, 1e-9);
  EXPECT_EQ(suggested(0.6, 2.0), 4.0);
  // A ball in slices that are as thick as they are far apart, and in those of a point spread of .7 slices.
  const auto ballIn = [&](double blur)
  {
    const GridGeometry geometry({ 96, 96, 12 }, glm::dvec3(-47.5, -47.5, -44.0), slices);
    return estimateNoise(Volume<float>::from(geometry,
                           [blur](const glm::dvec3& p)
                           {
                             const double depth = 40.0 - glm::length(p);
                             return 100.0 * std::erfc(-depth / (blur * std::sqrt(2.0)));
                           })
                           .field(),
      100.0);
  };
  EXPECT_GT(ballIn(1.0).sharpnessAlong[2], 0.55);
  EXPECT_LT(ballIn(1.0).sharpnessAlong[0], 0.45);
  EXPECT_LT(ballIn(0.7 * slices.z).sharpnessAlong[2], 0.5);
}

TEST(NoiseEstimate, ContoursAreInterpolatedWhereValuesMakeTerraces)
{
  // A ball in slices that are blurred within and as thick as they are apart, or blurred across, too.
  const auto estimateIn = [](double distance, bool isSharp, double isoValue)
  {
    const int slices = static_cast<int>(96.0 / distance);
    const GridGeometry geometry(
      { 96, 96, slices }, glm::dvec3(-47.5, -47.5, -0.5 * distance * (slices - 1)), { 1.0, 1.0, distance });
    return estimateNoise(Volume<float>::from(geometry,
                           [&](const glm::dvec3& p)
                           {
                             const double depth = 40.0 - glm::length(p);
                             const double blur = isSharp ? 0.7 : 0.7 * distance;
                             return 100.0 * std::erfc(-depth / (blur * std::sqrt(2.0)));
                           })
                           .field(),
      isoValue);
  };
  const auto suggests = [](const ink::NoiseEstimate& estimate, double distance) {
    return ink::suggestShapeBasedInterpolation(estimate, { 1.0, 1.0, distance });
  };
  const ink::NoiseEstimate outer = estimateIn(3.0, true, 20.0);
  EXPECT_GT(outer.innerShareAlong[2], 0.65);
  EXPECT_NEAR(estimateIn(3.0, false, 100.0).innerShareAlong[2], 0.5, 0.05);
  EXPECT_TRUE(suggests(outer, 3.0)) << "the iso-value lies near what is outside";
  EXPECT_FALSE(suggests(outer, 1.5)) << "no thick slices";
  EXPECT_FALSE(suggests(estimateIn(3.0, true, 100.0), 3.0));
  EXPECT_TRUE(suggests(estimateIn(6.0, true, 100.0), 6.0)) << "far apart and sharp";
  EXPECT_FALSE(suggests(estimateIn(6.0, false, 100.0), 6.0)) << "blurred into each other";
  EXPECT_FALSE(suggests({}, 2.0)) << "no surface";

  // Then they ask for no more smoothing than parts show.
  ink::NoiseEstimate sharp{ .step = 1.0, .sharpnessAlong = { 0.3, 0.3, 0.6 } };
  const glm::dvec3 spacing(1.0, 1.0, 8.0);
  EXPECT_EQ(ink::suggestSmoothing(sharp, spacing), 4.0);
  EXPECT_EQ(ink::suggestSmoothing(sharp, spacing, true), 3.0);
  sharp.labels = true;
  EXPECT_EQ(ink::suggestSmoothing(sharp, spacing), 4.0);
  EXPECT_EQ(ink::suggestSmoothing(sharp, spacing, true), 2.0);
  EXPECT_EQ(
    ink::suggestSmoothing(sharp, { 1.0, 1.0, 1.5 }, true), ink::suggestSmoothing(sharp, { 1.0, 1.0, 1.5 }));
  const ink::SuggestedSmoothing suggested = ink::suggestSmoothings(sharp, spacing);
  EXPECT_TRUE(suggested.shapeBased);
  EXPECT_EQ(suggested.get(false).get(false), 4.0);
  EXPECT_EQ(suggested.get(true).get(false), 3.0);
  EXPECT_EQ(suggested.get(false).get(true), 4.0);
  EXPECT_EQ(suggested.get(true).get(true), 2.0);
  ink::SuggestedSmoothing both;
  both.add(suggested);
  EXPECT_TRUE(both.shapeBased);
  EXPECT_EQ(both.get(true).get(false), 3.0);
}

TEST(NoiseEstimate, TerracesOfThinWallsAskForLess)
{
  for (const int wall : { 1, 2, 3 })
  {
    // A hollow cube of bits around the middle of 24^3 samples.
    const auto volume = Volume<std::uint8_t>::from(GridGeometry(glm::ivec3(24)),
      [wall](const glm::dvec3& p)
      {
        const glm::dvec3 d = glm::abs(p - 11.5);
        const double size = std::max({ d.x, d.y, d.z });
        return size < 10.0 && size > 10.0 - wall ? 255.0 : 0.0;
      });
    const ink::NoiseEstimate found = estimateNoise(volume.field(), 127.5);
    EXPECT_EQ(found.thickness, wall);
    EXPECT_EQ(ink::suggestSmoothing(found, glm::dvec3(1.0)), 0.5 * wall);
  }
  // A slit of one sample, at fewer positions than a quarter, through a cube.
  const auto slit = Volume<std::uint8_t>::from(GridGeometry(glm::ivec3(24)),
    [](const glm::dvec3& p)
    {
      const glm::dvec3 d = glm::abs(p - 11.5);
      const bool isSlit = p.x == 12.0 && p.y < 8.0;
      return std::max({ d.x, d.y, d.z }) < 10.0 && !isSlit ? 255.0 : 0.0;
    });
  const ink::NoiseEstimate slitted = estimateNoise(slit.field(), 127.5);
  EXPECT_EQ(slitted.usualThickness, ink::NoiseEstimate::thickEnough);
  ink::NoiseEstimate brain{ .step = 1.0, .thickness = 1.0, .usualThickness = 3.0, .labels = true };
  EXPECT_EQ(ink::suggestSmoothing(brain, glm::dvec3(1.0)), 1.5) << "gaps of a single sample";
  EXPECT_FALSE(ink::suggestSmoothings(brain, glm::dvec3(1.0)).byValues.keepsLabels) << "which stay open";
  brain.thickness = 2.0;
  EXPECT_EQ(ink::suggestSmoothing(brain, glm::dvec3(1.0)), 1.0) << "thin parts";
  const auto ball = Volume<std::uint8_t>::from(
    centered(40), [](const glm::dvec3& p) { return glm::length(p) < 15.0 ? 255.0 : 0.0; });
  const ink::NoiseEstimate found = estimateNoise(ball.field(), 127.5);
  EXPECT_EQ(found.thickness, ink::NoiseEstimate::thickEnough);
  EXPECT_EQ(ink::suggestSmoothing(found, glm::dvec3(1.0)), 2.0);
  // Noise asks for what it needs wherever it is.
  EXPECT_EQ(ink::suggestSmoothing({ 0.1, 1.0, 0.0, 1.0 }, glm::dvec3(1.0)),
    ink::suggestSmoothing({ 0.1, 1.0, 0.0 }, glm::dvec3(1.0)));
}

TEST(NoiseEstimate, SmallPartsOfLabelsAreKept)
{
  // Balls of a radius, 12 samples apart, and what a Gaussian of the suggested deviation leaves in the middle
  // of one: the share of a normal distribution in three dimensions within that radius.
  const auto balls = [](const glm::dvec3& size, double radius)
  {
    return Volume<std::uint8_t>::from(GridGeometry(glm::ivec3(size)),
      [radius](const glm::dvec3& p)
      {
        const glm::dvec3 d = p - 12.0 * glm::floor(p / 12.0) - 5.5;
        return glm::length(d) < radius ? 1.0 : 0.0;
      });
  };
  for (const double radius : { 1.0, 1.5, 2.0, 2.5, 3.0 })
  {
    const ink::NoiseEstimate found = estimateNoise(balls({ 36, 36, 36 }, radius).field(), 0.5);
    const double deviation = ink::suggestSmoothing(found, glm::dvec3(1.0));
    const double ratio = radius / deviation;
    const double kept = std::erf(ratio / std::sqrt(2.0)) -
      std::sqrt(2.0 / std::acos(-1.0)) * ratio * std::exp(-0.5 * ratio * ratio);
    EXPECT_GT(kept, 0.5) << radius;
    EXPECT_GT(deviation, 0.39 * radius) << "and no less than it takes";
    EXPECT_TRUE(ink::suggestSmoothings(found, glm::dvec3(1.0)).byValues.keepsLabels);
  }
  EXPECT_EQ(
    estimateNoise(balls({ 36, 36, 36 }, 5.4).field(), 0.5).keeping, std::numeric_limits<double>::infinity());
  // A rod of three samples across, in whatever direction.
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto rod = Volume<std::uint8_t>::from(GridGeometry(glm::ivec3(24)),
      [axis](const glm::dvec3& p)
      {
        glm::dvec3 d = glm::abs(p - 11.0);
        d[axis] = 0.0;
        return std::max({ d.x, d.y, d.z }) < 2.0 ? 1.0 : 0.0;
      });
    const double keeping = estimateNoise(rod.field(), 0.5).keeping;
    EXPECT_NEAR(std::pow(std::erf(1.5 / (std::sqrt(2.0) * keeping)), 2.0), 0.75, 1e-3) << axis;
  }
  EXPECT_EQ(ink::suggestSmoothing({ .step = 1.0, .keeping = 1.2, .labels = true }, glm::dvec3(1.0)), 1.2);
  EXPECT_EQ(ink::suggestSmoothing({ .noise = 0.1, .step = 1.0, .keeping = 0.5 }, glm::dvec3(1.0)),
    ink::suggestSmoothing({ .noise = 0.1, .step = 1.0 }, glm::dvec3(1.0)))
    << "values keep theirs by the target";
}

TEST(NoiseEstimate, SaysNothingOfDegenerateGrids)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(estimateNoise(Volume<float>(centered(9), 3.0f).field(), 3.0).noise, 0.0);
  EXPECT_EQ(estimateNoise(Volume<double>(centered(9), nan).field(), 3.0).noise, 0.0);
  EXPECT_EQ(estimateNoise(Volume<double>(centered(9), 1.0).field(), nan).step, 0.0);
  EXPECT_EQ(estimateNoise(Volume<int>(GridGeometry({ 0, 0, 0 })).field(), 1.0).noise, 0.0);
  EXPECT_EQ(estimateNoise(Volume<int>(GridGeometry({ 1, 1, 1 }), 5).field(), 1.0).noise, 0.0);
  // One slice has noise, too.
  std::uint64_t n = 0;
  const auto slice = Volume<float>::from(
    GridGeometry({ 60, 60, 1 }), [&](const glm::dvec3&) { return 0.1 * hashNormal(3, n++); });
  EXPECT_NEAR(estimateNoise(slice.field(), nan).noise, 0.1, 0.01);
  const auto wide =
    Volume<std::int64_t>::from(centered(20), [&](const glm::dvec3&) { return n++ % 2 ? 0x1p62 : -0x1p62; });
  EXPECT_TRUE(std::isfinite(estimateNoise(wide.field(), 0.0).noise));
  const auto large = Volume<double>::from(centered(20),
    [&](const glm::dvec3& p)
    { return p.x < 0.0 ? -std::numeric_limits<double>::max() : std::numeric_limits<double>::max(); });
  EXPECT_TRUE(std::isfinite(estimateNoise(large.field(), 0.0).step));
}

} // namespace
