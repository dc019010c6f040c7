// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SampleVolume.h"

#include "Fields/Vdb/VdbFile.h"

#include <filesystem>

namespace ink::cli
{

/// Samples surfaces of a grid from its tree alone: no image is made, and memory goes with the tree.
/// @param voxels no more points than this are made of a surface
VolumeSampler makeVdbSampler(
  const std::filesystem::path& file, const VdbGridInfo& grid, std::uint64_t voxels);

} // namespace ink::cli
