// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Vdb/VdbWrite.h"

#include "Core/ParallelFor.h"
#include "Core/Threads.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Vdb/VdbTree.h"
#include "IsoSurface/ActiveCells.h"

#include <openvdb/tools/Morphology.h>
#include <openvdb/tools/Prune.h>

#include <glm/common.hpp>

#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace ink
{
namespace
{

using openvdb::MaskTree;

template <class T>
struct Range
{
  T lowest = std::numeric_limits<T>::max();
  T highest = std::numeric_limits<T>::lowest();

  void add(T value)
  {
    if (std::isfinite(value))
    {
      this->lowest = std::min(this->lowest, value);
      this->highest = std::max(this->highest, value);
    }
  }
  bool empty() const { return this->highest < this->lowest; }
};

/// Builds the tree of one volume.
template <class T>
class TreeBuilder
{
public:
  using TreeType = std::conditional_t<std::is_same_v<T, double>, openvdb::DoubleTree, openvdb::FloatTree>;
  using Leaf = typename TreeType::LeafNodeType;

  TreeBuilder(const GridField<T>& volume, const VdbConversion& conversion)
    : Volume(volume)
    , First(volume.geometry().first())
    , Last(First + volume.geometry().dimensions() - 1)
    , Around(conversion.around)
  {
    if (this->Around)
    {
      this->findBand(conversion.halfWidth);
    }
    else
    {
      this->forEachSample([&](const glm::ivec3& sample) { this->Values.add(this->at(sample)); });
    }
    if (this->Values.empty())
    {
      this->Values = { T(0), T(0) };
    }
  }

  /// Fills a tree that holds nothing.
  void build(TreeType& tree) const
  {
    tree.root().setBackground(this->Values.lowest, false);
    std::vector<Leaf*> leaves;
    // Rounded down, also for negative indices.
    const glm::ivec3 start(this->First.x & -leafSize, this->First.y & -leafSize, this->First.z & -leafSize);
    for (int z = start.z; z <= this->Last.z; z += leafSize)
    {
      for (int y = start.y; y <= this->Last.y; y += leafSize)
      {
        for (int x = start.x; x <= this->Last.x; x += leafSize)
        {
          this->addBlock({ x, y, z }, tree, leaves);
        }
      }
    }
    parallelFor(leaves.size(), [&](std::size_t n) { this->fill(*leaves[n]); });
    // Leaves stay: one that begins with NaN would count as constant.
    openvdb::tools::pruneTiles(tree);
  }

private:
  T at(const glm::ivec3& voxel) const { return this->Volume.at(voxel - this->First); }

  template <class Body>
  void forEachSample(const Body& body) const
  {
    for (int k = this->First.z; k <= this->Last.z; ++k)
    {
      for (int j = this->First.y; j <= this->Last.y; ++j)
      {
        for (int i = this->First.x; i <= this->Last.x; ++i)
        {
          body({ i, j, k });
        }
      }
    }
  }

  void findBand(int halfWidth)
  {
    // By both rules, so that the grid suits either.
    for (const CrossingRule rule : { CrossingRule::HalfOpen, CrossingRule::Strict })
    {
      const ActiveCells cells = findActiveCells(this->Volume, *this->Around, rule);
      for (const ActiveCells::Slab& slab : cells.slabs)
      {
        this->addCorners(slab);
      }
    }
    if (this->Band->empty())
    {
      throw std::invalid_argument("no surface of this value runs through the volume");
    }
    openvdb::tools::dilateActiveValues(
      *this->Band, halfWidth, openvdb::tools::NN_FACE_EDGE_VERTEX, openvdb::tools::IGNORE_TILES, false);
    this->Band->clip(openvdb::CoordBBox(toCoord(this->First), toCoord(this->Last)));
    // A leaf with only active voxels may have become a tile.
    this->Band->voxelizeActiveTiles();
    for (auto voxel = this->Band->cbeginValueOn(); voxel; ++voxel)
    {
      this->Values.add(this->at(toVector(voxel.getCoord())));
    }
  }

  void addCorners(const ActiveCells::Slab& slab)
  {
    openvdb::tree::ValueAccessor<MaskTree> band(*this->Band);
    for (const CellRun& run : slab.runs)
    {
      for (std::uint64_t rest = run.cells; rest != 0; rest &= rest - 1)
      {
        const glm::ivec3 cell = this->First + run.first + glm::ivec3(std::countr_zero(rest), 0, 0);
        for (int c = 0; c < 8; ++c)
        {
          band.setValueOn(toCoord(cell + glm::ivec3(c & 1, c >> 1 & 1, c >> 2)));
        }
      }
    }
  }

  /// The value of an inactive voxel outside the band; missing voxels stay missing.
  T sideOf(T value) const
  {
    const T side = static_cast<double>(value) >= *this->Around ? this->Values.highest : this->Values.lowest;
    return std::isfinite(value) ? side : value;
  }

  /// A tile if the block is constant, nothing if it is all background, otherwise a leaf to be filled.
  void addBlock(const glm::ivec3& block, TreeType& tree, std::vector<Leaf*>& leaves) const
  {
    const glm::ivec3 low = glm::max(block, this->First);
    const glm::ivec3 high = glm::min(block + leafSize - 1, this->Last);
    const bool inBand = this->Around && this->Band->probeConstLeaf(toCoord(block));
    const T first = this->Around ? this->sideOf(this->at(low)) : this->at(low);
    bool alike = !inBand && std::isfinite(first);
    for (int k = low.z; alike && k <= high.z; ++k)
    {
      for (int j = low.y; alike && j <= high.y; ++j)
      {
        for (int i = low.x; alike && i <= high.x; ++i)
        {
          const T value = this->at({ i, j, k });
          alike = (this->Around ? this->sideOf(value) : value) == first;
        }
      }
    }
    const bool whole = low == block && high == block + leafSize - 1;
    if (!alike || (!whole && first != this->Values.lowest))
    {
      leaves.push_back(tree.touchLeaf(toCoord(block)));
    }
    else if (first != this->Values.lowest)
    {
      tree.addTile(1, toCoord(block), first, !this->Around);
    }
  }

  void fill(Leaf& leaf) const
  {
    const glm::ivec3 block = toVector(leaf.origin());
    const auto* band = this->Band->probeConstLeaf(leaf.origin());
    for (openvdb::Index n = 0; n < Leaf::SIZE; ++n)
    {
      const glm::ivec3 voxel = block + toVector(Leaf::offsetToLocalCoord(n));
      if (glm::min(glm::max(voxel, this->First), this->Last) != voxel)
      {
        leaf.setValueOff(n, this->Values.lowest);
        continue;
      }
      const T value = this->at(voxel);
      const bool active = this->Around ? band && band->isValueOn(n) : value != this->Values.lowest;
      leaf.setValueOnly(n, this->Around && !active ? this->sideOf(value) : value);
      leaf.setActiveState(n, active);
    }
  }

  const GridField<T>& Volume;
  glm::ivec3 First;
  glm::ivec3 Last;
  std::optional<double> Around;
  MaskTree::Ptr Band = makeVdbTree<MaskTree>();
  Range<T> Values;
};

openvdb::Vec3i toVec3i(const glm::ivec3& v)
{
  return { v.x, v.y, v.z };
}

/// The matrix of a grid's transform in OpenVDB's convention: row vector times matrix.
openvdb::Mat4d rowMatrix(const glm::dmat3& columns, const glm::dvec3& origin)
{
  openvdb::Mat4d matrix = openvdb::Mat4d::identity();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      matrix[axis][row] = columns[axis][row];
    }
    matrix[3][axis] = origin[axis];
  }
  return matrix;
}

openvdb::math::Transform::Ptr makeTransform(const VdbGridInfo& info)
{
  glm::dmat3 step;
  for (int axis = 0; axis < 3; ++axis)
  {
    step[axis] = info.direction[axis] * info.spacing[axis];
  }
  try
  {
    return openvdb::math::Transform::createLinearTransform(rowMatrix(step, info.origin));
  }
  catch (const std::exception& error)
  {
    throw VdbError(std::string("OpenVDB refuses the volume's spacing and direction: ") + error.what());
  }
}

/// Gives access to what writes to memory.
class MemoryArchive : public openvdb::io::Archive
{
public:
  static std::string run(openvdb::GridBase::Ptr grid)
  {
    std::ostringstream out(std::ios::out | std::ios::binary);
    MemoryArchive().write(out, openvdb::GridCPtrVec{ std::move(grid) }, true);
    return std::move(out).str();
  }

private:
  using Archive::write;
};

} // namespace

template <class T>
VdbGrid makeVdbGrid(const GridField<T>& volume, const VdbConversion& conversion)
{
  if (!volume.hidden().empty())
  {
    throw std::invalid_argument("a sparse grid cannot hide samples");
  }
  if (conversion.halfWidth < 1)
  {
    throw std::invalid_argument("a band's half width must be at least 1 voxel");
  }
  const GridGeometry& geometry = volume.geometry();
  VdbGridInfo info;
  info.name = conversion.name;
  info.isDouble = std::is_same_v<T, double>;
  info.type = info.isDouble ? "double" : "float";
  info.domain = VoxelBox{ geometry.first(), geometry.first() + geometry.dimensions() - 1 };
  info.surface = conversion.around;
  info.origin = geometry.origin();
  info.spacing = geometry.spacing();
  for (int axis = 0; axis < 3; ++axis)
  {
    info.direction[axis] = geometry.direction()[axis];
  }
  auto tree = std::make_unique<VdbGrid::Tree>(info.isDouble);
  tbb::task_arena(threadCount())
    .execute(
      [&]
      {
        using Builder = TreeBuilder<T>;
        const Builder builder(volume, conversion);
        builder.build(*std::get<typename Builder::TreeType::Ptr>(tree->values));
      });
  return VdbGrid(std::move(info), std::move(tree));
}

template VdbGrid makeVdbGrid(const GridField<float>&, const VdbConversion&);
template VdbGrid makeVdbGrid(const GridField<double>&, const VdbConversion&);

std::string serializeVdb(const VdbGrid& grid)
{
  openvdb::initialize();
  const VdbGridInfo& info = grid.info();
  return grid.tree().visit(
    [&](const auto& tree)
    {
      using TreeType = std::remove_cvref_t<decltype(tree)>;
      // By its name, as Grid<TreeType> would compile all of the tree. Grids require mutable trees; writing
      // does not modify them.
      const openvdb::GridBase::Ptr written = openvdb::GridBase::createGrid(TreeType::treeType());
      written->setTree(openvdb::TreeBase::Ptr(const_cast<TreeType*>(&tree), [](TreeType*) {}));
      written->setName(info.name);
      written->setTransform(makeTransform(info));
      if (info.domain)
      {
        written->insertMeta(vdbMetadata::domainFirst, openvdb::Vec3IMetadata(toVec3i(info.domain->first)));
        written->insertMeta(vdbMetadata::domainLast, openvdb::Vec3IMetadata(toVec3i(info.domain->last)));
      }
      written->insertMeta(
        vdbMetadata::spacing, openvdb::Vec3DMetadata({ info.spacing.x, info.spacing.y, info.spacing.z }));
      written->insertMeta(
        vdbMetadata::direction, openvdb::Mat4DMetadata(rowMatrix(info.direction, glm::dvec3(0.0))));
      if (info.surface)
      {
        written->insertMeta(vdbMetadata::surface, openvdb::DoubleMetadata(*info.surface));
      }
      std::string bytes;
      tbb::task_arena(threadCount()).execute([&] { bytes = MemoryArchive::run(written); });
      return bytes;
    });
}

} // namespace ink
