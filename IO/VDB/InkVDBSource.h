// SPDX-License-Identifier: BSD-3-Clause

// Shared by the readers of .vdb files: a file's list of grids and the grid that was read last.
#ifndef InkVDBSource_h
#define InkVDBSource_h

#include "Fields/Vdb/VdbGrid.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

/// Caches its results until the file or the selected grid changes.
class InkVDBSource
{
public:
  /// The list of the file's grids.
  /// @throws ink::VdbError with the file's name in its message
  const ink::VdbFile& List(const std::string& fileName);

  /// The last list; empty if reading it failed.
  const ink::VdbFile& Listed() const { return this->File; }

  /// The grid of that name, or the first that can be read.
  /// @param mebibytes the memory limit; 0: none
  /// @throws ink::VdbError with the file's name in its message
  const ink::VdbGrid& Read(const std::string& fileName, const std::string& gridName, int mebibytes);

private:
  std::ifstream Open(const std::string& fileName);

  std::string FileName;
  std::filesystem::file_time_type FileTime;
  ink::VdbFile File;
  std::string GridName;
  std::optional<ink::VdbGrid> Grid;
};

/// What a property of VTK's says, nothing where it is not set.
inline std::string InkTextOf(const char* characters)
{
  return characters ? characters : "";
}

/// Formats a number of bytes: "12.3 MiB".
std::string InkMebibytes(double bytes);

#endif
