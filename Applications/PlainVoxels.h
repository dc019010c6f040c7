#pragma once

#include "VoxelBytes.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace ink::cli
{

enum class VoxelEncoding
{
  Plain,      ///< as in memory: a part can be read without the rest
  Compressed, ///< zlib or gzip
  Text
};

/// Voxels that lie in a file, or several, one after the other, x fastest.
struct PlainVoxels
{
  std::vector<std::filesystem::path> files; ///< one, or several with as many slices each, uncompressed
  std::uint64_t offset = 0;                 ///< bytes before the voxels in each file
  VoxelEncoding encoding = VoxelEncoding::Plain;
  std::uint64_t skipped = 0; ///< bytes that compressed data has before the voxels
  int dimensions[3] = { 0, 0, 0 };
  int type = 0; ///< as VTK_UNSIGNED_CHAR
  int components = 1;
  bool swapped = false; ///< the bytes of a value are in the other order than this machine's

  std::uint64_t valueSize() const;
  std::uint64_t sliceValues() const;
  /// All of it, uncompressed.
  std::uint64_t fileBytes() const;

  /// Sets the order of bytes in a value.
  void setBigEndian(bool bigEndian);

  /// Check what a header says: that there are dimensions whose product is a number, and also that the files
  /// are long enough for all voxels. \throw Failure if not
  void checkDimensions(const std::filesystem::path& header) const;
  void check(const std::filesystem::path& header) const;
};

/// Reads slices of voxels; only forwards, unless they are stored plain.
class PlainVoxelReader
{
public:
  /// \throw Failure if the file cannot be opened.
  explicit PlainVoxelReader(PlainVoxels voxels);

  const PlainVoxels& voxels() const { return this->Voxels; }

  /// Reads the first component of slices from `first` on, as many as fill `values`.
  /// \throw Failure if they cannot be read.
  void read(int first, std::span<unsigned char> values);

private:
  PlainVoxels Voxels;
  std::unique_ptr<VoxelBytes> Bytes;
};

} // namespace ink::cli
