// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>

namespace ink::io
{

/// The number whose bytes begin here, at any address.
/// @param swapped whether they are in the other order than this machine's
template <class T>
T valueFrom(const void* bytes, bool swapped)
{
  std::array<unsigned char, sizeof(T)> ordered;
  std::copy_n(static_cast<const unsigned char*>(bytes), sizeof(T), ordered.begin());
  if (swapped)
  {
    std::reverse(ordered.begin(), ordered.end());
  }
  return std::bit_cast<T>(ordered);
}

} // namespace ink::io
