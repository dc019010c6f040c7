// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ScaledValues.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ink::io
{

/// Where one picture lies, and what its values mean.
struct DicomFrame
{
  ValueScale scale;
  double spacing[2] = { 1.0, 1.0 };     ///< between columns, between rows
  double thickness = 1.0;               ///< from slice to slice, if the file says so
  double distance = 0.0;                ///< between the middles of slices; 0: the file does not say
  double row[3] = { 1.0, 0.0, 0.0 };    ///< the direction along a row
  double column[3] = { 0.0, 1.0, 0.0 }; ///< and along a column, downwards
  double position[3] = { 0.0, 0.0, 0.0 };
  bool hasPosition = false;
};

/// What one DICOM file says of the pictures in it.
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
  int bits = 0;       ///< that a value takes
  int storedBits = 0; ///< that are the value's own; 0: the file does not say
  bool isSigned = false;
  bool bigEndian = false;
  double number = 0.0;
  DicomFrame shared;                 ///< of all its pictures
  std::vector<DicomFrame> ownFrames; ///< of each, or some, where the file says them apart; else none
  std::vector<double> offsets;       ///< of each picture of a dose from the first, at right angles to them
  std::uint64_t pixelOffset = 0;
  std::uint64_t pixelBytes = 0; ///< 0: there are no pixels
  std::string problem;          ///< why its elements could not be told apart to the end; empty if they could

  /// That a value, and a picture, take when they are not compressed.
  int valueBytes() const;
  std::uint64_t frameBytes() const;
  /// Whether the pixels are stored otherwise than one after the other, by its transfer syntax.
  bool isCompressed() const;

  /// Reads all but the pixels. Files of old that begin with their elements, without preamble and mark, are
  /// read, too. Of sequences, the functional groups of multi-frame files (DICOM PS3.3 C.7.6.16) that say
  /// where frames lie are read, and no others. @return nothing if it is no DICOM file
  static std::optional<DicomFile> read(const std::filesystem::path& file);
};

} // namespace ink::io
