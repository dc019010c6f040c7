// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Fields/Grid/GridGeometry.h"
#include "Fields/Vdb/VdbFile.h"
#include "Statistics/FiniteRange.h"

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <span>
#include <string>

namespace ink
{

/// A sparse grid of floats or doubles in memory: an OpenVDB tree and its transform. Copies share the tree,
/// which is immutable.
class VdbGrid
{
public:
  /// The tree, for sources that include OpenVDB.
  struct Tree;
  VdbGrid(VdbGridInfo info, std::unique_ptr<const Tree> tree);

  static constexpr std::uint64_t noLimit = std::numeric_limits<std::uint64_t>::max();

  /// The memory in bytes that a grid will take, from traversing its tree in the file, with the checks of
  /// read().
  /// @throws VdbError
  static std::uint64_t memoryOf(std::istream& in, const VdbGridInfo& grid);

  /// Reads one grid of a file, after validating everything that OpenVDB trusts.
  /// @param in the stream that `file` lists
  /// @param grid one of file.grids without a problem
  /// @param memory the tree's memory limit in bytes
  /// @throws VdbTooLarge if it takes more, VdbError if it cannot be read
  static VdbGrid read(
    std::istream& in, const VdbFile& file, const VdbGridInfo& grid, std::uint64_t memory = noLimit);

  const VdbGridInfo& info() const { return this->Info; }
  const Tree& tree() const { return *this->Content; }
  double background() const;
  /// The memory of the tree in bytes.
  std::uint64_t memory() const;
  /// The bounding box of active voxels and tiles; empty if there are none.
  VoxelBox activeBox() const;
  /// The range of the voxels' values, active or not, and the background.
  /// @param negate the values are multiplied by -1 first
  FiniteRange values(bool negate) const;
  /// The grid's domain if it has one, otherwise the largest possible box.
  VoxelBox domain() const;
  /// The geometry of a box of voxels, whose indices become GridGeometry's global indices.
  GridGeometry geometry(const VoxelBox& box) const;

  /// Copies the values in a box, i fastest, the background where the tree has no node. Real is the grid's own
  /// type: double if info().isDouble, otherwise float.
  /// @param negate multiply the values by -1
  /// @throws std::invalid_argument if `values` does not have the size of the box and the type of the grid
  /// @return false when `progress` asked to stop
  template <class Real>
  bool copyTo(const VoxelBox& box, bool negate, std::span<Real> values, const Progress& progress = {}) const;

private:
  static void freeTree(const Tree* tree);

  VdbGridInfo Info;
  std::shared_ptr<const Tree> Content;
};

} // namespace ink
