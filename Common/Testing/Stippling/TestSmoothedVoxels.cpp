// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/SmoothedVoxels.h"

#include "Fields/Grid/PieceOwnership.h"
#include "Fields/Resampling/ResampleGrid.h"

#include "SampledVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::stipple;
using namespace ink::testing;

constexpr GradientOptions central{ GradientMethod::CentralDifference };

SampleBox wholeOf(const GridGeometry& geometry)
{
  return { glm::ivec3(0), geometry.dimensions() };
}

template <class T>
StippledVoxels voxelsOf(const GridField<T>& field, const glm::dvec3& deviation,
  const VoxelCriteria& criteria = {}, const GradientOptions& gradient = central)
{
  StippledVoxels voxels;
  EXPECT_TRUE(findStippledVoxels(field, deviation, wholeOf(field.geometry()), gradient, criteria, voxels));
  return voxels;
}

void expectEqual(const StippledVoxels& a, const StippledVoxels& b)
{
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.gradients, b.gradients);
  EXPECT_EQ(a.values, b.values);
}

/// Waves on more slices than are smoothed at a time, as noisy as any.
template <class T>
Volume<T> waves()
{
  return Volume<T>::from(GridGeometry({ 41, 23, 71 }, glm::dvec3(5.0), { 1.0, 1.0, 2.0 }),
    [](const glm::dvec3& p)
    { return 100.0 + 50.0 * std::sin(0.7 * p.x) * std::cos(0.9 * p.y) + 40.0 * std::sin(1.1 * p.x * p.z); });
}

} // namespace

TEST(SmoothedStippledVoxels, OfARampHaveItsSlope)
{
  const auto volume = Volume<double>::from(GridGeometry({ 30, 30, 70 }, glm::dvec3(0.0), { 1.0, 1.0, 2.0 }),
    [](const glm::dvec3& p) { return 2.0 * p.x - p.y + 0.5 * p.z; });
  const StippledVoxels voxels =
    voxelsOf(volume.field(), smoothingDeviation(volume.geometry, 1.5), { .threshold = 0.1f });
  ASSERT_EQ(voxels.size(), volume.values.size());
  // At a distance from the ends, where half of the Gaussian is missing.
  constexpr int far = 8;
  int checked = 0;
  for (glm::ivec3 s(far); s.z < 70 - far; ++s.z)
  {
    for (s.y = far; s.y < 30 - far; ++s.y)
    {
      for (s.x = far; s.x < 30 - far; ++s.x)
      {
        const glm::vec3 gradient = voxels.gradients[volume.geometry.offset(s)];
        EXPECT_NEAR(gradient.x, 2.0, 1e-5);
        EXPECT_NEAR(gradient.y, -1.0, 1e-5);
        EXPECT_NEAR(gradient.z, 0.5, 1e-5);
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 14 * 14 * 54);
}

TEST(SmoothedStippledVoxels, OfAStepHaveTheGaussiansIntegral)
{
  constexpr double deviation = 2.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::ivec3 size(9);
    size[axis] = 80;
    const auto volume = Volume<float>::from(
      GridGeometry(size), [axis](const glm::dvec3& p) { return p[axis] < 39.5 ? 0.0 : 1000.0; });
    const StippledVoxels voxels = voxelsOf(volume.field(), glm::dvec3(deviation), { .threshold = 1e-3f });
    const SampleBox box = voxels.box;
    int checked = 0;
    for (int row = 0; row < box.size().y * box.size().z; ++row)
    {
      for (std::size_t n = voxels.rows[row]; n < voxels.rows[row + 1]; ++n)
      {
        const glm::ivec3 at(voxels.x[n], row % box.size().y, row / box.size().y);
        const auto integral = [&](double x)
        { return 500.0 * std::erfc((39.5 - x) / (deviation * std::sqrt(2.0))); };
        const double x = at[axis];
        // Of 1000; within 1.7 and 1.5, as the Gaussian ends somewhere and smooths what is interpolated.
        EXPECT_NEAR(voxels.values[n], integral(x), 2.5) << "axis " << axis << ", at " << x;
        EXPECT_NEAR(voxels.gradients[n][axis], 0.5 * (integral(x + 1.0) - integral(x - 1.0)), 2.2);
        ++checked;
      }
    }
    // Some deviations on both sides of the step.
    EXPECT_GT(checked, 9 * 9 * 12);
  }
}

TEST(SmoothedStippledVoxels, AreThoseOfASmoothedGridForAnyNumberOfThreads)
{
  const auto volume = waves<float>();
  const glm::ivec3 size = volume.geometry.dimensions();
  const glm::dvec3 deviation = smoothingDeviation(volume.geometry, 1.2);
  EXPECT_EQ(deviation, glm::dvec3(1.2, 1.2, 0.6));
  Volume<float> smoothed(volume.geometry);
  const GridResampling resampling = { AxisResampling(1.2, 1, size.x), AxisResampling(1.2, 1, size.y),
    AxisResampling(0.6, 1, size.z) };
  ASSERT_TRUE(resampleGrid(volume.field(), resampling, std::span<float>(smoothed.values)));
  for (const GradientOptions& gradient : { central, GradientOptions{} })
  {
    const PieceOwnership all(size, wholeOf(volume.geometry));
    VolumeStatistics wanted;
    ASSERT_TRUE(measureVolume(smoothed.field(), all, gradient, wanted));
    const VoxelCriteria criteria{ .threshold = wanted.magnitudes.quantile(0.6), .lowest = 80.0 };
    StippledVoxels expected;
    ASSERT_TRUE(findStippledVoxels(smoothed.field(), wholeOf(volume.geometry), gradient, criteria, expected));
    EXPECT_GT(expected.size(), 1000u);
    for (const char* threads : { "1", "2" })
    {
      setenv("VTK_SMP_MAX_THREADS", threads, 1);
      VolumeStatistics found;
      ASSERT_TRUE(measureVolume(volume.field(), deviation, all, gradient, found));
      EXPECT_EQ(found.lowest, wanted.lowest);
      EXPECT_EQ(found.highest, wanted.highest);
      EXPECT_EQ(found.magnitudes.quantile(0.6), wanted.magnitudes.quantile(0.6));
      expectEqual(voxelsOf(volume.field(), deviation, criteria, gradient), expected);
    }
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(SmoothedStippledVoxels, WithoutSmoothingAreTheSame)
{
  const auto volume = waves<short>();
  const VoxelCriteria criteria{ .threshold = 20.0f };
  StippledVoxels plain;
  ASSERT_TRUE(findStippledVoxels(volume.field(), wholeOf(volume.geometry), central, criteria, plain));
  EXPECT_GT(plain.size(), 0u);
  expectEqual(voxelsOf(volume.field(), glm::dvec3(0.0), criteria), plain);
}

TEST(SmoothedStippledVoxels, OfMissingSamplesAreNone)
{
  auto volume = waves<double>();
  volume.at({ 20, 10, 40 }) = std::numeric_limits<double>::quiet_NaN();
  volume.at({ 0, 0, 0 }) = std::numeric_limits<double>::infinity();
  std::vector<std::uint8_t> hidden(volume.values.size(), 0);
  hidden[volume.geometry.offset({ 7, 7, 33 })] = 1;
  const StippledVoxels voxels = voxelsOf(volume.field({ hidden, 1 }), glm::dvec3(1.0), { .threshold = 0.0f });
  EXPECT_LE(voxels.size(), volume.values.size() - 3);
  EXPECT_GT(voxels.size(), volume.values.size() - 100);
  for (const glm::ivec3& at : { glm::ivec3(20, 10, 40), glm::ivec3(0, 0, 0), glm::ivec3(7, 7, 33) })
  {
    const auto row = voxels.rows.begin() + at.y + 23 * at.z;
    EXPECT_EQ(std::count(voxels.x.begin() + row[0], voxels.x.begin() + row[1], at.x), 0);
  }
  for (const glm::vec3& gradient : voxels.gradients)
  {
    EXPECT_TRUE(std::isfinite(gradient.x + gradient.y + gradient.z));
  }
}

TEST(SmoothedStippledVoxels, OfASliceAreSmoothedWithinIt)
{
  const auto volume = Volume<std::uint8_t>::from(
    GridGeometry({ 40, 12, 1 }), [](const glm::dvec3& p) { return p.x < 19.5 ? 0.0 : 200.0; });
  const StippledVoxels sharp = voxelsOf(volume.field(), glm::dvec3(0.0), { .threshold = 1.0f });
  const StippledVoxels smooth = voxelsOf(volume.field(), glm::dvec3(2.0), { .threshold = 1.0f });
  EXPECT_EQ(sharp.size(), 2 * 12u);
  EXPECT_GT(smooth.size(), 8 * 12u);
}

TEST(SmoothedStippledVoxels, StopWhenAsked)
{
  const auto volume = waves<float>();
  const SampleBox whole = wholeOf(volume.geometry);
  const auto stop = [](double) { return false; };
  StippledVoxels voxels;
  VolumeStatistics statistics;
  EXPECT_FALSE(findStippledVoxels(volume.field(), glm::dvec3(1.0), whole, central, {}, voxels, stop));
  EXPECT_FALSE(measureVolume(
    volume.field(), glm::dvec3(1.0), { volume.geometry.dimensions(), whole }, central, statistics, stop));
}
