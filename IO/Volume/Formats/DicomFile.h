// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ScaledValues.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace ink::io
{

/// What one DICOM file says of the picture in it.
struct DicomFile
{
  std::filesystem::path path;
  std::string series;
  std::string transferSyntax;
  int rows = 0;
  int columns = 0;
  int components = 1;
  bool separatePlanes = false; ///< each component has a picture of its own
  int frames = 1;
  int bits = 0; ///< that a value takes
  bool isSigned = false;
  bool bigEndian = false;
  ValueScale scale;
  double spacing[2] = { 1.0, 1.0 }; ///< between columns, between rows
  double thickness = 1.0;           ///< from slice to slice, if the file says so
  double distance = 0.0;            ///< between the middles of slices; 0: the file does not say
  double number = 0.0;
  double row[3] = { 1.0, 0.0, 0.0 };    ///< the direction along a row
  double column[3] = { 0.0, 1.0, 0.0 }; ///< and along a column, downwards
  double position[3] = { 0.0, 0.0, 0.0 };
  bool hasPosition = false;
  std::uint64_t pixelOffset = 0;
  std::uint64_t pixelBytes = 0; ///< 0: there are no pixels
  std::string problem;          ///< why its elements could not be told apart to the end; empty if they could

  /// Reads all but the pixels. Files of old that begin with their elements, without preamble and mark, are
  /// read, too. @return nothing if it is no DICOM file
  static std::optional<DicomFile> read(const std::filesystem::path& file);
};

} // namespace ink::io
