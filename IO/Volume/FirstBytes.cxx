// SPDX-License-Identifier: BSD-3-Clause
#include "FirstBytes.h"

#include "Inflater.h"

#include <fstream>
#include <ios>

namespace ink::io
{

FirstBytes::FirstBytes(const std::filesystem::path& file, std::size_t count)
{
  std::ifstream stream(file, std::ios::binary);
  const auto read = [&](std::size_t most)
  {
    this->bytes.resize(most);
    stream.clear();
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(this->bytes.data()), static_cast<std::streamsize>(most));
    this->bytes.resize(static_cast<std::size_t>(stream.gcount()));
  };
  read(2);
  this->compressed = this->bytes == std::vector<unsigned char>{ 0x1f, 0x8b };
  if (this->compressed)
  {
    this->bytes.resize(count);
    this->bytes.resize(Inflater(file, 0).read(this->bytes));
  }
  else
  {
    read(count);
  }
}

} // namespace ink::io
