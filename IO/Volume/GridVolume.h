// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VolumeHeader.h"

#include "vtkSmartPointer.h"

#include "Core/Progress.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkImageData;

namespace ink::io
{

/// A rectilinear or structured grid, which becomes an image (InkImageOfGrid.h).
class GridVolume
{
public:
  /// That of a VTK XML file (.vtr, .vts), of which the tags are read. @throws ReadError
  explicit GridVolume(const std::filesystem::path& file);
  /// One whose header has coordinates.
  explicit GridVolume(const VolumeHeader& header);

  const std::string& format() const { return this->Format; }

  /// Reads all of it, of its values the first component alone.
  /// @param notes what was not used as it is, is added
  /// @return how many components the values have in the file
  /// @throws ReadError, ReadAborted
  int read(vtkImageData* image, std::vector<std::string>& notes, const Progress& progress) const;

private:
  /// A grid, and its values, of points or cells.
  struct Grid
  {
    vtkSmartPointer<vtkDataSet> data;
    vtkSmartPointer<vtkDataArray> values;
    int components; ///< that values have in the file
  };
  template <class Reader>
  void open();

  std::filesystem::path File;
  std::string Format;
  std::function<Grid(std::vector<std::string>& notes, const Progress& progress)> Read;
};

} // namespace ink::io
