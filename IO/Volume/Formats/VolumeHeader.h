// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Orientation.h"
#include "RawVolume.h"
#include "ScaledValues.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace ink::io
{

/// What the header of a volume's file says, and where the voxels lie that it speaks of.
struct VolumeHeader
{
  RawVolume voxels;
  int components = 1; ///< that each voxel has; more than in `voxels` where each has a block of its own
  double spacing[3] = { 1, 1, 1 };
  double origin[3] = { 0, 0, 0 };
  std::optional<Orientation> orientation; ///< in place of `origin`
  /// Of a grid that is no image: its coordinates along x, y and z (rectilinear), or its points, x, y and z of
  /// each in turn (structured), in place of all of the above.
  std::vector<RawVolume> coordinates;
  std::vector<RawVolume> marks; ///< vtkGhostType of its points, or cells
  ValueScale scale;
  std::vector<ValueScale> sliceScales; ///< of each slice; none where they all have `scale`
  bool isScaled() const
  {
    return !this->sliceScales.empty() || (this->scale.slope != 0.0 && this->scale != ValueScale());
  }
  int valueType() const; ///< as VTK_SHORT, when they are scaled
  /// Scales the values of an image, some of the volume's, if they are to be.
  void scaleValues(vtkImageData* image) const;
  std::string format;             ///< in a few words
  std::vector<std::string> notes; ///< what of the file is not used as it is, each a sentence without its dot
};

/// The headers of formats whose voxels need no reader of VTK. VTK's readers of these formats fall over
/// headers that do not say what they expect: see Documentation/files.md. @throws ReadError if it is no such
/// file, or its header promises more than there is.
/// Of Gaussian's cubes.
VolumeHeader readCubeHeader(const std::filesystem::path& file);
VolumeHeader readDicomHeaders(const std::filesystem::path& path);
VolumeHeader readMghHeader(const std::filesystem::path& file);
VolumeHeader readMrcHeader(const std::filesystem::path& file);
/// Of a file, or of a pair, of which either is given.
VolumeHeader readNiftiHeader(const std::filesystem::path& file);
/// The file beside one that ends in .hdr or .img, or .gz after it, which makes a pair with it; none if there
/// is no such one.
std::optional<std::filesystem::path> findOtherOfPair(const std::filesystem::path& file);
VolumeHeader readNpyHeader(const std::filesystem::path& file);
VolumeHeader readNrrdHeader(const std::filesystem::path& file);
VolumeHeader readMetaImageHeader(const std::filesystem::path& file);
/// Of a file without a header, of voxels of a type of VTK's, x fastest; if it has not as many bytes, or,
/// compressed, fewer, it is refused.
VolumeHeader rawHeader(const std::filesystem::path& file, const int dimensions[3], int type, bool bigEndian);
/// Of one whose name says its dimensions, its type, and where that is so that it is big endian, as
/// skull_256x256x256_uint8.raw. Without a type it is that of one byte, or two, as many as there are.
VolumeHeader readNamedRawHeader(const std::filesystem::path& file);
/// Of VolVis' volumes.
VolumeHeader readSlcHeader(const std::filesystem::path& file);
/// Of the pages of a TIFF file, or of the TIFF files of a folder, each of which is a slice.
VolumeHeader readTiffHeader(const std::filesystem::path& path);
/// Whether most files of a folder are TIFF files by their names.
bool isFolderOfTiffs(const std::filesystem::path& folder);
/// Of structured points, or a rectilinear or structured grid, in a legacy VTK file.
VolumeHeader readLegacyHeader(const std::filesystem::path& file);

/// What is said of files whose values belong to cells.
inline constexpr const char* noteOfCells =
  "its values are those of its cells; each is taken as that of a voxel in the cell's middle";

/// What is said of files without any.
inline constexpr const char* lackOfValues = "it holds no values, neither at its points nor in its cells";

/// A distance between voxels as files give it: where there is none, 1.
double spacingOf(double given);

} // namespace ink::io
