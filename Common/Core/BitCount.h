// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ink
{

/// The number of set bits, without the instruction that baseline x86-64 lacks: std::popcount calls a library
/// function there.
inline int bitCount(std::uint64_t bits)
{
  bits -= bits >> 1 & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<int>(bits * 0x0101010101010101 >> 56);
}

} // namespace ink
