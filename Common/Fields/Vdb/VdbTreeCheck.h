// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Vdb/VdbBytes.h"

#include <cstdint>

/// Internal to Common/Fields/Vdb.
namespace ink
{

/// The storage format of a tree's values.
struct VdbValueFormat
{
  int size = 4;                  ///< bytes of a value in memory
  bool half = false;             ///< voxels and tiles of inner nodes are stored with 16 bits
  std::uint32_t compression = 0; ///< OpenVDB's flags
};

/// The numbers of nodes in a tree.
struct VdbTreeParts
{
  std::uint64_t upper = 0;  ///< inner nodes of 4096^3 voxels
  std::uint64_t lower = 0;  ///< inner nodes of 128^3 voxels
  std::uint64_t leaves = 0; ///< nodes of 8^3 voxels

  /// Its memory in bytes.
  std::uint64_t bytes(int valueSize) const;
};

/// Traverses a tree of OpenVDB's usual shape (5, 4, 3) from the reader's position to the tree's end, and
/// validates everything that OpenVDB trusts: that the bytes claimed by counts, masks and chunk sizes exist,
/// that node origins are valid and distinct, that no slot is both a tile and a node, and that compressed
/// chunks have the length in their headers. Chunks of inner nodes, which OpenVDB must not fail to decompress,
/// are decompressed; those of leaves are not.
/// @throws VdbError
VdbTreeParts checkVdbTree(VdbBytes& bytes, const VdbValueFormat& format);

} // namespace ink
