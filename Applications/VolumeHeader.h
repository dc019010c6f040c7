#pragma once

#include "Input.h"
#include "Orientation.h"
#include "PlainVoxels.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ink::cli
{

/// What the header of a volume's file says, and where the voxels lie that it speaks of.
struct VolumeHeader
{
  PlainVoxels voxels;
  int components = 1; ///< that each voxel has; more than in `voxels` where each has a block of its own
  double spacing[3] = { 1, 1, 1 };
  double origin[3] = { 0, 0, 0 };
  std::optional<Orientation> orientation; ///< in place of `origin`
  /// value = slope * stored value + intercept
  double slope = 1.0;
  double intercept = 0.0;
  std::vector<std::string> notes; ///< as Input::notes
};

/// The headers of formats whose voxels need no reader of VTK. VTK's readers of these formats fall over
/// headers that do not say what they expect: see Documentation/files.md. \throw Failure if it is no such
/// file, or its header promises more than there is.
VolumeHeader readNiftiHeader(const std::filesystem::path& file);
VolumeHeader readNrrdHeader(const std::filesystem::path& file);
VolumeHeader readMetaImageHeader(const std::filesystem::path& file);
/// Of structured points in a legacy VTK file.
VolumeHeader readLegacyHeader(const std::filesystem::path& file);

/// Reads the volume that a header speaks of; if it is large and stored plain, its voxels stay in the file.
/// \throw Failure
Input readVoxels(const std::filesystem::path& file, const VolumeHeader& header, const std::string& format,
  const Memory& memory, Progress& progress);

/// A distance between voxels as files give it: where there is none, 1.
double spacingOf(double given);

} // namespace ink::cli
