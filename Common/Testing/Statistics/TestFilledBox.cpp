// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/FilledBox.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace
{

using Box = std::array<int, 6>;
const std::array<int, 3> size{ 12, 10, 9 };
const Box box{ 2, 9, 0, 6, 3, 8 };

/// 1 in the box, 0 elsewhere.
std::vector<float> volume()
{
  std::vector<float> values;
  for (int n = 0; n < size[0] * size[1] * size[2]; ++n)
  {
    const std::array<int, 3> at{ n % size[0], n / size[0] % size[1], n / (size[0] * size[1]) };
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      inside = inside && at[axis] >= box[2 * axis] && at[axis] <= box[2 * axis + 1];
    }
    values.push_back(inside ? 1.0F : 0.0F);
  }
  return values;
}

std::optional<Box> find(const std::vector<float>& values, int slicesAtOnce = 4)
{
  const std::size_t slice = static_cast<std::size_t>(size[0]) * size[1];
  const ink::SliceReader<float> read = [&](int first, int last)
  { return std::span(values).subspan(slice * first, slice * (last - first)); };
  return ink::findFilledBox(read, size, slicesAtOnce, 0.0);
}

TEST(FilledBox, IsFoundHoweverManySlicesAreRead)
{
  for (const int slicesAtOnce : { 1, 4, 9, 100 })
  {
    EXPECT_EQ(find(volume(), slicesAtOnce), box) << slicesAtOnce;
  }
}

TEST(FilledBox, MayHaveFewHoles)
{
  std::vector<float> values = volume();
  const auto begin = static_cast<std::size_t>(size[0]) * size[1] * 4;
  std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(begin) + 4, 5, 0.0F);
  EXPECT_EQ(find(values), box);
  std::fill_n(
    values.begin() + static_cast<std::ptrdiff_t>(begin), 40, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(find(values), std::nullopt) << "a tenth of it";
}

TEST(FilledBox, IsNeitherAllNorNothing)
{
  std::vector<float> values = volume();
  std::fill(values.begin(), values.end(), 1.0F);
  EXPECT_EQ(find(values), std::nullopt);
  std::fill(values.begin(), values.end(), 0.0F);
  EXPECT_EQ(find(values), std::nullopt);
}

TEST(FilledBox, IsNotThatOfOtherShapes)
{
  std::vector<float> values = volume();
  values.front() = 1.0F;
  EXPECT_EQ(find(values), std::nullopt);
}

TEST(FilledBox, RefusesSlicesOfAnotherSize)
{
  const ink::SliceReader<float> read = [](int, int) { return std::span<const float>(); };
  EXPECT_THROW(ink::findFilledBox(read, size, 4, 0.0), std::invalid_argument);
}

} // namespace
