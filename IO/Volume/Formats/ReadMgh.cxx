// SPDX-License-Identifier: BSD-3-Clause
// FreeSurfer's volumes: B. Fischl, FreeSurfer, NeuroImage 62 (2012); the header is that of its file format
// page.
#include "VolumeHeader.h"

#include "FirstBytes.h"
#include "OrderedBytes.h"
#include "ReadError.h"

#include "vtkType.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// Where the header has what is used of it, all with the most significant byte first, and where it ends.
namespace mgh
{
constexpr std::size_t version = 0;
constexpr std::size_t size = 4;
constexpr std::size_t frames = 16;
constexpr std::size_t type = 20;
constexpr std::size_t hasGeometry = 28;
constexpr std::size_t spacing = 30;
constexpr std::size_t directions = 42;
constexpr std::size_t center = 78;
constexpr std::size_t end = 284;
} // namespace mgh

template <class T>
T mghValueAt(const std::vector<unsigned char>& bytes, std::size_t position)
{
  return valueFrom<T>(bytes.data() + position, std::endian::native == std::endian::little);
}

/// @throws ReadError for what is no number of a voxel
int typeOf(std::int32_t type, const fs::path& file)
{
  switch (type)
  {
    case 0:
      return VTK_UNSIGNED_CHAR;
    case 1:
      return VTK_INT;
    case 3:
      return VTK_FLOAT;
    case 4:
      return VTK_SHORT;
    case 10:
      return VTK_UNSIGNED_SHORT;
    default:
      failToRead(file,
        "its header says type " + std::to_string(type) +
          "; expected 0 (uint8), 1 (int32), 3 (float32), 4 (int16) or 10 (uint16)");
  }
}

/// Spacing, directions and the first voxel's position, from that of the middle; FreeSurfer's axes point to
/// the right, the front and the top.
void place(const std::vector<unsigned char>& bytes, VolumeHeader& header)
{
  constexpr double sign[3] = { -1, -1, 1 };
  // What FreeSurfer takes where a file says nothing: slices from the front to the back.
  double steps[9] = { -1, 0, 0, 0, 0, -1, 0, 1, 0 };
  double origin[3] = { 0, 0, 0 };
  if (mghValueAt<std::int16_t>(bytes, mgh::hasGeometry) > 0)
  {
    for (std::size_t i = 0; i < 9; ++i)
    {
      steps[i] = mghValueAt<float>(bytes, mgh::directions + i * sizeof(float));
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      header.spacing[i] = spacingOf(mghValueAt<float>(bytes, mgh::spacing + i * sizeof(float)));
      origin[i] = mghValueAt<float>(bytes, mgh::center + i * sizeof(float));
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      origin[axis] -= 0.5 * header.voxels.dimensions[i] * header.spacing[i] * steps[3 * i + axis];
    }
  }
  header.orientation.emplace(steps, origin, sign);
}

} // namespace

VolumeHeader readMghHeader(const fs::path& file)
{
  const auto [compressed, bytes] = FirstBytes(file, mgh::end);
  if (bytes.size() < mgh::end || mghValueAt<std::int32_t>(bytes, mgh::version) != 1)
  {
    failToRead(file, "it is no volume of FreeSurfer, whose header has 284 bytes and begins with version 1");
  }
  VolumeHeader header;
  header.format = "FreeSurfer volume";
  RawVolume& voxels = header.voxels;
  voxels.files = { file };
  voxels.type = typeOf(mghValueAt<std::int32_t>(bytes, mgh::type), file);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    voxels.dimensions[axis] = mghValueAt<std::int32_t>(bytes, mgh::size + axis * sizeof(std::int32_t));
  }
  voxels.setBigEndian(true);
  (compressed ? voxels.skipped : voxels.offset) = mgh::end;
  voxels.encoding = compressed ? VoxelEncoding::Compressed : VoxelEncoding::Plain;
  voxels.check(file);
  const auto frames = mghValueAt<std::int32_t>(bytes, mgh::frames);
  if (frames > 1)
  {
    header.notes.push_back("it has " + std::to_string(frames) + " frames; the first is used");
  }
  place(bytes, header);
  return header;
}

} // namespace ink::io
