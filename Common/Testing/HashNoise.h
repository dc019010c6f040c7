// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace ink::testing
{

/// A number from [0, 1) that depends on nothing but its arguments.
inline double hashUniform(std::uint64_t seed, std::uint64_t index)
{
  // The finishing steps of SplitMix64.
  std::uint64_t h = seed * 0x9e3779b97f4a7c15ull + index + 1;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

/// Normally distributed, with mean 0 and deviation 1 (Box and Muller).
inline double hashNormal(std::uint64_t seed, std::uint64_t index)
{
  constexpr double twoPi = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - hashUniform(seed, 2 * index)));
  return radius * std::cos(twoPi * hashUniform(seed, 2 * index + 1));
}

} // namespace ink::testing
