// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoValue.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

/// The volumes that tests of iso-values are of.
namespace ink::testing::iso
{

inline constexpr int size = 48;
inline constexpr std::array<int, 3> cube{ size, size, size };

/// A number in [-1, 1] that depends on index alone.
inline double noise(std::uint64_t index)
{
  index = (index + 0x9e3779b97f4a7c15U) * 0xbf58476d1ce4e5b9U;
  index = (index ^ (index >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((index ^ (index >> 31U)) >> 11U) * 0x1p-52 - 1.0;
}

/// A volume of the value f(distance to the center, voxel index).
template <typename T>
std::vector<T> volume(const std::function<double(double, std::size_t)>& f)
{
  std::vector<T> values;
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const double c = (size - 1) / 2.0;
        values.push_back(static_cast<T>(f(std::hypot(x - c, y - c, z - c), values.size())));
      }
    }
  }
  return values;
}

/// From 1 inside to 0 outside of a sphere, over about three voxels.
inline double blurredSphere(double distance, double radius)
{
  return 1.0 / (1.0 + std::exp(2.0 * (distance - radius)));
}

/// What is suggested for such a volume, best first.
template <typename T>
std::vector<ink::IsoSuggestion> suggestAll(const std::vector<T>& values)
{
  return ink::suggestIsoValues<T>(values, cube);
}

template <typename T>
std::optional<ink::IsoSuggestion> suggest(const std::vector<T>& values)
{
  const auto all = suggestAll(values);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

/// A suggestion of the kind, with a value between the limits.
inline void expectBetween(const std::optional<ink::IsoSuggestion>& suggestion,
  ink::IsoSuggestion::Boundary boundary, double low, double high)
{
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, boundary);
  EXPECT_GT(suggestion->value, low);
  EXPECT_LT(suggestion->value, high);
}

} // namespace ink::testing::iso
