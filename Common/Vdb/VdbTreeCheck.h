#pragma once

#include "Vdb/VdbBytes.h"

#include <cstdint>

/// Internal to Common/Vdb.
namespace ink
{

/// How the values of a tree are stored.
struct VdbValueFormat
{
  int size = 4;                  ///< bytes of a value in memory
  bool half = false;             ///< voxels and tiles of inner nodes are stored with 16 bits
  std::uint32_t compression = 0; ///< OpenVDB's flags
};

/// What a tree consists of.
struct VdbTreeParts
{
  std::uint64_t upper = 0;  ///< inner nodes of 4096^3 voxels
  std::uint64_t lower = 0;  ///< inner nodes of 128^3 voxels
  std::uint64_t leaves = 0; ///< nodes of 8^3 voxels

  /// What it takes in memory.
  std::uint64_t bytes(int valueSize) const;
};

/// Goes through a tree of OpenVDB's usual shape (5, 4, 3) from the reader's position to the tree's end, and
/// checks all that OpenVDB itself takes on trust: that there are as many bytes as the counts, masks and chunk
/// sizes say, that nodes lie where nodes can lie and none twice, that no slot is both a tile and a node, and
/// that compressed chunks are as long as their own headers say. Of inner nodes, whose values OpenVDB must not
/// fail to uncompress, they are uncompressed; those of leaves are not.
/// \throws VdbError
VdbTreeParts checkVdbTree(VdbBytes& bytes, const VdbValueFormat& format);

} // namespace ink
