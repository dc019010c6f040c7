#pragma once

#include "Vdb/VdbError.h"

#include <cstdint>
#include <istream>
#include <string>
#include <type_traits>

/// Internal to Common/Vdb.
namespace ink
{

/// Reads the bytes of a .vdb file and never past their end. `what` names the part for the message of the
/// VdbError that every function throws where the bytes run out.
class VdbBytes
{
public:
  /// \param in seekable; it need not stand at its beginning
  explicit VdbBytes(std::istream& in);

  std::uint64_t size() const { return this->Size; }
  std::uint64_t position() const { return this->Position; }
  std::uint64_t remaining() const { return this->Size - this->Position; }
  /// For those who read by themselves; seek() thereafter.
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

  /// A length of four bytes and that many characters.
  std::string text(const char* what);

private:
  void require(std::uint64_t count, const char* what) const;

  std::istream& In;
  std::uint64_t Size = 0;
  std::uint64_t Position = 0;
};

} // namespace ink
