// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CheckedXmlReader.h"

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

  /// What VTK's reader says about its output.
  vtkInformation* information() { return this->Reader->GetOutputInformation(0); }

  /// Of the point scalars that the file announces; 0 if it announces none.
  std::uint64_t memorySize();

  /// Reads a part of the image, with the first component of its scalars alone.
  /// @param notes what was not used as it is, is added
  /// @return how many components the scalars have in the file
  /// @throws ReadError, ReadAborted
  int read(
    const int extent[6], vtkImageData* image, std::vector<std::string>& notes, const Progress& progress);

private:
  std::filesystem::path File;
  vtkNew<CheckedXmlReader<vtkXMLImageDataReader>> Reader;
};

} // namespace ink::io
