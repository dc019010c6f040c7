// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/StippledVoxels.h"

#include "Fields/Grid/PieceOwnership.h"

#include "AnalyticFields.h"
#include "SampledVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::stipple;
using namespace ink::testing;

constexpr GradientOptions central{ GradientMethod::CentralDifference };

/// A ball that gets less dense towards its border at 8, on 24^3 samples around the origin; the steepest is 8.
template <class T>
Volume<T> ball(const glm::dvec3& spacing = glm::dvec3(1.0))
{
  const GridGeometry geometry(glm::ivec3(24), -11.5 * spacing, spacing);
  return Volume<T>::from(geometry,
    [](const glm::dvec3& p)
    {
      const double r = glm::length(p);
      return r < 8.0 ? 64.0 - 0.5 * r * r : 32.0;
    });
}

SampleBox wholeOf(const GridGeometry& geometry)
{
  return { glm::ivec3(0), geometry.dimensions() };
}

PieceOwnership allOf(const GridGeometry& geometry)
{
  return { geometry.dimensions(), wholeOf(geometry) };
}

/// What findStippledVoxels should find, as sample offsets.
template <class T, class Wanted>
std::vector<std::size_t> samplesWith(const Volume<T>& volume, const Wanted& wanted)
{
  std::vector<std::size_t> found;
  const glm::ivec3 n = volume.geometry.dimensions();
  for (glm::ivec3 s(0); s.z < n.z; ++s.z)
  {
    for (s.y = 0; s.y < n.y; ++s.y)
    {
      for (s.x = 0; s.x < n.x; ++s.x)
      {
        if (wanted(s))
        {
          found.push_back(volume.geometry.offset(s));
        }
      }
    }
  }
  return found;
}

std::vector<std::size_t> samplesOf(const GridGeometry& geometry, const StippledVoxels& voxels)
{
  std::vector<std::size_t> found;
  const glm::ivec3 size = voxels.box.size();
  for (int row = 0; row < size.y * size.z; ++row)
  {
    for (std::size_t n = voxels.rows[row]; n < voxels.rows[row + 1]; ++n)
    {
      found.push_back(geometry.offset(
        { voxels.x[n], voxels.box.begin.y + row % size.y, voxels.box.begin.z + row / size.y }));
    }
  }
  return found;
}

} // namespace

TEST(StippledVoxels, AreThoseWithSteepGradients)
{
  const auto volume = ball<double>({ 1.0, 1.0, 0.5 });
  const auto field = volume.field();
  StippledVoxels voxels;
  ASSERT_TRUE(findStippledVoxels(field, wholeOf(volume.geometry), central, { 4.0f }, voxels));
  const auto gradientAt = [&](const glm::ivec3& s)
  { return volume.geometry.gradientToWorld(field.gradientAt(s)); };
  const auto expected =
    samplesWith(volume, [&](const glm::ivec3& s) { return glm::length(gradientAt(s)) >= 4.0; });
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_EQ(samplesOf(volume.geometry, voxels), expected);
  for (std::size_t n = 0; n < voxels.size(); ++n)
  {
    EXPECT_EQ(voxels.values[n], static_cast<float>(volume.values[expected[n]]));
    EXPECT_GE(glm::length(voxels.gradients[n]), 4.0f * 0.999f);
  }
}

TEST(StippledVoxels, AreThoseThatReachAWindow)
{
  const auto volume = ball<double>({ 1.0, 1.0, 0.5 });
  const auto field = volume.field();
  StippledVoxels voxels;
  ASSERT_TRUE(findStippledVoxels(field, wholeOf(volume.geometry), central, { 1e-3f, 50.0, 50.5 }, voxels));
  const auto expected = samplesWith(volume,
    [&](const glm::ivec3& s)
    {
      const glm::vec3 g = glm::abs(volume.geometry.gradientToWorld(field.gradientAt(s)));
      const double reach = 0.5 * g.x + 0.5 * g.y + 0.25 * g.z;
      return glm::length(g) >= 1e-3 && field.at(s) + reach >= 50.0 && field.at(s) - reach <= 50.5;
    });
  EXPECT_GT(expected.size(), 500u);
  EXPECT_EQ(samplesOf(volume.geometry, voxels), expected);
}

TEST(StippledVoxels, AreNoneWhereNothingChanges)
{
  const Volume<short> constant(GridGeometry(glm::ivec3(5)), 7);
  StippledVoxels voxels;
  EXPECT_TRUE(findStippledVoxels(constant.field(), wholeOf(constant.geometry), {}, {}, voxels));
  EXPECT_EQ(voxels.size(), 0u);
  EXPECT_EQ(voxels.rows.size(), 26u);
  EXPECT_TRUE(findStippledVoxels(constant.field(), SampleBox{}, {}, {}, voxels));
  EXPECT_EQ(voxels.size(), 0u);
}

TEST(StippledVoxels, LeaveMissingSamplesOut)
{
  auto volume = ball<float>();
  volume.at({ 6, 12, 12 }) = std::numeric_limits<float>::quiet_NaN();
  std::vector<std::uint8_t> marks(volume.values.size());
  marks[volume.geometry.offset({ 12, 6, 12 })] = 2;
  volume.at({ 12, 6, 12 }) = 1e30f;
  const auto field = volume.field({ marks, 2 });
  StippledVoxels voxels;
  ASSERT_TRUE(findStippledVoxels(field, wholeOf(volume.geometry), {}, { 1.0f }, voxels));
  const auto found = samplesOf(volume.geometry, voxels);
  EXPECT_GT(found.size(), 1000u);
  for (const glm::ivec3 missing : { glm::ivec3(6, 12, 12), glm::ivec3(12, 6, 12) })
  {
    EXPECT_FALSE(std::binary_search(found.begin(), found.end(), volume.geometry.offset(missing)));
  }
  VolumeStatistics statistics;
  measureVolume(field, allOf(volume.geometry), {}, statistics);
  EXPECT_EQ(statistics.magnitudes.count(), volume.values.size() - 2);
  EXPECT_EQ(statistics.lowest, 32.0);
  EXPECT_LE(statistics.highest, 64.0);
  EXPECT_LT(statistics.magnitudes.quantile(1.0), 10.0f);
}

TEST(StippledVoxels, MeasureTheSameOnAnyNumberOfThreads)
{
  const auto volume = ball<unsigned char>();
  const auto measure = [&](const char* threads)
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    VolumeStatistics statistics;
    EXPECT_TRUE(measureVolume(volume.field(), allOf(volume.geometry), {}, statistics));
    unsetenv("VTK_SMP_MAX_THREADS");
    return statistics;
  };
  const VolumeStatistics one = measure("1");
  const VolumeStatistics two = measure("2");
  EXPECT_EQ(one.magnitudes.count(), 24u * 24u * 24u);
  EXPECT_EQ(one.lowest, 32.0);
  EXPECT_EQ(one.highest, two.highest);
  for (double share = 0.0; share <= 1.0; share += 0.05)
  {
    EXPECT_EQ(one.magnitudes.quantile(share), two.magnitudes.quantile(share)) << share;
  }
}

TEST(StippledVoxels, MeasureOfPartsTogetherWhatTheWholeHas)
{
  const auto volume = ball<float>();
  const auto field = volume.field();
  VolumeStatistics whole;
  ASSERT_TRUE(measureVolume(field, allOf(volume.geometry), central, whole));

  // The lower part by a box, the upper one by marks on 23^3 cells; sample 23 goes with cell 22.
  const glm::ivec3 dimensions = volume.geometry.dimensions();
  std::vector<std::uint8_t> lower(23u * 23u * 23u);
  std::fill_n(lower.begin(), 9u * 23u * 23u, std::uint8_t(1));
  const PieceOwnership below(dimensions, { glm::ivec3(0), { 24, 24, 9 } });
  const PieceOwnership above(dimensions, wholeOf(volume.geometry), { lower, 1 });
  VolumeStatistics parts;
  ASSERT_TRUE(measureVolume(field, below, central, parts));
  EXPECT_EQ(parts.magnitudes.count(), 24u * 24u * 9u);
  ASSERT_TRUE(measureVolume(field, above, central, parts));
  EXPECT_EQ(parts.lowest, whole.lowest);
  EXPECT_EQ(parts.highest, whole.highest);
  const auto expected = whole.magnitudes.bins();
  const auto found = parts.magnitudes.bins();
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), found.begin(), found.end()));
}

TEST(StippledVoxels, StopWhenAsked)
{
  const auto volume = ball<float>();
  const Progress stop = [](double) { return false; };
  StippledVoxels voxels;
  VolumeStatistics statistics;
  EXPECT_FALSE(findStippledVoxels(volume.field(), wholeOf(volume.geometry), {}, {}, voxels, stop));
  EXPECT_FALSE(measureVolume(volume.field(), allOf(volume.geometry), {}, statistics, stop));
}
