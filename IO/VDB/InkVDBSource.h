// SPDX-License-Identifier: BSD-3-Clause
// What the readers of .vdb files share: a file's list of grids and the grid that was read last.
#ifndef InkVDBSource_h
#define InkVDBSource_h

#include "Vdb/VdbGrid.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

/// Keeps what it read until the file or the choice changes.
class InkVDBSource
{
public:
  /// The list of the file's grids.
  /// @throws ink::VdbError with the file's name in its message
  const ink::VdbFile& List(const std::string& fileName);

  /// The list that was read last, empty if that failed.
  const ink::VdbFile& Listed() const { return this->File; }

  /// The grid of that name, or the first that can be read.
  /// @param mebibytes that it may take in memory; 0: any
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

/// Bytes as people read them: "12.3 MiB".
std::string InkMebibytes(double bytes);

#endif
