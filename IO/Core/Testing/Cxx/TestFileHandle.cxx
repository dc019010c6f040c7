// SPDX-License-Identifier: BSD-3-Clause
#include "FileHandle.h"

#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace
{

using ink::io::FileHandle;
using Bytes = std::vector<unsigned char>;

FileHandle fileOf(const Bytes& bytes)
{
  FileHandle file = ink::io::openUnnamed(std::filesystem::temp_directory_path());
  EXPECT_TRUE(ink::io::writeAll(file.get(), bytes));
  return file;
}

/// What readAll hands over. @param read whether it could be read
Bytes allOf(int descriptor, bool& read)
{
  Bytes all;
  read = ink::io::readAll(descriptor,
    [&all](std::span<const unsigned char> part)
    {
      EXPECT_FALSE(part.empty());
      all.insert(all.end(), part.begin(), part.end());
      errno = EIO; // what is done with a part may fail and go on
    });
  return all;
}

} // namespace

TEST(FileHandle, AllOfAFileIsRead)
{
  for (const std::size_t size : { 0, 1, 65535, 65536, 65537, 200000 })
  {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      bytes[i] = static_cast<unsigned char>(i * 31 / 7);
    }
    bool read = false;
    EXPECT_EQ(allOf(fileOf(bytes).get(), read), bytes);
    EXPECT_TRUE(read) << size;
  }
}

TEST(FileHandle, AnErrorIsNoEnd)
{
  // There is no memory of this program at 0, which is an error of input as a failing disk has it.
  const FileHandle memory = ink::io::openToRead("/proc/self/mem");
  bool read = true;
  EXPECT_TRUE(allOf(memory.get(), read).empty());
  EXPECT_FALSE(read);
  EXPECT_EQ(errno, EIO);
  EXPECT_TRUE(allOf(-1, read).empty());
  EXPECT_FALSE(read);
  EXPECT_EQ(errno, EBADF);
}

TEST(FileHandle, ErrnoTellsTheEndOfAFile)
{
  const FileHandle file = fileOf({ 1, 2, 3 });
  std::array<unsigned char, 4> bytes{};
  errno = EIO;
  EXPECT_EQ(ink::io::readAt(file.get(), 1, bytes), 2u);
  EXPECT_EQ(errno, 0);
}
