// SPDX-License-Identifier: BSD-3-Clause
// Noise around surfaces of sparse grids against that of the same values in a dense one.

#include "AnalyticFields.h"
#include "HashNoise.h"
#include "SampledMeshes.h"
#include "Statistics/Vdb/VdbNoiseEstimate.h"
#include "VdbVolumes.h"

#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

using namespace ink::testing;
using ink::estimateNoise;
using ink::NoiseEstimate;

/// A ball of radius 20, or a hollow one of a thickness, blurred by .7 voxels: 1 inside, 0 outside, with
/// noise.
Volume<float> scan(double noise, double thickness = 40.0)
{
  const int n = 64;
  std::uint64_t index = 0;
  return Volume<float>::from(ink::GridGeometry(glm::ivec3(n), glm::dvec3(-0.5 * (n - 1))),
    [&](const glm::dvec3& p)
    {
      const double distance = std::abs(glm::length(p) - (20.0 - 0.5 * thickness)) - 0.5 * thickness;
      return 0.5 * std::erfc(distance / 0.99) + noise * hashNormal(3, index++);
    });
}

void expectNear(const NoiseEstimate& found, const NoiseEstimate& expected, double share)
{
  EXPECT_NEAR(found.noise, expected.noise, share * expected.noise);
  EXPECT_NEAR(found.step, expected.step, share * expected.step);
  EXPECT_EQ(found.thickness, expected.thickness);
  EXPECT_NEAR(ink::suggestSmoothing(found, glm::dvec3(1.0)), ink::suggestSmoothing(expected, glm::dvec3(1.0)),
    share * ink::suggestSmoothing(expected, glm::dvec3(1.0)));
}

TEST(VdbNoiseEstimate, OfAWholeVolumeIsThatOfTheVolume)
{
  for (const double noise : { 0.02, 0.05, 0.1 })
  {
    for (const double thickness : { 40.0, 4.0 })
    {
      const Volume<float> volume = scan(noise, thickness);
      const NoiseEstimate found = estimateNoise(makeVdbGrid(volume.field(), {}), 0.5, false);
      SCOPED_TRACE(testing::Message() << noise << ", " << thickness);
      expectNear(found, estimateNoise(volume.field(), 0.5), 0.03);
    }
  }
}

TEST(VdbNoiseEstimate, OfABandIsThatOfItsVoxels)
{
  for (const double noise : { 0.02, 0.05, 0.1 })
  {
    const Volume<float> volume = scan(noise);
    const ink::VdbGrid band = makeVdbGrid(volume.field(), { .around = 0.5 });
    SCOPED_TRACE(noise);
    expectNear(estimateNoise(band, 0.5, false), estimateNoise(volume.field(), 0.5), 0.1);
  }
}

TEST(VdbNoiseEstimate, DoesNotDependOnThreads)
{
  const ink::VdbGrid grid = makeVdbGrid(scan(0.05).field(), {});
  const auto run = [&]
  {
    const NoiseEstimate found = estimateNoise(grid, 0.5, false);
    return std::array{ found.noise, found.quantum, found.step, found.thickness };
  };
  EXPECT_EQ(ink::test::onThreads(1, run), ink::test::onThreads(3, run));
}

TEST(VdbNoiseEstimate, ALevelSetHasNone)
{
  const auto ball =
    openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(20.0f, { 0.3f, 0.2f, 0.1f }, 1.0f);
  const NoiseEstimate found = estimateNoise(readBack<openvdb::FloatGrid>(ball), 0.0, true);
  EXPECT_LT(found.noise, 0.01);
  EXPECT_GT(found.step, 3.0) << "voxels";
  EXPECT_EQ(ink::suggestSmoothing(found, glm::dvec3(1.0)), 0.0);
}

TEST(VdbNoiseEstimate, InactiveVoxelsOfAFogHaveTheirValues)
{
  auto fog = openvdb::FloatGrid::create(0.0f);
  fog->setName("density");
  fog->setGridClass(openvdb::GRID_FOG_VOLUME);
  // All of its surface lies between active and inactive voxels.
  for (int x = -14; x <= 14; ++x)
  {
    for (int y = -14; y <= 14; ++y)
    {
      for (int z = -14; z <= 14; ++z)
      {
        if (x * x + y * y + z * z < 14 * 14)
        {
          fog->tree().setValue({ x, y, z }, 1.0f);
        }
      }
    }
  }
  const ink::VdbGrid grid = readBack<openvdb::FloatGrid>(fog);
  const NoiseEstimate found = estimateNoise(grid, 0.5, false);
  EXPECT_EQ(found.step, 1.0);
  EXPECT_EQ(found.quantum, 1.0);
  EXPECT_EQ(found.thickness, NoiseEstimate::thickEnough);
  const Volume<float> dense = denseOf<float>(grid, padded(grid.activeBox(), 3));
  EXPECT_EQ(ink::suggestSmoothing(found, glm::dvec3(1.0)),
    ink::suggestSmoothing(estimateNoise(dense.field(), 0.5), glm::dvec3(1.0)));
}

TEST(VdbNoiseEstimate, SaysNothingOfAnEmptyGrid)
{
  auto empty = openvdb::FloatGrid::create(0.0f);
  empty->setName("density");
  const NoiseEstimate found = estimateNoise(readBack<openvdb::FloatGrid>(empty), 0.5, false);
  EXPECT_EQ(found.noise, 0.0);
  EXPECT_EQ(found.step, 0.0);
}

} // namespace
