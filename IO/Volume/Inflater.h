// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileHandle.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace ink::io
{

/// Reads what a part of a file is when it is inflated: a stream of zlib or gzip, or several one after the
/// other.
class Inflater
{
public:
  /// @param offset where the stream begins in the file
  /// @throws ReadError if the file cannot be opened.
  Inflater(const std::filesystem::path& file, std::uint64_t offset);
  ~Inflater();
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Fills bytes with the next ones. @return how many there were
  /// @throws ReadError if the stream is broken.
  std::size_t read(std::span<unsigned char> bytes);

  /// zlib makes at most that many bytes of one.
  static constexpr std::uint64_t mostPerByte = 1032;

private:
  struct Stream;

  std::filesystem::path Path;
  FileHandle File;
  std::uint64_t Position;
  std::unique_ptr<Stream> Zlib;
};

} // namespace ink::io
