// SPDX-License-Identifier: BSD-3-Clause
// Whole grids resampled, against one tile of the same positions.
#include "Fields/Resampling/ResampleGrid.h"
#include "SampledVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <span>
#include <stdexcept>
#include <vector>

namespace
{

using ink::AxisResampling;

/// Larger than one tile along each axis.
ink::testing::Volume<float> makeVolume()
{
  const auto wave = [](const glm::dvec3& p) { return std::sin(0.3 * p.x) + 0.1 * p.y * std::cos(0.2 * p.z); };
  return ink::testing::Volume<float>::from(ink::GridGeometry({ 40, 23, 37 }), wave);
}

const ink::GridResampling resampling = { AxisResampling(0.7, 2, 40), AxisResampling(0.0, 3, 23),
  AxisResampling(1.5, 1, 37) };
const glm::ivec3 positions(79, 67, 37);

TEST(ResampleGrid, ValuesAreThoseOfATileForAnyNumberOfThreads)
{
  const auto volume = makeVolume();
  const ink::SampleBox all = { glm::ivec3(0), positions };
  ink::TileResampler<double> tile;
  tile.read(volume.field(), all, { 2, 3, 1 }, glm::ivec3(8));
  std::vector<double> wanted;
  tile.resample(resampling, all, wanted);
  for (const char* threads : { "1", "2" })
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    std::vector<double> values(all.count(), -7.0);
    EXPECT_TRUE(ink::resampleGrid(volume.field(), resampling, std::span<double>(values)));
    EXPECT_EQ(std::memcmp(values.data(), wanted.data(), sizeof(double) * wanted.size()), 0);
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(ResampleGrid, ValuesAreTheSameInAnyBox)
{
  const auto volume = makeVolume();
  std::vector<float> all(ink::SampleBox{ glm::ivec3(0), positions }.count());
  ink::resampleGrid(volume.field(), resampling, std::span<float>(all));
  const ink::SampleBox box = { { 41, 31, 11 }, { 78, 66, 36 } };
  std::vector<float> some(box.count());
  ink::resampleGrid(volume.field(), resampling, box, std::span<float>(some));
  auto found = some.begin();
  for (int z = box.begin.z; z < box.end.z; ++z)
  {
    for (int y = box.begin.y; y < box.end.y; ++y)
    {
      for (int x = box.begin.x; x < box.end.x; ++x)
      {
        ASSERT_EQ(*found++, all[static_cast<std::size_t>((z * positions.y + y) * positions.x + x)]);
      }
    }
  }
}

TEST(ResampleGrid, MissingSamplesLeaveHolesOrNothing)
{
  auto volume = makeVolume();
  for (int n = 0; n < 27 * 27 * 27; ++n)
  {
    const glm::ivec3 at(n % 27, n / 27 % 27, n / 27 / 27);
    if (at.y < 23)
    {
      volume.at(at) = std::nanf("");
    }
  }
  std::vector<float> values(ink::SampleBox{ glm::ivec3(0), positions }.count());
  EXPECT_TRUE(ink::resampleGrid(volume.field(), resampling, std::span<float>(values)));
  EXPECT_TRUE(std::isnan(values.front()));
  EXPECT_TRUE(std::isfinite(values.back()));
}

TEST(ResampleGrid, RefusesRoomForFewerValuesAndStops)
{
  const auto volume = makeVolume();
  std::vector<float> values(7);
  EXPECT_THROW(
    ink::resampleGrid(volume.field(), resampling, std::span<float>(values)), std::invalid_argument);
  values.resize(ink::SampleBox{ glm::ivec3(0), positions }.count());
  EXPECT_FALSE(
    ink::resampleGrid(volume.field(), resampling, std::span<float>(values), [](double) { return false; }));
}

} // namespace
