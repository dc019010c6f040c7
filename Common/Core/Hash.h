// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ink
{

/// A 64-bit hash: the finalizer of SplitMix64 (Steele, Lea and Flood 2014, fig. 15).
constexpr std::uint64_t hash(std::uint64_t value)
{
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

/// The hash of a seed and an id: a random number that depends on nothing else.
constexpr std::uint64_t hash(std::uint64_t seed, std::uint64_t id)
{
  return hash(hash(seed) ^ id);
}

constexpr std::uint64_t hash(std::uint64_t seed, std::uint64_t id, std::uint64_t index)
{
  return hash(hash(seed, id) ^ index);
}

/// In [0, 1), from the upper 53 bits.
constexpr double unitDouble(std::uint64_t bits)
{
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// In [0, 1), from 24 of the upper (`half` 0) or the lower (`half` 1) 32 bits.
constexpr float unitFloat(std::uint64_t bits, int half = 0)
{
  const auto word = static_cast<std::uint32_t>(half == 0 ? bits >> 32 : bits);
  return static_cast<float>(word >> 8) * 0x1p-24f;
}

} // namespace ink
