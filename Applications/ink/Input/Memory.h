// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace ink::cli
{

/// Up to how much memory a command takes, and what of it is for what. Sizes are in bytes.
struct Memory
{
  std::uint64_t limit;

  /// Half of the machine's memory, or of what this process is allowed if that is less.
  Memory();
  /// From a number with a unit, as 800MiB or 1.5GiB; units are powers of 1024, their iB may be left out.
  /// @throws UsageError
  static Memory parse(const std::string& size);

  /// A volume of up to this size is read whole.
  std::uint64_t forWholeVolume() const { return this->free() / 2; }
  /// For slices of a larger one.
  std::uint64_t forSlices() const { return this->free() / 4; }
  /// For the points that are made at a time.
  std::uint64_t forNewPoints() const { return this->free() / 4; }
  /// For the points that wait to be written.
  std::uint64_t forKeptPoints() const { return this->free() / 8; }

  /// The least limit whose `share` is as large as size, with that share being 1 / part of what is free.
  static std::uint64_t limitFor(std::uint64_t size, int part);

private:
  std::uint64_t free() const;
};

/// "12 MiB", rounded up.
std::string memoryText(std::uint64_t bytes);

} // namespace ink::cli
