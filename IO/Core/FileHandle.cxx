// SPDX-License-Identifier: BSD-3-Clause
#include "FileHandle.h"

#include "ReadError.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace ink::io
{

bool FileHandle::close()
{
  const int descriptor = std::exchange(this->Number, -1);
  return descriptor < 0 || ::close(descriptor) == 0;
}

FileHandle openToRead(const std::filesystem::path& file)
{
  FileHandle handle(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (handle.get() < 0)
  {
    failToRead(file, std::strerror(errno));
  }
  return handle;
}

FileHandle openUnnamed(const std::filesystem::path& folder)
{
  FileHandle file(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
  if (file.get() < 0)
  {
    // Not every file system can do that.
    std::string name = (folder / "ink-XXXXXX").string();
    file = FileHandle(mkostemp(name.data(), O_CLOEXEC));
    if (file.get() >= 0)
    {
      ::unlink(name.c_str());
    }
  }
  return file;
}

bool writeAll(int descriptor, std::span<const unsigned char> data)
{
  while (!data.empty())
  {
    const ssize_t count = ::write(descriptor, data.data(), data.size());
    if (count < 0 && errno != EINTR)
    {
      return false;
    }
    data = data.subspan(static_cast<std::size_t>(count < 0 ? 0 : count));
  }
  return true;
}

std::size_t readAt(int descriptor, std::uint64_t position, std::span<unsigned char> data)
{
  std::size_t done = 0;
  errno = 0;
  while (done < data.size())
  {
    const ssize_t count =
      ::pread(descriptor, data.data() + done, data.size() - done, static_cast<off_t>(position + done));
    if (count == 0)
    {
      errno = 0; // also after an interrupted call
      break;
    }
    if (count < 0 && errno != EINTR)
    {
      break;
    }
    done += static_cast<std::size_t>(count < 0 ? 0 : count);
  }
  return done;
}

bool readAll(int descriptor, const ByteSink& sink)
{
  std::array<unsigned char, 1 << 16> part;
  std::uint64_t position = 0;
  while (true)
  {
    const std::size_t count = readAt(descriptor, position, part);
    const bool isLast = count < part.size();
    if (isLast && errno != 0)
    {
      return false;
    }
    if (count > 0)
    {
      sink(std::span(part).first(count));
    }
    if (isLast)
    {
      return true;
    }
    position += count;
  }
}

} // namespace ink::io
