// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ActiveCellExtent.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace
{

const std::array<int, 3> size{ 40, 30, 20 };

struct Volume
{
  std::vector<float> values =
    std::vector<float>(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1] * size[2]));

  void fill(const std::array<int, 3>& first, const std::array<int, 3>& last, float value)
  {
    for (int z = first[2]; z <= last[2]; ++z)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        for (int x = first[0]; x <= last[0]; ++x)
        {
          this->values[static_cast<std::size_t>(x + size[0] * (y + size[1] * z))] = value;
        }
      }
    }
  }

  std::array<int, 3> extent(int slicesAtOnce = size[2], double isoValue = 1.0) const
  {
    const std::size_t slice = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
    const ink::SliceReader<float> read = [&](int first, int last)
    {
      return std::span(this->values)
        .subspan(slice * static_cast<std::size_t>(first), slice * static_cast<std::size_t>(last - first));
    };
    return ink::activeCellExtent(read, size, slicesAtOnce, isoValue);
  }
};

TEST(ActiveCellExtent, IsThatOfABox)
{
  Volume volume;
  volume.fill({ 10, 5, 6 }, { 21, 20, 13 }, 1.0F);
  // The edges into a box begin one sample before it.
  EXPECT_EQ(volume.extent(), (std::array{ 13, 17, 9 }));
  for (const int slices : { 2, 3, 7, 19 })
  {
    EXPECT_EQ(volume.extent(slices), volume.extent()) << slices;
  }
}

TEST(ActiveCellExtent, DoesNotCountSpecks)
{
  Volume volume;
  volume.fill({ 8, 3, 4 }, { 27, 24, 16 }, 1.0F);
  EXPECT_EQ(volume.extent(), (std::array{ 21, 23, 14 }));
  volume.fill({ 38, 28, 18 }, { 38, 28, 18 }, 1.0F);
  EXPECT_EQ(volume.extent(), (std::array{ 21, 23, 14 })) << "6 of 1,978 edges";
  volume.fill({ 33, 26, 16 }, { 38, 28, 18 }, 1.0F);
  EXPECT_EQ(volume.extent()[0], 32) << "no speck";
}

TEST(ActiveCellExtent, IsOfAllAroundWhatIsBelow)
{
  Volume volume;
  volume.fill({ 0, 0, 0 }, { 39, 29, 19 }, 2.0F);
  volume.fill({ 10, 5, 6 }, { 21, 20, 13 }, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(volume.extent(), (std::array{ 13, 17, 9 }));
}

TEST(ActiveCellExtent, IsNoneWithoutASurface)
{
  Volume volume;
  EXPECT_EQ(volume.extent(), (std::array{ 0, 0, 0 }));
  EXPECT_EQ(volume.extent(2, 1e300), (std::array{ 0, 0, 0 }));
  volume.fill({ 0, 0, 0 }, { 39, 29, 19 }, 2.0F);
  EXPECT_EQ(volume.extent(), (std::array{ 0, 0, 0 }));
}

} // namespace
