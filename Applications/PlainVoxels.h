#pragma once

#include "Descriptor.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

class vtkMetaImageReader;
class vtkNrrdReader;

namespace ink::cli
{

/// Voxels that lie in a file much as they would in memory: x fastest, not compressed. So a part of them can
/// be read without the rest.
struct PlainVoxels
{
  std::filesystem::path file;
  std::uint64_t offset = 0; ///< bytes before the first voxel
  int dimensions[3] = { 0, 0, 0 };
  int type = 0; ///< as VTK_UNSIGNED_CHAR
  int components = 1;
  bool swapped = false; ///< the bytes of a value are in the other order than this machine's
  bool flipped = false; ///< the rows of a slice come from the last to the first

  std::uint64_t valueSize() const;
  std::uint64_t sliceValues() const;
  /// All of it.
  std::uint64_t fileBytes() const;
};

/// Where the voxels of a NRRD or MetaImage volume lie; nothing if they are compressed, text, or in several
/// files. \param reader has read the header \throw Failure if the file is too short
std::optional<PlainVoxels> findNrrdVoxels(const std::filesystem::path& file, vtkNrrdReader* reader);
std::optional<PlainVoxels> findMetaImageVoxels(const std::filesystem::path& file, vtkMetaImageReader* reader);

/// Reads slices of plain voxels.
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
  void readBytes(std::uint64_t position, std::span<unsigned char> bytes);
  void finishSlice(unsigned char* slice) const;

  PlainVoxels Voxels;
  Descriptor File;
};

} // namespace ink::cli
