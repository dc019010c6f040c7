// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace ink::testing
{

/// FNV-1a of the numbers' bits.
inline std::uint64_t bitHash(std::span<const float> numbers)
{
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const float number : numbers)
  {
    hash = (hash ^ std::bit_cast<std::uint32_t>(number)) * 0x100000001b3;
  }
  return hash;
}

} // namespace ink::testing
