// SPDX-License-Identifier: BSD-3-Clause
// Each block of cells is copied to a small dense grid with the voxels that its cells' points and normals
// depend on, which is then sampled like any dense grid. These grids keep the voxels' global indices, so
// points are bitwise equal to those of one dense grid.

#include "IsoSurface/Vdb/VdbSamples.h"

#include "Core/ParallelChunks.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Vdb/VdbTree.h"
#include "IsoSurface/IsoSurfaceSamples.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

/// The voxels of a block, one layer before it, and two after it: the far corners of its last cells and one
/// more.
constexpr int Before = 1;
constexpr int Behind = 2;

template <class TreeType, class Real>
class VdbCellPlacement
{
public:
  using T = typename TreeType::ValueType;

  VdbCellPlacement(
    const VdbGrid& grid, const TreeType& tree, double isoValue, const SampleOptions& options, bool negate)
    : Grid(grid)
    , Lookup(tree)
    , Domain(grid.domain())
    , IsoValue(isoValue)
    , Options(options)
    , Negate(negate)
  {
    this->Cells.slabs.resize(1);
  }

  void place(const VdbActiveCells::Block& block, Real* points, float* normals)
  {
    const VoxelBox box{ glm::max(block.first - Before, this->Domain.first),
      glm::min(block.first + leafSize - 1 + Behind, this->Domain.last) };
    this->gather(block.first, box);
    this->takeCells(block, block.first - box.first);
    const GridField<T> field(this->Grid.geometry(box), std::span<const T>(this->Values));
    const std::size_t size = 3 * this->Cells.count;
    placeIsoSurfaceSamples(field, this->IsoValue, this->Options, this->Cells, std::span<Real>(points, size),
      std::span<float>(normals, normals ? size : 0));
  }

private:
  /// Copies the box from the blocks around and including the given one.
  void gather(const glm::ivec3& block, const VoxelBox& box)
  {
    const glm::ivec3 size(box.size());
    this->Values.resize(static_cast<std::size_t>(size.x) * size.y * size.z);
    for (int n = 0; n < 27; ++n)
    {
      const glm::ivec3 first = block + leafSize * (glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1);
      const glm::ivec3 low = glm::max(first, box.first);
      const glm::ivec3 high = glm::min(first + leafSize - 1, box.last);
      if (low.x > high.x || low.y > high.y || low.z > high.z)
      {
        continue;
      }
      const auto* leaf = this->Lookup.probeConstLeaf(toCoord(first));
      const T* from = leaf ? leaf->buffer().data() : nullptr;
      const T tile = leaf ? T(0) : this->Lookup.getValue(toCoord(first));
      for (int k = low.z; k <= high.z; ++k)
      {
        for (int j = low.y; j <= high.y; ++j)
        {
          T* to = this->Values.data() +
            (static_cast<std::size_t>(k - box.first.z) * size.y + (j - box.first.y)) * size.x;
          for (int i = low.x; i <= high.x; ++i)
          {
            const glm::ivec3 at = glm::ivec3(i, j, k) - first;
            const T value = from ? from[(at.x * leafSize + at.y) * leafSize + at.z] : tile;
            to[i - box.first.x] = this->Negate ? -value : value;
          }
        }
      }
    }
  }

  void takeCells(const VdbActiveCells::Block& block, const glm::ivec3& offset)
  {
    ActiveCells::Slab& slab = this->Cells.slabs[0];
    slab.runs.clear();
    slab.count = 0;
    for (int k = 0; k < leafSize; ++k)
    {
      for (int j = 0; j < leafSize; ++j)
      {
        // Where the domain begins within the block, its first cells are none.
        const std::uint64_t row =
          (block.cells[static_cast<std::size_t>(k)] >> (j * leafSize) & 0xff) >> std::max(-offset.x, 0);
        if (row != 0)
        {
          slab.runs.push_back({ row, glm::ivec3(std::max(offset.x, 0), offset.y + j, offset.z + k) });
          slab.count += static_cast<std::size_t>(std::popcount(row));
        }
      }
    }
    this->Cells.count = slab.count;
  }

  const VdbGrid& Grid;
  VdbLookup<TreeType> Lookup;
  VoxelBox Domain;
  double IsoValue;
  SampleOptions Options;
  bool Negate;
  std::vector<T> Values;
  ActiveCells Cells;
};

} // namespace

template <class Real>
bool placeIsoSurfaceSamples(const VdbGrid& grid, double isoValue, const SampleOptions& options, bool negate,
  const VdbActiveCells& cells, std::span<Real> points, std::span<float> normals, const Progress& progress)
{
  if (points.size() != 3 * cells.count || (!normals.empty() && normals.size() != 3 * cells.count))
  {
    throw std::invalid_argument("points and normals must have three numbers for each cell");
  }
  return grid.tree().visit(
    [&](const auto& tree)
    {
      using TreeType = std::remove_cvref_t<decltype(tree)>;
      const auto place = [&](std::size_t, std::size_t begin, std::size_t end)
      {
        VdbCellPlacement<TreeType, Real> placer(grid, tree, isoValue, options, negate);
        for (std::size_t i = begin; i < end; ++i)
        {
          const std::size_t at = 3 * cells.blocks[i].before;
          placer.place(cells.blocks[i], points.data() + at, normals.empty() ? nullptr : normals.data() + at);
        }
      };
      constexpr std::size_t blocksPerChunk = 64;
      return parallelForChunks(cells.blocks.size(), place, blocksPerChunk, progress);
    });
}

template bool placeIsoSurfaceSamples(const VdbGrid&, double, const SampleOptions&, bool,
  const VdbActiveCells&, std::span<float>, std::span<float>, const Progress&);
template bool placeIsoSurfaceSamples(const VdbGrid&, double, const SampleOptions&, bool,
  const VdbActiveCells&, std::span<double>, std::span<float>, const Progress&);

} // namespace ink
