// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Vdb/VdbBytes.h"

namespace ink
{

VdbBytes::VdbBytes(std::istream& in)
  : In(in)
{
  in.clear();
  in.seekg(0, std::ios::end);
  const std::streamoff end = in.tellg();
  in.seekg(0, std::ios::beg);
  if (!in || end < 0)
  {
    throw VdbError("it cannot be read at will, as a regular file can");
  }
  this->Size = static_cast<std::uint64_t>(end);
}

void VdbBytes::require(std::uint64_t count, const char* what) const
{
  if (count > this->remaining())
  {
    throw VdbError("it ends after " + std::to_string(this->Size) + " bytes, within " + what);
  }
}

void VdbBytes::seek(std::uint64_t position, const char* what)
{
  if (position > this->Size)
  {
    throw VdbError("it has " + std::to_string(this->Size) + " bytes, but says that " + what +
      " starts after byte " + std::to_string(position));
  }
  this->In.clear();
  this->In.seekg(static_cast<std::streamoff>(position));
  this->Position = position;
}

void VdbBytes::skip(std::uint64_t count, const char* what)
{
  this->require(count, what);
  // Seeking discards the stream's buffer, so reading is faster for short distances.
  constexpr std::uint64_t shortStep = 1 << 14;
  if (count > shortStep)
  {
    this->seek(this->Position + count, what);
    return;
  }
  this->In.ignore(static_cast<std::streamsize>(count));
  this->Position += count;
}

void VdbBytes::read(void* to, std::uint64_t count, const char* what)
{
  this->require(count, what);
  if (!this->In.read(static_cast<char*>(to), static_cast<std::streamsize>(count)))
  {
    throw VdbError(std::string("it cannot be read on, within ") + what);
  }
  this->Position += count;
}

std::string VdbBytes::text(const char* what)
{
  const auto size = this->get<std::uint32_t>(what);
  this->require(size, what);
  std::string text(size, ' ');
  this->read(text.data(), size, what);
  return text;
}

} // namespace ink
