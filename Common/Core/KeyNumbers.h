// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Hash.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{

/// Numbers distinct 64-bit keys in the order in which they first occur: a hash table with linear probing for
/// at most the number of keys that it is made for.
class KeyNumbers
{
public:
  explicit KeyNumbers(std::size_t most)
    : Slots(std::bit_ceil(std::max<std::size_t>(2 * most, 2)), none)
  {
    this->Keys.reserve(most);
  }

  std::uint32_t numberOf(std::uint64_t key)
  {
    const std::size_t mask = this->Slots.size() - 1;
    for (std::size_t slot = hash(key) & mask;; slot = (slot + 1) & mask)
    {
      if (this->Slots[slot] == none)
      {
        this->Slots[slot] = static_cast<std::uint32_t>(this->Keys.size());
        this->Keys.push_back(key);
        return this->Slots[slot];
      }
      if (this->Keys[this->Slots[slot]] == key)
      {
        return this->Slots[slot];
      }
    }
  }

  const std::vector<std::uint64_t>& keys() const { return this->Keys; } ///< by number

private:
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> Slots;
  std::vector<std::uint64_t> Keys;
};

} // namespace ink
