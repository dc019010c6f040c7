// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/CoveredSides.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace
{

const std::array<int, 3> size{ 5, 4, 6 };

/// Above 10 are x = 0 wholly, half of y = 3, and what these have of the other sides.
std::vector<float> volume()
{
  std::vector<float> values;
  for (int n = 0; n < size[0] * size[1] * size[2]; ++n)
  {
    const int x = n % size[0];
    const int y = n / size[0] % size[1];
    const int z = n / (size[0] * size[1]);
    values.push_back(x == 0 || (y == 3 && z < 3) ? 11.0F : 10.0F);
  }
  return values;
}

std::array<double, 6> sidesOf(const std::vector<float>& values, int slicesAtOnce)
{
  const std::size_t slice = static_cast<std::size_t>(size[0]) * size[1];
  const ink::SliceReader<float> read = [&](int first, int last)
  { return std::span(values).subspan(slice * first, slice * (last - first)); };
  return ink::coveredSides(read, size, slicesAtOnce, 10.0);
}

TEST(CoveredSides, AreSharesOfEachSideHoweverManySlicesAreRead)
{
  const std::array<double, 6> expected{ 1.0, 3.0 / 24, 6.0 / 30, (6.0 + 3 * 4) / 30, 8.0 / 20, 4.0 / 20 };
  for (const int slicesAtOnce : { 1, 4, 6, 100 })
  {
    const std::array<double, 6> found = sidesOf(volume(), slicesAtOnce);
    for (std::size_t side = 0; side < 6; ++side)
    {
      EXPECT_DOUBLE_EQ(found[side], expected[side]) << side;
    }
  }
}

TEST(CoveredSides, AreNotCoveredByWhatIsMissing)
{
  std::vector<float> values = volume();
  values[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_DOUBLE_EQ(sidesOf(values, 6)[0], 23.0 / 24);
}

TEST(CoveredSides, SurroundAnObjectIfFourAreWhole)
{
  EXPECT_TRUE(ink::surroundsObject({ 1, 1, 1, 1, 0, 0 })) << "a tube from end to end";
  EXPECT_TRUE(ink::surroundsObject({ 0.96, 0, 1, 1, 1, 1 }));
  EXPECT_FALSE(ink::surroundsObject({ 0, 0, 1, 1, 1, 0.9 }));
  EXPECT_FALSE(ink::surroundsObject({ 0.9, 0.9, 0.9, 0.9, 0.9, 0.9 })) << "a rock with pores";
}

} // namespace
