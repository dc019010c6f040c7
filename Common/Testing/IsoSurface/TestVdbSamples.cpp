// SPDX-License-Identifier: BSD-3-Clause
// Samples straight from a tree against those of the same grid made dense: the same ones, to the bit.

#include "VdbVolumes.h"

#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace
{

using namespace ink::testing;
using ink::CrossingRule;
using ink::NormalMethod;
using ink::VdbGrid;
using ink::VoxelBox;
using openvdb::Coord;
using openvdb::FloatGrid;

/// Compares both ways of sampling; `box` is the part of the grid that is made dense.
/// @param flat a tile, or the background, has exactly the iso-value: only half open is compared
template <class T = float>
void expectSameAsDense(
  const VdbGrid& grid, const VoxelBox& box, double isoValue, bool negate = false, bool flat = false)
{
  const Volume<T> dense = denseOf<T>(grid, box, negate);
  const bool large = dense.values.size() > 1'000'000;
  for (const CrossingRule rule : { CrossingRule::HalfOpen, CrossingRule::Strict })
  {
    for (const NormalMethod method : { NormalMethod::InterpolatedNormal, NormalMethod::Regression })
    {
      SCOPED_TRACE("iso-value " + std::to_string(isoValue) +
        (rule == CrossingRule::Strict ? ", strict" : ", half open") + (negate ? ", negated" : "") +
        ", method " + std::to_string(static_cast<int>(method)));
      if ((rule == CrossingRule::Strict && flat) || (method == NormalMethod::Regression && large))
      {
        continue;
      }
      const ink::SampleOptions options{ rule, method, ink::Arithmetic::Single };
      for (const bool single : { true, false })
      {
        if (single)
        {
          const auto expected = sorted(sampleIsoSurface<float>(dense.field(), isoValue, options));
          EXPECT_TRUE(sorted(sampleIsoSurface<float>(grid, isoValue, options, negate)) == expected);
        }
        else if (!large)
        {
          const auto expected = sorted(sampleIsoSurface<double>(dense.field(), isoValue, options));
          EXPECT_TRUE(sorted(sampleIsoSurface<double>(grid, isoValue, options, negate)) == expected);
        }
      }
    }
  }
  EXPECT_GT(sampleIsoSurface(grid, isoValue, {}, negate).size(), 0u);
}

FloatGrid::Ptr makeGrid(float background)
{
  auto grid = FloatGrid::create(background);
  grid->setName("density");
  return grid;
}

TEST(VdbSamples, LevelSetAgreesWithDense)
{
  const auto sphere =
    openvdb::tools::createLevelSetSphere<FloatGrid>(7.3f, { 1.0f, -2.0f, 3.0f }, 0.5f, 3.0f);
  const VdbGrid grid = readBack<FloatGrid>(sphere);
  const VoxelBox box = padded(grid.activeBox(), 2);
  for (const double iso : { 0.0, 0.4, -0.7 })
  {
    expectSameAsDense(grid, box, iso);
    expectSameAsDense(grid, box, iso, true);
  }
}

TEST(VdbSamples, LevelSetNegatedHasOutwardNormalsOnTheSphere)
{
  const glm::dvec3 center(1.0, -2.0, 3.0);
  const auto sphere =
    openvdb::tools::createLevelSetSphere<FloatGrid>(7.3f, { 1.0f, -2.0f, 3.0f }, 0.5f, 3.0f);
  const auto samples = sampleIsoSurface(readBack<FloatGrid>(sphere), 0.0, {}, true);
  ASSERT_GT(samples.size(), 1000u);
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 out = samples.point(n) - center;
    // The mean of a cell's crossings lies a chord's height below the sphere.
    EXPECT_NEAR(glm::length(out), 7.3, 0.02);
    EXPECT_GT(glm::dot(samples.normal(n), glm::normalize(out)), 0.999);
  }
}

TEST(VdbSamples, DoubleGridAgreesWithDense)
{
  const auto sphere =
    openvdb::tools::createLevelSetSphere<openvdb::DoubleGrid>(5.0f, { 0, 0, 0 }, 0.3f, 3.0f);
  const VdbGrid grid = readBack<openvdb::DoubleGrid>(sphere);
  expectSameAsDense<double>(grid, padded(grid.activeBox(), 2), 0.1);
}

TEST(VdbSamples, FogVolumeAgreesWithDense)
{
  // Its inside is tiles of 1, and parts of its border are sharp.
  const auto fog = openvdb::tools::createLevelSetSphere<FloatGrid>(20.0f, { 0, 0, 0 }, 1.0f, 4.0f);
  openvdb::tools::sdfToFogVolume(*fog);
  const VdbGrid grid = readBack<FloatGrid>(fog);
  for (const double iso : { 0.01, 0.5, 1.0 })
  {
    // Its inside is exactly 1.
    expectSameAsDense(grid, padded(grid.activeBox(), 2), iso, false, iso == 1.0);
  }
}

TEST(VdbSamples, TilesOfAllSizesAgreeWithDense)
{
  // Boxes that are tiles of 8 and 128 voxels, beside each other, beside leaves and alone.
  auto grid = makeGrid(0.0f);
  grid->denseFill({ Coord(-8, -8, -8), Coord(7, 7, -1) }, 2.0f);
  grid->denseFill({ Coord(8, 0, -8), Coord(15, 7, -1) }, 1.0f);
  grid->sparseFill({ Coord(0, 128, 0), Coord(127, 255, 127) }, 3.0f, true);
  grid->sparseFill({ Coord(128, 120, 8), Coord(135, 127, 15) }, 2.0f, false);
  grid->tree().setValue(Coord(16, 8, 0), 5.0f);
  grid->tree().setValue(Coord(-9, -9, -9), 1.0f);
  grid->pruneGrid();
  const VdbGrid read = readBack<FloatGrid>(grid);
  const VoxelBox box{ { -12, -12, -12 }, { 139, 259, 131 } };
  for (const double iso : { 0.5, 1.0, 2.0, 2.5, 4.0 })
  {
    expectSameAsDense(read, box, iso, false, iso == std::floor(iso));
  }
  expectSameAsDense(read, box, -1.5, true);
}

TEST(VdbSamples, InsideOfTheBackgroundAgreesWithDense)
{
  // The background is on the denser side, and holes are not.
  auto grid = makeGrid(1.0f);
  grid->sparseFill({ Coord(0, 0, 0), Coord(15, 7, 7) }, 0.0f, true);
  grid->tree().setValue(Coord(-1, 3, 3), 0.25f);
  const VdbGrid read = readBack<FloatGrid>(grid);
  expectSameAsDense(read, { { -20, -20, -20 }, { 30, 30, 30 } }, 0.5);
}

TEST(VdbSamples, RandomGridsAgreeWithDense)
{
  int compared = 0;
  for (unsigned seed = 0; seed < 40 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto upTo = [&](unsigned n) { return static_cast<int>(random() % n); };
    auto grid = makeGrid(static_cast<float>(upTo(3)));
    grid->setTransform(openvdb::math::Transform::createLinearTransform(0.5 + upTo(3)));
    for (int n = upTo(12); n > 0; --n)
    {
      // Blocks that tiles are made of, boxes that lie across them, and single voxels.
      const int unit = upTo(2) ? 8 : 1;
      const Coord low(unit * (upTo(40 / unit) - 20 / unit), unit * upTo(30 / unit), unit * upTo(20 / unit));
      const Coord high = low.offsetBy(unit * (1 + upTo(2)) - 1, unit * (1 + upTo(2)) - 1, unit - 1);
      const bool missing = upTo(12) == 0;
      grid->sparseFill({ low, high },
        missing ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(upTo(4)), upTo(2) != 0);
    }
    const VdbGrid read = readBack<FloatGrid>(grid);
    for (const double iso : { 0.0, 0.5, 1.0, 2.5, 3.0 })
    {
      const bool negate = upTo(2) != 0;
      if (sampleIsoSurface(read, iso, {}, negate).size() > 0)
      {
        expectSameAsDense(read, { { -24, -4, -4 }, { 36, 44, 24 } }, iso, negate, iso == std::floor(iso));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 50);
}

TEST(VdbSamples, FarAwayVoxelsKeepTheirPositions)
{
  auto grid = makeGrid(0.0f);
  constexpr int far = 1 << 29;
  grid->tree().setValue(Coord(-far, far, 17), 1.0f);
  grid->tree().setValue(Coord(far, 5, -far), 1.0f);
  const auto samples = sampleIsoSurface(readBack<FloatGrid>(grid), 0.5);
  ASSERT_EQ(samples.size(), 16u);
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 p = samples.point(n);
    const glm::dvec3 voxel = p.x < 0 ? glm::dvec3(-far, far, 17) : glm::dvec3(far, 5, -far);
    EXPECT_LT(glm::distance(p, voxel), 0.5);
    EXPECT_GT(glm::dot(samples.normal(n), p - voxel), 0.0);
  }
}

TEST(VdbSamples, NothingToSampleGivesNothing)
{
  const VdbGrid empty = readBack<FloatGrid>(makeGrid(1.0f));
  EXPECT_TRUE(empty.activeBox().empty());
  EXPECT_EQ(sampleIsoSurface(empty, 0.5).size(), 0u);
  auto one = makeGrid(0.0f);
  one->tree().setValue(Coord(3, 4, 5), 1.0f);
  const VdbGrid grid = readBack<FloatGrid>(one);
  EXPECT_EQ(sampleIsoSurface(grid, 1.5).size(), 0u);
  EXPECT_EQ(sampleIsoSurface(grid, -1.0).size(), 0u);
  EXPECT_EQ(sampleIsoSurface(grid, std::numeric_limits<double>::quiet_NaN()).size(), 0u);
  EXPECT_EQ(sampleIsoSurface(grid, 0.5).size(), 8u);
}

TEST(VdbSamples, AreTheSameOnOneAndTwoThreads)
{
  const auto sphere = openvdb::tools::createLevelSetSphere<FloatGrid>(30.0f, { 0, 0, 0 }, 0.5f, 3.0f);
  const VdbGrid grid = readBack<FloatGrid>(sphere);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const auto one = sampleIsoSurface(grid, 0.0);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  const auto two = sampleIsoSurface(grid, 0.0);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_TRUE(one == two);
}

TEST(VdbSamples, ComeInTheOrderOfTheirBlocks)
{
  const auto sphere = openvdb::tools::createLevelSetSphere<FloatGrid>(20.0f, { 0, 0, 0 }, 1.0f, 3.0f);
  const auto cells = ink::findActiveCells(readBack<FloatGrid>(sphere), 0.0, CrossingRule::HalfOpen, false);
  std::size_t count = 0;
  for (std::size_t n = 0; n < cells.blocks.size(); ++n)
  {
    const glm::ivec3 a = cells.blocks[n].first;
    EXPECT_EQ(cells.blocks[n].before, count);
    for (const std::uint64_t layer : cells.blocks[n].cells)
    {
      count += static_cast<std::size_t>(__builtin_popcountll(layer));
    }
    if (n > 0)
    {
      const glm::ivec3 b = cells.blocks[n - 1].first;
      EXPECT_LT(std::tie(b.z, b.y, b.x), std::tie(a.z, a.y, a.x));
    }
  }
  EXPECT_EQ(count, cells.count);
}

} // namespace
