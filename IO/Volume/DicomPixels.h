// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "DicomFile.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace ink::io
{

/// The compressed pixels of a DICOM file, picture by picture, through GDCM.
class DicomPixels
{
public:
  /// Finds the fragments of each picture. @throws ReadError if the file ends before them, or they cannot be
  /// told apart
  explicit DicomPixels(DicomFile file);
  explicit DicomPixels(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return this->File.path; }

  /// The values of a picture, row by row from the top, in the order of bytes of this machine.
  /// @param values room for DicomFile::frameBytes(). @throws ReadError
  void read(std::size_t frame, std::span<unsigned char> values) const;

private:
  struct Fragment
  {
    std::uint64_t position; ///< in the file
    std::uint32_t length;
  };

  DicomFile File;
  std::vector<std::vector<Fragment>> Frames;
};

} // namespace ink::io
