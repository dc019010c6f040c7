// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ink
{

/// Marks on the elements of a grid, one byte each, as in VTK's ghost arrays. An element is marked if its byte
/// has a bit of `mask`. Without bytes no element is marked.
struct ElementMarks
{
  std::span<const std::uint8_t> bytes;
  std::uint8_t mask = 0;

  bool empty() const { return this->bytes.empty(); }
  bool operator[](std::size_t element) const { return (this->bytes[element] & this->mask) != 0; }
};

} // namespace ink
