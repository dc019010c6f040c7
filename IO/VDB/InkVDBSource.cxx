// SPDX-License-Identifier: BSD-3-Clause
#include "InkVDBSource.h"

#include <cmath>
#include <new>
#include <sstream>
#include <system_error>

namespace fs = std::filesystem;

namespace
{

constexpr std::uint64_t Mebibyte = 1 << 20;

[[noreturn]] void Fail(const std::string& fileName, const std::string& reason)
{
  throw ink::VdbError("Cannot read \"" + fileName + "\": " + reason);
}

} // namespace

std::ifstream InkVDBSource::Open(const std::string& fileName)
{
  if (fileName.empty())
  {
    throw ink::VdbError("No file was named: FileName is empty");
  }
  std::error_code error;
  if (!fs::is_regular_file(fileName, error))
  {
    Fail(fileName, fs::exists(fileName, error) ? "it is not a regular file" : "there is no such file");
  }
  std::ifstream in(fileName, std::ios::binary);
  if (!in)
  {
    Fail(fileName, "it cannot be opened");
  }
  return in;
}

const ink::VdbFile& InkVDBSource::List(const std::string& fileName)
{
  std::ifstream in = this->Open(fileName);
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(fileName, error);
  if (fileName == this->FileName && !error && time == this->FileTime)
  {
    return this->File;
  }
  this->FileName.clear();
  this->File = {};
  this->Grid.reset();
  try
  {
    this->File = ink::VdbFile::list(in);
  }
  catch (const ink::VdbError& problem)
  {
    Fail(fileName, problem.what());
  }
  this->FileName = fileName;
  this->FileTime = time;
  return this->File;
}

const ink::VdbGrid& InkVDBSource::Read(
  const std::string& fileName, const std::string& gridName, int mebibytes)
{
  const ink::VdbFile& file = this->List(fileName);
  try
  {
    const ink::VdbGridInfo& grid = file.find(gridName);
    if (!this->Grid || this->GridName != grid.name)
    {
      this->Grid.reset();
      std::ifstream in = this->Open(fileName);
      const std::uint64_t limit =
        mebibytes == 0 ? ink::VdbGrid::noLimit : static_cast<std::uint64_t>(mebibytes) * Mebibyte;
      this->Grid = ink::VdbGrid::read(in, file, grid, limit);
      this->GridName = grid.name;
    }
    return *this->Grid;
  }
  catch (const ink::VdbTooLarge& problem)
  {
    Fail(fileName, std::string(problem.what()) + " (MaximumMemory)");
  }
  catch (const ink::VdbError& problem)
  {
    Fail(fileName, problem.what());
  }
  catch (const std::bad_alloc&)
  {
    Fail(fileName, "there is not enough memory");
  }
}

std::string InkMebibytes(double bytes)
{
  std::ostringstream text;
  text.precision(bytes < 1e4 * Mebibyte ? 4 : 6);
  text << std::ceil(10.0 * bytes / Mebibyte) / 10.0 << " MiB";
  return text.str();
}
