// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileHandle.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace ink::cli
{

/// Points with arrays that come in parts and may be more than memory should hold: those beyond a limit go to
/// a temporary file, which has no name and so is gone with this object, however the program ends.
class PointStore
{
public:
  /// What there is for each point.
  struct Array
  {
    std::string name;
    int type; ///< as VTK_FLOAT
    int components;

    std::size_t tupleSize() const;
    bool isNormals() const { return this->name == "Normals" && this->components == 3; }
    bool operator==(const Array&) const = default;
  };

  /// Up to blockSize neighboring points.
  struct Block
  {
    std::size_t count;
    /// The values of the wanted arrays, one after the other.
    std::vector<const unsigned char*> values;
  };
  static constexpr std::size_t blockSize = 1 << 16;

  /// @param memory bytes that may be kept in memory
  /// @param folder where there is room for the rest
  PointStore(std::uint64_t memory, std::filesystem::path folder);

  /// Adds points of a surface. All have to have the same arrays, which have names and hold numbers, and are
  /// taken to have the same field data.
  /// @throws Failure if the temporary file cannot be written.
  void add(int surface, vtkPolyData* points);

  std::uint64_t size() const { return this->Size; }
  /// The first is that of the coordinates.
  const std::vector<Array>& arrays() const { return this->Arrays; }

  /// Hands over all points in order: those of the first surface as they were added, then those of the next.
  /// @param wanted indices of arrays, those that the blocks are to have
  /// @throws Failure if the temporary file cannot be read.
  void forEachBlock(std::span<const std::size_t> wanted, const std::function<void(const Block&)>& use) const;

  /// All points with their arrays and field data. @throws Failure as forEachBlock
  vtkSmartPointer<vtkPolyData> take() const;

private:
  struct Part
  {
    int surface;
    std::uint64_t count;
    vtkSmartPointer<vtkPolyData> points; ///< null if they are in the file
    std::uint64_t position;              ///< in the file: array by array from here on
  };

  void writePart(vtkPolyData* points);
  void useBlocks(const Part& part, std::span<const std::size_t> wanted,
    const std::function<void(const Block&)>& use) const;

  std::uint64_t Memory;
  std::filesystem::path Folder;
  std::vector<Array> Arrays;
  std::vector<Part> Parts;
  vtkSmartPointer<vtkFieldData> Field;
  std::uint64_t Size = 0;
  std::uint64_t Kept = 0;
  io::FileHandle File;
  std::uint64_t FileSize = 0;
};

} // namespace ink::cli
