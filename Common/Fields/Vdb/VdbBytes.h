// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Vdb/VdbError.h"

#include <cstdint>
#include <istream>
#include <string>
#include <type_traits>

/// Internal to Common/Fields/Vdb.
namespace ink
{

/// Bounds-checked reading of a .vdb file. All functions throw VdbError at the end of the file; `what` names
/// the part being read in its message.
class VdbBytes
{
public:
  /// @param in seekable; it need not be at its beginning
  explicit VdbBytes(std::istream& in);

  std::uint64_t size() const { return this->Size; }
  std::uint64_t position() const { return this->Position; }
  std::uint64_t remaining() const { return this->Size - this->Position; }
  /// For code that reads the stream directly; it must call seek() afterwards.
  std::istream& stream() { return this->In; }

  void seek(std::uint64_t position, const char* what);
  void skip(std::uint64_t count, const char* what);
  void read(void* to, std::uint64_t count, const char* what);

  template <class T>
  T get(const char* what)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    this->read(&value, sizeof value, what);
    return value;
  }

  /// Reads a string: a length of four bytes and that many characters.
  std::string text(const char* what);

private:
  void require(std::uint64_t count, const char* what) const;

  std::istream& In;
  std::uint64_t Size = 0;
  std::uint64_t Position = 0;
};

} // namespace ink
