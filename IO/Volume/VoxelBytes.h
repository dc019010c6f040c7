// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace ink::io
{

struct RawVolume;

/// The bytes of a file's voxels as they would be in one plain block, however the file stores them.
class VoxelBytes
{
public:
  virtual ~VoxelBytes() = default;

  /// Fills bytes from a position on. Unless the voxels are stored plain, positions may only grow.
  /// @throws ReadError if the file does not hold them.
  virtual void read(std::uint64_t position, std::span<unsigned char> bytes) = 0;

  /// @throws ReadError if a file cannot be opened.
  static std::unique_ptr<VoxelBytes> open(const RawVolume& voxels);

protected:
  VoxelBytes() = default;
  VoxelBytes(const VoxelBytes&) = delete;
  VoxelBytes& operator=(const VoxelBytes&) = delete;
};

} // namespace ink::io
