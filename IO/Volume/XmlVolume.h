// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CheckedXmlReader.h"

#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkXMLImageDataReader.h"

#include "Core/Progress.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ink::io
{

/// The image of a VTK XML file.
class XmlVolume
{
public:
  /// Reads the file's tags. @throws ReadError
  explicit XmlVolume(const std::filesystem::path& file);

  static constexpr const char* format = "VTK XML image (.vti)";

  /// What VTK's reader says about its output: of an image that has values in its cells alone, those of the
  /// points that its voxels become, in the cells' centers.
  vtkInformation* information() { return this->Announced; }

  /// Of the scalars that the file announces; 0 if it announces none.
  std::uint64_t memorySize();

  /// Reads a part of the image, with the first component of its scalars alone.
  /// @param notes what was not used as it is, is added
  /// @return how many components the scalars have in the file
  /// @throws ReadError, ReadAborted
  int read(
    const int extent[6], vtkImageData* image, std::vector<std::string>& notes, const Progress& progress);

private:
  std::filesystem::path File;
  bool OfCells = false;
  vtkNew<vtkInformation> Announced;
  vtkNew<CheckedXmlReader<vtkXMLImageDataReader>> Reader;
};

} // namespace ink::io
