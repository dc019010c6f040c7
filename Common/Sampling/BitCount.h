#pragma once

#include <cstdint>

namespace ink
{

/// How many bits are set, without an instruction for it, which not every x86-64 has: std::popcount calls a
/// function there.
inline int bitCount(std::uint64_t bits)
{
  bits -= bits >> 1 & 0x5555555555555555;
  bits = (bits & 0x3333333333333333) + (bits >> 2 & 0x3333333333333333);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0f;
  return static_cast<int>(bits * 0x0101010101010101 >> 56);
}

} // namespace ink
