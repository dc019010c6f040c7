// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace ink::io
{

/// The first bytes of a file: as many as are asked for, or all there are, inflated where it is a gzip file.
struct FirstBytes
{
  bool compressed = false;
  std::vector<unsigned char> bytes;

  /// @throws ReadError if a compressed one is broken
  FirstBytes(const std::filesystem::path& file, std::size_t count);
};

} // namespace ink::io
