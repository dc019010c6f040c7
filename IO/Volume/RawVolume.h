// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOVolumeModule.h" // for the export macro

#include "VoxelBytes.h"

#include "Core/Progress.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace ink::io
{

enum class VoxelEncoding
{
  Plain,      ///< as in memory: a part can be read without the rest
  Compressed, ///< zlib or gzip
  Text,
  Runs,  ///< run lengths of bytes, slice by slice, as VolVis has them
  Pages, ///< of TIFF files, as libtiff reads them
  Frames ///< of DICOM files, as GDCM decompresses them
};

/// Voxels that lie in a file, or several, one after the other, x fastest.
struct VTKINKIOVOLUME_EXPORT RawVolume
{
  std::vector<std::filesystem::path> files; ///< one, or several with as many slices each, uncompressed; of
                                            ///< pages and frames one for each, the same again or others
  std::uint64_t offset = 0;                 ///< bytes before the voxels in each file
  std::vector<std::uint64_t> offsets; ///< the same of each file, where they differ; of pages, where their
                                      ///< directories are; of frames, their numbers in the file
  VoxelEncoding encoding = VoxelEncoding::Plain;
  std::uint64_t skipped = 0; ///< bytes that compressed data has before the voxels
  int dimensions[3] = { 0, 0, 0 };
  int type = 0; ///< as VTK_UNSIGNED_CHAR
  int components = 1;
  bool halves = false;  ///< floats are stored as numbers of IEEE 754 of 2 bytes
  bool swapped = false; ///< the bytes of a value are in the other order than this machine's

  std::uint64_t offsetIn(std::size_t file) const;
  std::uint64_t valueSize() const; ///< in memory
  std::uint64_t storedSize() const;
  std::uint64_t sliceValues() const;
  /// All of it, uncompressed.
  std::uint64_t fileBytes() const;

  /// Sets the order of bytes in a value.
  void setBigEndian(bool bigEndian);

  /// Check what a header says: that there are dimensions whose product is a number, and also that the files
  /// are long enough for all voxels. @throws ReadError if not
  void checkDimensions(const std::filesystem::path& header) const;
  void check(const std::filesystem::path& header) const;
};

/// Reads slices of voxels; only forwards, unless they are stored plain.
class VTKINKIOVOLUME_EXPORT RawVolumeReader
{
public:
  /// @throws ReadError if the file cannot be opened.
  explicit RawVolumeReader(RawVolume voxels);

  /// Reads the first component of a part, from which voxel to which along x, y and z, as update extents are.
  /// @param values room for it, x fastest
  /// @throws ReadError if it cannot be read, ReadAborted
  void read(const int extent[6], std::span<unsigned char> values, const Progress& progress);

private:
  void readRows(std::uint64_t first, std::span<unsigned char> values);
  void readHalves(std::uint64_t position, std::span<unsigned char> values);

  RawVolume Voxels;
  std::unique_ptr<VoxelBytes> Bytes;
};

} // namespace ink::io
