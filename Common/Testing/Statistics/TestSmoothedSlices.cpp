// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/SmoothedSlices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace
{

constexpr std::array<int, 3> dimensions{ 7, 6, 9 };
constexpr std::size_t slice = 7 * 6;
constexpr std::size_t count = slice * 9;
constexpr std::size_t middle = 3 + 7 * (2 + 6 * 4);

/// All slices of `values`, so many at a time, read in parts of `atOnce`.
std::vector<double> smooth(const std::vector<float>& values, int atOnce = 9, int wanted = 9)
{
  const ink::SliceReader<float> read = [&](int first, int last)
  {
    EXPECT_LE(last - first, atOnce);
    // A copy, so that what is kept of earlier calls would show.
    static std::vector<float> slices;
    slices.assign(values.begin() + first * static_cast<std::ptrdiff_t>(slice),
      values.begin() + last * static_cast<std::ptrdiff_t>(slice));
    return std::span<const float>(slices);
  };
  const ink::SliceReader<double> smoothed = ink::smoothedSlices(read, dimensions, atOnce);
  std::vector<double> result;
  for (int first = 0; first < dimensions[2]; first += wanted)
  {
    const std::span<const double> part = smoothed(first, std::min(first + wanted, dimensions[2]));
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

std::vector<float> anyValues()
{
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = static_cast<float>(i * i % 101);
  }
  return values;
}

TEST(SmoothedSlices, SpreadOneVoxelAsTheBinomialKernel)
{
  std::vector<float> values(count, 0.0F);
  values[middle] = 64.0F;
  const std::vector<double> smoothed = smooth(values);
  for (int z = -2; z <= 2; ++z)
  {
    for (int y = -2; y <= 2; ++y)
    {
      for (int x = -2; x <= 2; ++x)
      {
        const auto weight = [](int d) { return 2 - std::min(std::abs(d), 2); };
        const auto at = static_cast<std::ptrdiff_t>(middle) + x + 7 * (y + 6 * z);
        EXPECT_EQ(smoothed[static_cast<std::size_t>(at)], weight(x) * weight(y) * weight(z));
      }
    }
  }
}

TEST(SmoothedSlices, KeepWhatIsConstantUpToBordersAndMissingVoxels)
{
  std::vector<float> values(count, 5.0F);
  values[0] = values[middle] = std::numeric_limits<float>::quiet_NaN();
  values[middle + 1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(smooth(values), std::vector<double>(count, 5.0)) << "also missing voxels beside others";
  values.assign(count, std::numeric_limits<float>::quiet_NaN());
  values[0] = 1.0F;
  const std::vector<double> smoothed = smooth(values);
  EXPECT_EQ(smoothed[1], 1.0);
  EXPECT_TRUE(std::isnan(smoothed[2]));
}

TEST(SmoothedSlices, AreTheSameInAnyParts)
{
  const std::vector<double> whole = smooth(anyValues());
  for (const int atOnce : { 1, 2, 3, 9, 20 })
  {
    for (const int wanted : { 1, 3, 9 })
    {
      EXPECT_EQ(smooth(anyValues(), atOnce, wanted), whole) << atOnce << ' ' << wanted;
    }
  }
}

TEST(SmoothedSlices, RefuseSlicesOfAnotherSize)
{
  const std::vector<float> values(7);
  const ink::SliceReader<float> read = [&](int, int) { return std::span<const float>(values); };
  EXPECT_THROW(ink::smoothedSlices(read, dimensions, 3)(0, 2), std::invalid_argument);
}

} // namespace
