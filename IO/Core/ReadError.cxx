// SPDX-License-Identifier: BSD-3-Clause
#include "ReadError.h"

#include "vtksys/SystemTools.hxx"

#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

namespace ink::io
{

void failToRead(const fs::path& file, const std::string& reason)
{
  throw ReadError("cannot read '" + file.string() + "': " + reason);
}

void advance(const Progress& progress, double done)
{
  if (progress && !progress(done))
  {
    throw ReadAborted();
  }
}

std::string contentsOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(fs::file_size(file)), '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
  {
    failToRead(file, "it was cut short while it was read");
  }
  return bytes;
}

void checkExists(const fs::path& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status))
  {
    failToRead(
      file, error && error != std::errc::no_such_file_or_directory ? error.message() : "no such file");
  }
  if (fs::is_directory(status))
  {
    return;
  }
  if (!fs::is_regular_file(status))
  {
    failToRead(file, "it is neither a regular file nor a directory");
  }
  if (!std::ifstream(file).is_open())
  {
    failToRead(file, "permission denied");
  }
  if (fs::file_size(file) == 0)
  {
    failToRead(file, "the file is empty");
  }
}

std::string suffixOf(const fs::path& file)
{
  const fs::path lower(vtksys::SystemTools::LowerCase(file.filename().string()));
  const std::string last = lower.extension().string();
  return last == ".gz" ? lower.stem().extension().string() + last : last;
}

} // namespace ink::io
