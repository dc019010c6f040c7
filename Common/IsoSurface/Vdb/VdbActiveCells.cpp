// SPDX-License-Identifier: BSD-3-Clause
// A cell belongs to the block of 8^3 voxels that contains its first corner. It can only be active if one of
// the up to eight blocks with its corners is a leaf, or if two of them are tiles on different sides of the
// surface. So the candidate blocks are
// - all leaves;
// - the blocks inside a tile that precede a leaf along one or more axes, if the leaf's voxels at that border
//   are not all on the tile's side;
// - the blocks inside a tile that precede a block of another tile on the other side of the surface. One of
//   these two tiles is not on the background's side, and the search starts from that one.

#include "IsoSurface/Vdb/VdbSamples.h"

#include "Core/ParallelChunks.h"
#include "Core/ParallelFor.h"
#include "Fields/Vdb/VdbTree.h"
#include "IsoSurface/IsoThreshold.h"

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>

namespace ink
{
namespace
{

using openvdb::Coord;

/// The samples of a block and of its far borders, which its cells need as well.
constexpr int Samples = leafSize + 1;

bool before(const glm::ivec3& a, const glm::ivec3& b)
{
  return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
}

template <class TreeType>
class VdbCellFinder
{
public:
  using T = typename TreeType::ValueType;
  using Leaf = typename TreeType::LeafNodeType;
  using Lookup = VdbLookup<TreeType>;
  using Block = VdbActiveCells::Block;

  VdbCellFinder(const VdbGrid& grid, const TreeType& tree, double isoValue, CrossingRule rule, bool negate,
    std::uint64_t memory)
    : Tree(tree)
    , Domain(grid.domain())
    , Rule(rule)
    , Negate(negate)
    , AtLeast(IsoThreshold<T>::atLeast(isoValue))
    , Above(IsoThreshold<T>::above(isoValue))
    , MostBlocks(memory / bytesPerBlock)
  {
  }

  /// All blocks that may contain active cells, sorted.
  std::vector<glm::ivec3> findBlocks() const
  {
    std::vector<const Leaf*> leaves;
    this->Tree.getNodes(leaves);
    std::vector<std::vector<glm::ivec3>> found(leaves.size() / leavesAtOnce + 1);
    const auto look = [&](std::size_t n)
    {
      Lookup lookup(this->Tree);
      const std::size_t end = std::min(leaves.size(), (n + 1) * leavesAtOnce);
      for (std::size_t i = n * leavesAtOnce; i < end; ++i)
      {
        this->addLeaf(*leaves[i], lookup, found[n]);
      }
    };
    parallelFor(found.size(), look);
    this->addTiles(found);

    std::vector<glm::ivec3> blocks;
    for (const std::vector<glm::ivec3>& part : found)
    {
      blocks.insert(blocks.end(), part.begin(), part.end());
    }
    std::sort(blocks.begin(), blocks.end(), before);
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    return blocks;
  }

  /// Finds the active cells of a block; returns whether there are any.
  bool find(const glm::ivec3& first, Lookup& lookup, Block& block) const
  {
    Rows rows;
    this->classify(first, lookup, rows);
    block.first = first;
    block.cells.fill(0);
    // Only cells with all corners inside the domain.
    const glm::ivec3 low = glm::max(this->Domain.first, first) - first;
    const glm::ivec3 high = glm::min(this->Domain.last, first + leafSize) - first;
    const unsigned inDomain = low.z < high.z ? (1u << high.z) - (1u << low.z) : 0u;
    std::uint64_t any = 0;
    for (int x = low.x; x < high.x; ++x)
    {
      for (int y = low.y; y < high.y; ++y)
      {
        for (unsigned rest = this->activeCells(rows, x, y) & inDomain; rest != 0; rest &= rest - 1)
        {
          const std::uint64_t bit = std::uint64_t(1) << (y * leafSize + x);
          block.cells[static_cast<std::size_t>(std::countr_zero(rest))] |= bit;
          any |= bit;
        }
      }
    }
    return any != 0;
  }

private:
  static constexpr std::size_t leavesAtOnce = 64;
  /// Each is listed, and its cells are, in a part of the result and in all of it.
  static constexpr std::uint64_t bytesPerBlock = 2 * (sizeof(glm::ivec3) + sizeof(Block));

  void add(const glm::ivec3& block, std::vector<glm::ivec3>& blocks) const
  {
    if (this->Blocks.fetch_add(1, std::memory_order_relaxed) >= this->MostBlocks)
    {
      throw VdbTooLarge("the surface crosses more than " + std::to_string(this->MostBlocks) +
        " blocks of 8 x 8 x 8 voxels, which take " + std::to_string(this->MostBlocks * bytesPerBlock >> 20) +
        " MiB of memory");
    }
    blocks.push_back(block);
  }

  /// A bit for each of the samples along z at (x, y).
  struct Rows
  {
    unsigned above[Samples][Samples];   ///< at or above the iso-value
    unsigned over[Samples][Samples];    ///< strictly above it
    unsigned missing[Samples][Samples]; ///< not finite
  };

  bool isAbove(T value) const
  {
    return this->AtLeast.reachable && (this->Negate ? -value : value) >= this->AtLeast.lowest;
  }

  /// Whether a leaf's voxels on its near border along the axes of `step` are all on one side of the surface.
  bool borderIs(bool above, const Leaf& leaf, const glm::ivec3& step) const
  {
    const glm::ivec3 end = glm::ivec3(leafSize) - (leafSize - 1) * step;
    const T* values = leaf.buffer().data();
    for (int x = 0; x < end.x; ++x)
    {
      for (int y = 0; y < end.y; ++y)
      {
        for (int z = 0; z < end.z; ++z)
        {
          if (this->isAbove(values[(x * leafSize + y) * leafSize + z]) != above)
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  void addLeaf(const Leaf& leaf, Lookup& lookup, std::vector<glm::ivec3>& blocks) const
  {
    const glm::ivec3 first = toVector(leaf.origin());
    this->add(first, blocks);
    for (int n = 1; n < 8; ++n)
    {
      const glm::ivec3 step(n & 1, n >> 1 & 1, n >> 2);
      const glm::ivec3 neighbor = first - leafSize * step;
      if (!lookup.probeConstLeaf(toCoord(neighbor)) &&
        !this->borderIs(this->isAbove(lookup.getValue(toCoord(neighbor))), leaf, step))
      {
        this->add(neighbor, blocks);
      }
    }
  }

  void addTiles(std::vector<std::vector<glm::ivec3>>& found) const
  {
    const bool outside = this->isAbove(this->Tree.background());
    using Root = typename TreeType::RootNodeType;
    using Upper = typename Root::ChildNodeType;
    using Lower = typename Upper::ChildNodeType;
    found.emplace_back();
    Lookup lookup(this->Tree);
    for (auto tile = this->Tree.root().cbeginValueAll(); tile; ++tile)
    {
      if (this->isAbove(*tile) != outside)
      {
        this->addTile(toVector(tile.getCoord()), Upper::DIM, lookup, found.back());
      }
    }
    this->template addTilesOf<Upper>(outside, found);
    this->template addTilesOf<Lower>(outside, found);
  }

  template <class Node>
  void addTilesOf(bool outside, std::vector<std::vector<glm::ivec3>>& found) const
  {
    std::vector<const Node*> nodes;
    this->Tree.getNodes(nodes);
    const std::size_t start = found.size();
    found.resize(start + nodes.size());
    const auto look = [&](std::size_t n)
    {
      Lookup lookup(this->Tree);
      for (auto tile = nodes[n]->cbeginValueAll(); tile; ++tile)
      {
        if (this->isAbove(*tile) != outside)
        {
          this->addTile(toVector(tile.getCoord()), Node::ChildNodeType::DIM, lookup, found[start + n]);
        }
      }
    };
    parallelFor(nodes.size(), look);
  }

  /// Blocks at a tile's border, inside or before it, that precede another tile on the other side of the
  /// surface.
  void addTile(const glm::ivec3& first, int size, Lookup& lookup, std::vector<glm::ivec3>& blocks) const
  {
    if (this->isSurrounded(first, size, lookup))
    {
      return;
    }
    const glm::ivec3 low = first - leafSize;
    const glm::ivec3 high = first + size - leafSize;
    for (int z = low.z; z <= high.z; z += leafSize)
    {
      for (int y = low.y; y <= high.y; y += leafSize)
      {
        const bool onSide = z == low.z || z == high.z || y == low.y || y == high.y;
        for (int x = low.x; x <= high.x; x += onSide ? leafSize : high.x - low.x)
        {
          if (this->isBeforeOtherTile({ x, y, z }, lookup))
          {
            this->add({ x, y, z }, blocks);
          }
        }
      }
    }
  }

  /// Whether a tile can be skipped, since all active cells at its border are found from its neighbors: it has
  /// only tiles on the same side, or leaves next to a tile of a leaf's size.
  bool isSurrounded(const glm::ivec3& first, int size, Lookup& lookup) const
  {
    const int depth = lookup.getValueDepth(toCoord(first));
    const bool above = this->isAbove(lookup.getValue(toCoord(first)));
    for (int n = 0; n < 27; ++n)
    {
      const Coord at = toCoord(first + size * (glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1));
      const bool leaf = size == leafSize && lookup.probeConstLeaf(at);
      if (!leaf && (lookup.getValueDepth(at) > depth || this->isAbove(lookup.getValue(at)) != above))
      {
        return false;
      }
    }
    return true;
  }

  bool isBeforeOtherTile(const glm::ivec3& block, Lookup& lookup) const
  {
    if (lookup.probeConstLeaf(toCoord(block)))
    {
      return false;
    }
    const bool above = this->isAbove(lookup.getValue(toCoord(block)));
    for (int n = 1; n < 8; ++n)
    {
      const Coord at = toCoord(block + leafSize * glm::ivec3(n & 1, n >> 1 & 1, n >> 2));
      if (!lookup.probeConstLeaf(at) && this->isAbove(lookup.getValue(at)) != above)
      {
        return true;
      }
    }
    return false;
  }

  void classify(const glm::ivec3& first, Lookup& lookup, Rows& rows) const
  {
    T values[Samples][Samples][Samples];
    for (int n = 0; n < 8; ++n)
    {
      const glm::ivec3 step(n & 1, n >> 1 & 1, n >> 2);
      const Coord at = toCoord(first + leafSize * step);
      const Leaf* leaf = lookup.probeConstLeaf(at);
      const T* from = leaf ? leaf->buffer().data() : nullptr;
      const T tile = leaf ? T(0) : lookup.getValue(at);
      const glm::ivec3 count = glm::ivec3(leafSize) - (leafSize - 1) * step;
      for (int x = 0; x < count.x; ++x)
      {
        for (int y = 0; y < count.y; ++y)
        {
          T* to = &values[x + leafSize * step.x][y + leafSize * step.y][leafSize * step.z];
          for (int z = 0; z < count.z; ++z)
          {
            to[z] = from ? from[(x * leafSize + y) * leafSize + z] : tile;
          }
        }
      }
    }
    for (int x = 0; x < Samples; ++x)
    {
      for (int y = 0; y < Samples; ++y)
      {
        unsigned above = 0;
        unsigned over = 0;
        unsigned missing = 0;
        for (int z = 0; z < Samples; ++z)
        {
          const T value = this->Negate ? -values[x][y][z] : values[x][y][z];
          above |= static_cast<unsigned>(value >= this->AtLeast.lowest) << z;
          over |= static_cast<unsigned>(value >= this->Above.lowest) << z;
          missing |= static_cast<unsigned>(!(std::abs(value) <= std::numeric_limits<T>::max())) << z;
        }
        rows.above[x][y] = this->AtLeast.reachable ? above : 0;
        rows.over[x][y] = this->Above.reachable ? over : 0;
        rows.missing[x][y] = missing;
      }
    }
  }

  /// The active ones of the eight cells along z at (x, y), as bits.
  unsigned activeCells(const Rows& rows, int x, int y) const
  {
    constexpr int corners[4][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
    unsigned any = 0;
    unsigned all = ~0u;
    unsigned missing = 0;
    unsigned edges = 0;
    const auto edge = [&](unsigned above1, unsigned over1, unsigned above2, unsigned over2)
    { edges |= (~above1 & over2) | (over1 & ~above2) | (above1 & ~over1 & above2 & ~over2); };
    for (const auto& [dx, dy] : corners)
    {
      const unsigned above = rows.above[x + dx][y + dy];
      const unsigned over = rows.over[x + dx][y + dy];
      any |= above | above >> 1;
      all &= above & above >> 1;
      missing |= rows.missing[x + dx][y + dy] | rows.missing[x + dx][y + dy] >> 1;
      edge(above, over, above >> 1, over >> 1);
      for (const auto& [ex, ey] : corners)
      {
        // The other end of an edge across z, in both layers of the cell.
        if (ex + ey == dx + dy + 1 && ex >= dx && ey >= dy)
        {
          const unsigned otherAbove = rows.above[x + ex][y + ey];
          const unsigned otherOver = rows.over[x + ex][y + ey];
          edge(above, over, otherAbove, otherOver);
          edge(above >> 1, over >> 1, otherAbove >> 1, otherOver >> 1);
        }
      }
    }
    constexpr unsigned cells = 0xff;
    return (this->Rule == CrossingRule::HalfOpen ? any & ~all : edges) & ~missing & cells;
  }

  const TreeType& Tree;
  VoxelBox Domain;
  CrossingRule Rule;
  bool Negate;
  IsoThreshold<T> AtLeast;
  IsoThreshold<T> Above;
  std::uint64_t MostBlocks;
  mutable std::atomic<std::uint64_t> Blocks = 0;
};

} // namespace

VdbActiveCells findActiveCells(const VdbGrid& grid, double isoValue, CrossingRule rule, bool negate,
  const Progress& progress, std::uint64_t memory)
{
  VdbActiveCells cells;
  if (std::isnan(isoValue))
  {
    return cells;
  }
  grid.tree().visit(
    [&](const auto& tree)
    {
      using TreeType = std::remove_cvref_t<decltype(tree)>;
      const VdbCellFinder<TreeType> finder(grid, tree, isoValue, rule, negate, memory);
      const std::vector<glm::ivec3> blocks = finder.findBlocks();
      constexpr std::size_t blocksPerChunk = 64;
      std::vector<std::vector<VdbActiveCells::Block>> found(chunksOf(blocks.size(), blocksPerChunk));
      const auto find = [&](std::size_t chunk, std::size_t begin, std::size_t end)
      {
        VdbLookup<TreeType> lookup(tree);
        VdbActiveCells::Block block;
        for (std::size_t i = begin; i < end; ++i)
        {
          if (finder.find(blocks[i], lookup, block))
          {
            found[chunk].push_back(block);
          }
        }
      };
      if (!parallelForChunks(blocks.size(), find, blocksPerChunk, progress))
      {
        return;
      }
      for (const auto& part : found)
      {
        cells.blocks.insert(cells.blocks.end(), part.begin(), part.end());
      }
    });
  for (VdbActiveCells::Block& block : cells.blocks)
  {
    block.before = cells.count;
    for (const std::uint64_t layer : block.cells)
    {
      cells.count += static_cast<std::size_t>(std::popcount(layer));
    }
  }
  return cells;
}

} // namespace ink
