// SPDX-License-Identifier: BSD-3-Clause
// Samples of smoothed and divided grids against analytic surfaces, and of parts against the whole.

#include "AnalyticFields.h"
#include "HashNoise.h"
#include "IsoSurface/ResampledSamples.h"
#include "SampledVolume.h"
#include "Statistics/NoiseEstimate.h"
#include "VolumeFraction.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace
{

using namespace ink::testing;
using ink::GridGeometry;
using ink::SmoothingTarget;

struct Setting
{
  double smoothing = 0.0;
  int subdivision = 1;
  SmoothingTarget target = SmoothingTarget::Surface;
  int projectionSteps = 0;
  ink::CellSelection selection = {};
};

template <class Real = float, class T>
Samples<Real> resample(
  const ink::GridField<T>& field, double isoValue, const Setting& setting, ink::TileRanges* ranges = nullptr)
{
  Samples<Real> samples;
  const auto grow = [&](std::size_t count) { return samples.grow(count); };
  ink::SampleOptions options;
  options.arithmetic = std::is_same_v<Real, float> ? ink::Arithmetic::Single : ink::Arithmetic::Double;
  std::vector<std::size_t> counts;
  ink::sampleResampledIsoSurfaces(field, std::span(&isoValue, 1), options, setting.selection,
    ink::makeIsoSurfaceResampling(field.geometry(), setting.smoothing, setting.subdivision, setting.target),
    setting.projectionSteps, ranges, grow, counts);
  EXPECT_EQ(counts.size(), 1u);
  EXPECT_EQ(counts.at(0), samples.size());
  return samples;
}

template <class Real>
using Sorted = std::vector<std::array<Real, 6>>;

template <class Real>
Sorted<Real> sorted(const Samples<Real>& samples)
{
  Sorted<Real> all(samples.size());
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      all[n][axis] = samples.coordinates[3 * n + axis];
      all[n][3 + axis] = samples.components[3 * n + axis];
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

struct Errors
{
  double distance = 0.0; ///< root mean square
  double angle = 0.0;    ///< root mean square, of the sine
};

template <class Shape, class Real>
Errors errorsOf(const Samples<Real>& samples, const Shape& shape)
{
  Errors errors;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 p = samples.point(n);
    const glm::dvec3 outward = glm::normalize(shape.gradient(p));
    EXPECT_NEAR(glm::length(samples.normal(n)), 1.0, 1e-5) << "sample " << n;
    EXPECT_GT(glm::dot(samples.normal(n), outward), 0.0) << "sample " << n;
    errors.distance += std::pow(shape.distance(p), 2);
    const double sine = glm::length(glm::cross(samples.normal(n), outward));
    errors.angle += sine * sine;
  }
  errors.distance = std::sqrt(errors.distance / static_cast<double>(samples.size()));
  errors.angle = std::sqrt(errors.angle / static_cast<double>(samples.size()));
  return errors;
}

GridGeometry centered(const glm::ivec3& n, const glm::dvec3& spacing,
  const glm::dmat3& direction = glm::dmat3(1.0), const glm::dvec3& center = glm::dvec3(0.0))
{
  return GridGeometry(n, center - direction * (0.5 * spacing * glm::dvec3(n - 1)), spacing, direction);
}

/// 1 inside and 0 outside, blurred by about .7 voxels of size 1, with noise.
template <class T = float, class Shape>
Volume<T> blurred(const GridGeometry& geometry, const Shape& shape, double noise, double step = 1.0)
{
  std::uint64_t n = 0;
  return Volume<T>::from(geometry,
    [&](const glm::dvec3& p)
    { return step * (0.5 * std::erfc(shape.distance(p) / 0.99) + noise * hashNormal(7, n++)); });
}

TEST(ResampledSamples, DividedCellsLieCloserToASphere)
{
  const Sphere sphere{ { 0.1, -0.2, 0.3 }, 8.4 };
  const auto volume = Volume<float>::from(
    centered(glm::ivec3(24), glm::dvec3(1.0)), [&](const glm::dvec3& p) { return -sphere.value(p); });
  const auto whole = sampleIsoSurface<float>(volume.field(), 0.0);
  const Errors before = errorsOf(whole, sphere);
  for (const int subdivision : { 2, 3, 4 })
  {
    const auto samples = resample(volume.field(), 0.0, { 0.0, subdivision });
    const double more = static_cast<double>(samples.size()) / static_cast<double>(whole.size());
    EXPECT_NEAR(more, subdivision * subdivision, 0.1 * subdivision * subdivision);
    const Errors after = errorsOf(samples, sphere);
    EXPECT_LT(after.distance, 1.2 * before.distance / subdivision) << subdivision;
    EXPECT_LT(after.angle, before.angle) << subdivision;
  }
}

TEST(ResampledSamples, SmoothingRemovesNoiseFromNormals)
{
  const Sphere sphere{ { 0.1, -0.2, 0.3 }, 14.2 };
  const auto volume = blurred(centered(glm::ivec3(40), glm::dvec3(1.0)), sphere, 0.1);
  const Errors before = errorsOf(sampleIsoSurface<float>(volume.field(), 0.5), sphere);
  const Errors after = errorsOf(resample(volume.field(), 0.5, { 1.0, 1 }), sphere);
  const Errors normals =
    errorsOf(resample(volume.field(), 0.5, { 1.0, 1, SmoothingTarget::Normals }), sphere);
  EXPECT_LT(after.angle, 0.35 * before.angle);
  // A Gaussian moves the surface of a ball inwards by about its variance over the radius.
  EXPECT_LT(after.distance, 1.4 / sphere.radius);
  EXPECT_LT(after.distance, before.distance);
  EXPECT_LT(normals.angle, 0.35 * before.angle);
  EXPECT_LT(normals.distance, 0.8 * before.distance) << "the surface keeps its position";
}

TEST(ResampledSamples, SmoothingHidesTheGridOfVolumeFractions)
{
  const Sphere sphere{ { 0.1, -0.2, 0.3 }, 24.0 };
  const auto volume = Volume<float>::from(centered(glm::ivec3(56), glm::dvec3(1.0)),
    [&](const glm::dvec3& p) { return volumeFraction(sphere, p); });
  const auto degrees = [&](const auto& samples) { return glm::degrees(errorsOf(samples, sphere).angle); };
  EXPECT_NEAR(degrees(sampleIsoSurface<float>(volume.field(), 0.5)), 6.0, 0.6);
  EXPECT_LT(
    degrees(resample(volume.field(), 0.5, { ink::sharpSmoothing, 1, SmoothingTarget::Normals })), 1.3);
}

TEST(ResampledSamples, NormalsAloneKeepAThinTube)
{
  // A tube of .8 voxels' radius, of which a Gaussian of 1 voxel leaves less than half.
  const Torus torus{ 9.0, 0.8 };
  const auto volume = blurred(centered(glm::ivec3(28), glm::dvec3(1.0)), torus, 0.0);
  EXPECT_EQ(resample(volume.field(), 0.4, { 1.2, 1 }).size(), 0u);
  const auto kept = resample(volume.field(), 0.4, { 1.2, 1, SmoothingTarget::Normals });
  EXPECT_GT(static_cast<double>(kept.size()),
    0.95 * static_cast<double>(sampleIsoSurface<float>(volume.field(), 0.4).size()));
  EXPECT_LT(errorsOf(kept, torus).angle, 0.25);
}

TEST(ResampledSamples, LongVoxelsBecomeCubesAndSmoothingIsTheSameInAllDirections)
{
  const Sphere sphere{ glm::dvec3(0.0), 9.0 };
  const auto volume = blurred(centered({ 30, 30, 10 }, { 1.0, 1.0, 3.0 }), sphere, 0.0);
  const auto resampling = ink::makeIsoSurfaceResampling(volume.geometry, 1.2, 1, SmoothingTarget::Surface);
  EXPECT_EQ(resampling.subdivision, glm::ivec3(1, 1, 3));
  EXPECT_NEAR(resampling.deviation.z, 0.4, 1e-12);
  EXPECT_NEAR(resampling.deviation.x, 1.2, 1e-12);
  const Errors before = errorsOf(sampleIsoSurface<float>(volume.field(), 0.5), sphere);
  EXPECT_LT(errorsOf(resample(volume.field(), 0.5, { 0.7, 1 }), sphere).angle, 0.7 * before.angle);
  const auto flat =
    ink::makeIsoSurfaceResampling(GridGeometry({ 9, 9, 9 }, {}, { 1.0, 1.0, 1000.0 }), 0.5, 3, {});
  EXPECT_EQ(flat.subdivision, glm::ivec3(3, 3, ink::largestSubdivision));
  EXPECT_EQ(ink::subdivisionAlong(2.0, 3), 6);
  EXPECT_EQ(ink::subdivisionAlong(3.0, 8), 8) << "cells three times as long as wide";
  EXPECT_EQ(ink::subdivisionAlong(6.0, 8), 48) << "cubes";
  EXPECT_TRUE(ink::makeIsoSurfaceResampling(volume.geometry, 0.0, 1, {}).isIdentity());
}

TEST(ResampledSamples, ArePlacedInRotatedAndDistantGrids)
{
  const glm::dmat3 rotation(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, -2.0, 0.5)));
  for (const double size : { 1e-9, 1.0, 1e9 })
  {
    const Sphere sphere{ glm::dvec3(1e4 * size), 8.0 * size };
    const auto volume =
      Volume<double>::from(centered(glm::ivec3(22), glm::dvec3(size, -size, size), rotation, sphere.center),
        [&](const glm::dvec3& p) { return -sphere.value(p) / size; });
    const auto samples = resample<double>(volume.field(), 0.0, { 0.5, 2 });
    ASSERT_GT(samples.size(), 1000u);
    const Errors errors = errorsOf(samples, sphere);
    EXPECT_LT(errors.distance, 0.06 * size);
    EXPECT_LT(errors.angle, 0.02);
  }
}

/// Tiles, threads and parts make no difference to the last bit.
TEST(ResampledSamples, PartsGiveTheSamplesOfTheWhole)
{
  const Torus torus{ 11.0, 5.0 };
  const auto whole = blurred<std::int16_t>(centered({ 37, 34, 20 }, { 1.0, 1.1, 1.7 }), torus, 0.03, 1000.0);
  for (const Setting& setting : { Setting{ 0.8, 1 }, Setting{ 0.0, 3 },
         Setting{ 0.6, 2, SmoothingTarget::Normals }, Setting{ 0.7, 1, SmoothingTarget::Surface, 3 } })
  {
    const auto unsorted = resample(whole.field(), 500.0, setting);
    const auto expected = sorted(unsorted);
    ASSERT_GT(expected.size(), 1000u);
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    EXPECT_EQ(resample(whole.field(), 500.0, setting), unsorted) << "one thread";
    unsetenv("VTK_SMP_MAX_THREADS");

    const int ghosts = ink::isoSurfaceResamplingReach(setting.smoothing, setting.subdivision).x +
      (setting.projectionSteps > 0);
    Sorted<float> together;
    const glm::ivec3 cells = whole.geometry.dimensions() - 1;
    const glm::ivec3 cut = cells / 2 + glm::ivec3(1, -2, 3);
    for (int part = 0; part < 8; ++part)
    {
      glm::ivec3 begin;
      glm::ivec3 end;
      for (int axis = 0; axis < 3; ++axis)
      {
        begin[axis] = (part >> axis & 1) ? cut[axis] : 0;
        end[axis] = (part >> axis & 1) ? cells[axis] : cut[axis];
      }
      const glm::ivec3 first = glm::max(begin - ghosts, glm::ivec3(0));
      const glm::ivec3 last = glm::min(end + ghosts, cells);
      const Volume<std::int16_t> piece = whole.part(first, last);
      Setting own = setting;
      own.selection.begin = begin - first;
      own.selection.end = end - first;
      const auto samples = sorted(resample(piece.field(), 500.0, own));
      together.insert(together.end(), samples.begin(), samples.end());
    }
    std::sort(together.begin(), together.end());
    EXPECT_EQ(together.size(), expected.size());
    EXPECT_TRUE(together == expected) << setting.smoothing << ' ' << setting.subdivision;
  }
}

TEST(ResampledSamples, RangesOfTilesChangeNothing)
{
  const Sphere sphere{ glm::dvec3(3.0), 20.0 };
  const auto volume = blurred(centered({ 90, 60, 60 }, glm::dvec3(1.0)), sphere, 0.02);
  ink::TileRanges ranges;
  for (const double isoValue : { 0.5, 0.3, 0.7, 0.02 })
  {
    const auto expected = resample(volume.field(), isoValue, { 0.7, 1 });
    ASSERT_GT(expected.size(), 1000u);
    EXPECT_EQ(resample(volume.field(), isoValue, { 0.7, 1 }, &ranges), expected) << isoValue;
  }
  EXPECT_GT(ranges.bytes(), 0u);
  EXPECT_EQ(resample(volume.field(), 0.5, { 0.0, 2 }, &ranges), resample(volume.field(), 0.5, { 0.0, 2 }))
    << "ranges of another resampling are not used";
}

TEST(ResampledSamples, MissingSamplesLeaveTheRestAlone)
{
  const Sphere sphere{ glm::dvec3(0.0), 9.0 };
  auto volume = blurred(centered(glm::ivec3(26), glm::dvec3(1.0)), sphere, 0.0);
  const auto whole = sorted(resample(volume.field(), 0.5, { 0.6, 2 }));
  constexpr float bad[] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() };
  const glm::ivec3 missing[] = { { 21, 13, 13 }, { 21, 14, 13 } };
  volume.at(missing[0]) = bad[0];
  volume.at(missing[1]) = bad[1];
  const auto samples = resample(volume.field(), 0.5, { 0.6, 2 });
  EXPECT_LT(samples.size(), whole.size());
  const Errors errors = errorsOf(samples, sphere);
  EXPECT_LT(errors.angle, 0.05);
  std::size_t elsewhere = 0;
  for (const auto& sample : sorted(samples))
  {
    const glm::dvec3 index = volume.geometry.toIndex({ sample[0], sample[1], sample[2] });
    for (const glm::ivec3& m : missing)
    {
      EXPECT_FALSE(glm::all(glm::lessThan(glm::abs(index - glm::dvec3(m)), glm::dvec3(0.99))))
        << "a sample in a cell with a missing corner";
    }
    elsewhere += std::binary_search(whole.begin(), whole.end(), sample);
  }
  EXPECT_GT(elsewhere, whole.size() * 9 / 10) << "far from missing samples nothing changes";
  std::fill(volume.values.begin(), volume.values.end(), bad[0]);
  EXPECT_EQ(resample(volume.field(), 0.5, { 0.6, 2 }).size(), 0u);
}

TEST(ResampledSamples, SkippedCellsAreEmpty)
{
  const Sphere sphere{ glm::dvec3(0.0), 9.0 };
  const auto volume = blurred(centered(glm::ivec3(26), glm::dvec3(1.0)), sphere, 0.0);
  const std::size_t cells = 25 * 25 * 25;
  std::vector<std::uint8_t> marks(cells, 0);
  std::fill(marks.begin(), marks.begin() + cells / 5 * 2, std::uint8_t(4)); // the first ten layers
  Setting setting{ 0.5, 2 };
  setting.selection.skipped = { marks, 4 };
  const auto samples = resample(volume.field(), 0.5, setting);
  setting.selection = { glm::ivec3(0, 0, 10), glm::ivec3(25), {} };
  EXPECT_EQ(sorted(samples), sorted(resample(volume.field(), 0.5, setting)));
}

TEST(ResampledSamples, AConstantHasNoSurface)
{
  for (const double smoothing : { 0.0, 0.7 })
  {
    const Volume<float> volume(centered(glm::ivec3(12), glm::dvec3(1.0)), 0.1f);
    EXPECT_EQ(resample(volume.field(), static_cast<double>(0.1f), { smoothing, 2 }).size(), 0u);
    const Volume<std::uint16_t> flat(centered({ 12, 9, 2 }, glm::dvec3(1.0)), 65535);
    EXPECT_EQ(resample(flat.field(), 65535.0, { smoothing, 3 }).size(), 0u);
    const Volume<float> thin(centered({ 12, 9, 1 }, glm::dvec3(1.0)), 1.0f);
    EXPECT_EQ(resample(thin.field(), 1.0, { smoothing, 3 }).size(), 0u) << "no cells";
  }
}

TEST(ResampledSamples, LimitsOfTypesDoNotOverflow)
{
  const Sphere sphere{ glm::dvec3(0.0), 6.0 };
  const GridGeometry geometry = centered(glm::ivec3(18), glm::dvec3(1.0));
  const auto check = [&](auto low, auto high, double middle, auto real)
  {
    using T = decltype(low);
    const auto volume =
      Volume<T>::from(geometry, [&](const glm::dvec3& p) { return sphere.value(p) < 0.0 ? high : low; });
    const auto samples = resample<decltype(real)>(volume.field(), middle, { 0.8, 2 });
    ASSERT_GT(samples.size(), 1000u);
    EXPECT_LT(errorsOf(samples, sphere).distance, 0.4);
  };
  check(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(), 0.0, 0.0);
  check(std::numeric_limits<std::uint8_t>::min(), std::numeric_limits<std::uint8_t>::max(), 127.5, 0.0f);
  check(-std::numeric_limits<float>::max(), std::numeric_limits<float>::max(), 0.0, 0.0f);
  check(-std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), 0.0, 0.0);
  check(0.0, std::numeric_limits<double>::min(), 0.5 * std::numeric_limits<double>::min(), 0.0);
}

} // namespace
