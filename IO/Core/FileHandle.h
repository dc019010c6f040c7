// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include "ByteSink.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace ink::io
{

/// A file descriptor that is closed when this object goes.
class VTKINKIOCORE_EXPORT FileHandle
{
public:
  /// @param descriptor as from open(): negative if that failed
  explicit FileHandle(int descriptor = -1)
    : Number(descriptor)
  {
  }
  ~FileHandle() { this->close(); }
  FileHandle(FileHandle&& other) noexcept
    : Number(std::exchange(other.Number, -1))
  {
  }
  FileHandle& operator=(FileHandle&& other) noexcept
  {
    std::swap(this->Number, other.Number);
    return *this;
  }

  int get() const { return this->Number; }
  /// @return whether all that was written is in the file; errno says why not
  bool close();

private:
  int Number;
};

/// @throws ReadError if it cannot be opened, with why
VTKINKIOCORE_EXPORT FileHandle openToRead(const std::filesystem::path& file);

/// A file without a name, which is gone when it is closed. Negative if that failed; errno says why.
VTKINKIOCORE_EXPORT FileHandle openUnnamed(const std::filesystem::path& folder);

/// Writes all of data. @return false if that failed; errno says why
VTKINKIOCORE_EXPORT bool writeAll(int descriptor, std::span<const unsigned char> data);

/// Fills data from a position in a file on. @return the bytes read: fewer than asked for at the end of the
/// file, where errno is 0, and after an error, which errno tells
VTKINKIOCORE_EXPORT std::size_t readAt(int descriptor, std::uint64_t position, std::span<unsigned char> data);

/// Hands over all of a file, part by part. @return false if reading it failed; errno says why
VTKINKIOCORE_EXPORT bool readAll(int descriptor, const ByteSink& sink);

} // namespace ink::io
