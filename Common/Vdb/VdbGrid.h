#pragma once

#include "Fields/GridGeometry.h"
#include "Parallel/ParallelFor.h"
#include "Statistics/ValueSummary.h"
#include "Vdb/VdbFile.h"

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <span>
#include <string>

namespace ink
{

/// A sparse grid of floats or doubles in memory, OpenVDB's tree and where it lies in the world. Copies share
/// the tree, which nothing changes any more.
class VdbGrid
{
public:
  /// The tree, for the sources that know OpenVDB.
  struct Tree;
  VdbGrid(VdbGridInfo info, std::unique_ptr<const Tree> tree);

  static constexpr std::uint64_t noLimit = std::numeric_limits<std::uint64_t>::max();

  /// The bytes that a grid will take, from a walk through its tree in the file, which is checked as read()
  /// does it.
  /// \throws VdbError
  static std::uint64_t memoryOf(std::istream& in, const VdbGridInfo& grid);

  /// Reads one grid of a file, after checking what OpenVDB takes on trust.
  /// \param in     what `file` is the list of
  /// \param grid   one of file.grids that has no problem
  /// \param memory the most bytes that the tree may take
  /// \throws VdbTooLarge if it takes more, VdbError if it cannot be read
  static VdbGrid read(
    std::istream& in, const VdbFile& file, const VdbGridInfo& grid, std::uint64_t memory = noLimit);

  const VdbGridInfo& info() const { return this->Info; }
  const Tree& tree() const { return *this->Content; }
  double background() const;
  /// The bytes that the tree takes.
  std::uint64_t memory() const;
  /// The smallest box around the active voxels and tiles; empty when there are none.
  VoxelBox activeBox() const;
  /// What values the voxels have, active or not, and the background.
  /// \param negate after being multiplied by -1
  ValueSummary values(bool negate) const;
  /// What belongs to the grid: its domain where it has one, otherwise all voxels there can be.
  VoxelBox domain() const;
  /// Where the voxels of a box lie. Voxels keep their indices, as GridGeometry's global ones.
  GridGeometry geometry(const VoxelBox& box) const;

  /// The values in a box, with i running fastest, the background where the tree holds nothing. Real is the
  /// grid's own type: double where info().isDouble, otherwise float.
  /// \param negate multiply them by -1
  /// \throws std::invalid_argument if `values` has another size than the box or another type than the grid
  /// \returns false when `progress` asked to stop
  template <class Real>
  bool copyTo(const VoxelBox& box, bool negate, std::span<Real> values, const Progress& progress = {}) const;

private:
  static void freeTree(const Tree* tree);

  VdbGridInfo Info;
  std::shared_ptr<const Tree> Content;
};

} // namespace ink
