// SPDX-License-Identifier: BSD-3-Clause
// A volume as a narrow band and back: the samples of the one are those of the other, to the bit.

#include "AnalyticFields.h"
#include "VdbVolumes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace
{

using namespace ink::testing;
using ink::CrossingRule;
using ink::GridGeometry;
using ink::VdbConversion;
using ink::VdbGrid;

template <class T>
VdbGrid throughFile(const Volume<T>& volume, const VdbConversion& conversion)
{
  return readGrid(ink::serializeVdb(ink::makeVdbGrid(volume.field(), conversion)));
}

template <class T>
void expectSameSamples(const Volume<T>& volume, const VdbGrid& grid, double iso, bool flat = false)
{
  for (const CrossingRule rule : { CrossingRule::HalfOpen, CrossingRule::Strict })
  {
    if (rule == CrossingRule::Strict && iso == std::floor(iso) && flat)
    {
      continue;
    }
    SCOPED_TRACE(rule == CrossingRule::Strict ? "strict" : "half open");
    const auto expected = sorted(sampleIsoSurface(volume.field(), iso, rule));
    EXPECT_TRUE(sorted(sampleIsoSurface(grid, iso, { rule })) == expected);
    // And when the band is made dense again.
    const auto dense = denseOf<T>(grid, grid.domain());
    EXPECT_TRUE(sorted(sampleIsoSurface(dense.field(), iso, rule)) == expected);
  }
}

template <class T>
Volume<T> ball(const GridGeometry& geometry, const glm::dvec3& center, double radius)
{
  const Sphere sphere{ center, radius };
  return Volume<T>::from(geometry, [&](const glm::dvec3& p) { return 100.0 - 10.0 * sphere.value(p); });
}

TEST(VdbWrite, BandHasTheVolumesSamples)
{
  // At an angle, unevenly spaced and with a first sample that is not 0: the surface also leaves the volume.
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 2.0, 3.0)));
  const GridGeometry geometry({ 40, 37, 25 }, { 10, -20, 1e3 }, { 0.3, 0.4, 0.7 }, turned, { -13, 5, 9 });
  const auto volume = ball<float>(geometry, geometry.toWorld({ 15, 18, 12 }), 6.0);
  for (const int halfWidth : { 1, 3 })
  {
    VdbConversion conversion;
    conversion.around = 100.0;
    conversion.halfWidth = halfWidth;
    const VdbGrid grid = throughFile(volume, conversion);
    EXPECT_EQ(grid.info().name, "density");
    EXPECT_EQ(grid.domain().first, geometry.first());
    EXPECT_EQ(grid.domain().last, geometry.first() + geometry.dimensions() - 1);
    expectSameSamples(volume, grid, 100.0);
  }
}

TEST(VdbWrite, RandomVolumesHaveTheSameSamples)
{
  for (unsigned seed = 0; seed < 25 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto upTo = [&](unsigned n) { return static_cast<int>(random() % n); };
    const GridGeometry geometry({ 2 + upTo(25), 2 + upTo(25), 2 + upTo(25) }, { 1, -2, 3 }, { 0.5, 2.0, 1.0 },
      glm::dmat3(1.0), { upTo(9) - 4, upTo(9) - 4, 0 });
    Volume<double> volume(geometry);
    const int sharpness = 1 + upTo(40);
    for (double& value : volume.values)
    {
      value = upTo(static_cast<unsigned>(sharpness)) == 0 ? upTo(5) : 1.0;
      value = seed % 3 == 0 && upTo(30) == 0 ? std::numeric_limits<double>::quiet_NaN() : value;
    }
    for (const double iso : { 1.0, 1.5, 3.0 })
    {
      if (sampleIsoSurface(volume.field(), iso).size() == 0)
      {
        continue;
      }
      VdbConversion conversion;
      conversion.around = iso;
      conversion.halfWidth = 1 + upTo(3);
      expectSameSamples(volume, throughFile(volume, conversion), iso, true);
    }
    expectSameSamples(volume, throughFile(volume, {}), 1.5);
  }
}

TEST(VdbWrite, OutsideOfTheBandIsOnItsSide)
{
  const GridGeometry geometry({ 64, 64, 64 });
  const auto volume = ball<float>(geometry, { 31, 32, 33 }, 20.0);
  VdbConversion conversion;
  conversion.around = 100.0;
  const VdbGrid grid = ink::makeVdbGrid(volume.field(), conversion);
  const auto dense = denseOf<float>(grid, grid.domain());
  std::size_t kept = 0;
  for (std::size_t n = 0; n < volume.values.size(); ++n)
  {
    EXPECT_EQ(dense.values[n] >= 100.0f, volume.values[n] >= 100.0f);
    // In the band: up to halfWidth + 1 voxels from the surface in each direction.
    if (std::abs(volume.values[n] - 100.0f) <= 10.0f * conversion.halfWidth)
    {
      EXPECT_EQ(dense.values[n], volume.values[n]);
      ++kept;
    }
  }
  EXPECT_GT(kept, 10000u);
  // Nothing but the band takes memory.
  EXPECT_LT(ink::serializeVdb(grid).size(), volume.values.size());
}

TEST(VdbWrite, WholeVolumeKeepsItsValues)
{
  const GridGeometry geometry({ 33, 20, 17 }, glm::dvec3(0.0), { 1, 1, 2 }, glm::dmat3(1.0), { 3, -4, 5 });
  auto volume = ball<double>(geometry, { 18, 6, 28 }, 5.0);
  for (double& value : volume.values)
  {
    value = std::max(value, 40.0);
  }
  const VdbGrid grid = throughFile(volume, {});
  EXPECT_EQ(grid.background(), 40.0);
  EXPECT_EQ(denseOf<double>(grid, grid.domain()).values, volume.values);
  expectSameSamples(volume, grid, 100.0);
}

/// A missing sample, wherever it lies within the tree's blocks of 8 voxels, takes no other with it.
TEST(VdbWrite, MissingSamplesAreAlone)
{
  for (const int at : { 0, 7, 8, 16, 31 })
  {
    auto volume = ball<double>(GridGeometry(glm::ivec3(32)), glm::dvec3(15.0), 9.0);
    volume.at({ at, at, at }) = NAN;
    const VdbGrid grid = throughFile(volume, {});
    const auto dense = denseOf<double>(grid, grid.domain());
    ASSERT_EQ(dense.values.size(), volume.values.size());
    std::size_t different = 0;
    for (std::size_t n = 0; n < volume.values.size(); ++n)
    {
      different += dense.values[n] != volume.values[n];
    }
    EXPECT_EQ(different, 1u) << "NaN itself, at " << at;
  }
}

TEST(VdbWrite, ConstantVolumeIsATileOrNothing)
{
  const Volume<float> volume(GridGeometry({ 64, 64, 64 }), 7.0f);
  const VdbGrid grid = throughFile(volume, {});
  EXPECT_EQ(grid.background(), 7.0);
  EXPECT_EQ(denseOf<float>(grid, grid.domain()).values, volume.values);
  EXPECT_LT(grid.memory(), 100000u);
}

TEST(VdbWrite, WhatCannotBeIsRefused)
{
  const Volume<float> volume(GridGeometry({ 8, 8, 8 }), 7.0f);
  VdbConversion conversion;
  conversion.around = 9.0;
  EXPECT_THROW(ink::makeVdbGrid(volume.field(), conversion), std::invalid_argument);
  conversion.around = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ink::makeVdbGrid(volume.field(), conversion), std::invalid_argument);
  const auto some = ball<float>(GridGeometry({ 8, 8, 8 }), { 4, 4, 4 }, 2.0);
  conversion.around = 100.0;
  conversion.halfWidth = 0;
  EXPECT_THROW(ink::makeVdbGrid(some.field(), conversion), std::invalid_argument);
}

} // namespace
