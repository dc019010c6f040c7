// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Vdb/VdbGrid.h"

#include "Core/ParallelFor.h"
#include "Fields/Vdb/VdbBytes.h"
#include "Fields/Vdb/VdbTree.h"
#include "Fields/Vdb/VdbTreeCheck.h"

#include <glm/common.hpp>

#include <algorithm>
#include <istream>
#include <new>
#include <utility>

namespace ink
{
namespace
{

/// Makes a stream throw at its end, which OpenVDB does not check; undone at the end of the scope.
class ThrowingStream
{
public:
  explicit ThrowingStream(std::istream& in)
    : In(in)
    , Before(in.exceptions())
  {
    in.clear();
    in.exceptions(std::ios::badbit | std::ios::failbit | std::ios::eofbit);
  }
  ~ThrowingStream()
  {
    this->In.exceptions(std::ios::goodbit);
    this->In.clear();
    this->In.exceptions(this->Before);
  }
  ThrowingStream(const ThrowingStream&) = delete;
  ThrowingStream& operator=(const ThrowingStream&) = delete;

private:
  std::istream& In;
  std::ios::iostate Before;
};

void readTree(std::istream& in, const VdbFile& file, const VdbGridInfo& grid, openvdb::TreeBase& tree)
{
  const ThrowingStream throwing(in);
  in.seekg(static_cast<std::streamoff>(grid.treeAt));
  // OpenVDB attaches the file's metadata to the stream.
  openvdb::io::StreamMetadata::Ptr metadata(new openvdb::io::StreamMetadata);
  metadata->setSeekable(false);
  metadata->setHalfFloat(grid.isHalf);
  openvdb::io::setStreamMetadataPtr(in, metadata, false);
  openvdb::io::setVersion(in, { file.libraryMajor, file.libraryMinor }, file.version);
  openvdb::io::setDataCompression(in, grid.compression);
  const auto forget = [&] { openvdb::io::clearStreamMetadataPtr(in); };
  try
  {
    tree.readTopology(in, grid.isHalf);
    tree.readBuffers(in, grid.isHalf);
  }
  catch (...)
  {
    forget();
    throw;
  }
  forget();
}

std::string mebibytes(std::uint64_t bytes)
{
  constexpr std::uint64_t mebibyte = 1 << 20;
  return std::to_string((bytes + mebibyte - 1) / mebibyte) + " MiB";
}

/// Set when the process ends and this library has been shut down, and with it OpenVDB and oneTBB.
bool ended = false;

struct Ending
{
  ~Ending() { ended = true; }
};
const Ending ending;

} // namespace

VdbGrid::Tree::Tree(bool isDouble)
{
  if (isDouble)
  {
    this->values = makeVdbTree<openvdb::DoubleTree>();
  }
  else
  {
    this->values = makeVdbTree<openvdb::FloatTree>();
  }
}

void VdbGrid::freeTree(const Tree* tree)
{
  // Programs such as ParaView delete objects as late as that, and freeing a tree uses threads.
  if (!ended)
  {
    delete tree;
  }
}

VdbGrid::VdbGrid(VdbGridInfo info, std::unique_ptr<const Tree> tree)
  : Info(std::move(info))
  , Content(tree.release(), freeTree)
{
}

std::uint64_t VdbGrid::memoryOf(std::istream& in, const VdbGridInfo& grid)
{
  const int valueSize = grid.isDouble ? sizeof(double) : sizeof(float);
  VdbBytes bytes(in);
  bytes.seek(grid.treeAt, "a grid's tree");
  return checkVdbTree(bytes, { valueSize, grid.isHalf, grid.compression }).bytes(valueSize);
}

VdbGrid VdbGrid::read(std::istream& in, const VdbFile& file, const VdbGridInfo& grid, std::uint64_t memory)
{
  const std::uint64_t needed = memoryOf(in, grid);
  if (needed > memory)
  {
    throw VdbTooLarge(
      "grid '" + grid.name + "' takes " + mebibytes(needed) + " of memory; allowed are " + mebibytes(memory));
  }
  auto tree = std::make_unique<Tree>(grid.isDouble);
  try
  {
    std::visit([&](const auto& values) { readTree(in, file, grid, *values); }, tree->values);
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::ios::failure&)
  {
    throw VdbError("grid '" + grid.name + "': the file ends within its values");
  }
  catch (const std::exception& error)
  {
    throw VdbError("grid '" + grid.name + "': OpenVDB says: " + error.what());
  }
  return VdbGrid(grid, std::move(tree));
}

double VdbGrid::background() const
{
  return this->Content->visit([](const auto& tree) { return static_cast<double>(tree.background()); });
}

std::uint64_t VdbGrid::memory() const
{
  return this->Content->visit([](const openvdb::TreeBase& tree) { return tree.memUsage(); });
}

VoxelBox VdbGrid::activeBox() const
{
  return this->Content->visit(
    [](const openvdb::TreeBase& tree)
    {
      openvdb::CoordBBox box;
      tree.evalActiveVoxelBoundingBox(box);
      return toBox(box);
    });
}

FiniteRange VdbGrid::values(bool negate) const
{
  FiniteRange summary;
  this->Content->visit(
    [&](const auto& tree)
    {
      using T = typename std::remove_cvref_t<decltype(tree)>::ValueType;
      const auto add = [&](const T* values, std::size_t count)
      { summary.add(findFiniteRange(std::span<const T>(values, count))); };
      add(&tree.background(), 1);
      for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
      {
        add(leaf->buffer().data(), leaf->buffer().size());
      }
      auto tile = tree.cbeginValueAll();
      tile.setMaxDepth(tile.getLeafDepth() - 1);
      for (; tile; ++tile)
      {
        add(&tile.getValue(), 1);
      }
    });
  if (negate)
  {
    summary.least = -std::exchange(summary.greatest, -summary.least);
  }
  return summary;
}

VoxelBox VdbGrid::domain() const
{
  // Large enough for every tree, but small enough that neighboring indices do not overflow.
  constexpr int end = std::numeric_limits<int>::max() - (1 << 16);
  return this->Info.domain.value_or(VoxelBox{ glm::ivec3(-end), glm::ivec3(end) });
}

GridGeometry VdbGrid::geometry(const VoxelBox& box) const
{
  return GridGeometry(
    glm::ivec3(box.size()), this->Info.origin, this->Info.spacing, this->Info.direction, box.first);
}

template <class Real>
bool VdbGrid::copyTo(const VoxelBox& box, bool negate, std::span<Real> values, const Progress& progress) const
{
  using TreeType = std::conditional_t<std::is_same_v<Real, double>, openvdb::DoubleTree, openvdb::FloatTree>;
  const auto* tree = std::get_if<typename TreeType::Ptr>(&this->Content->values);
  const glm::dvec3 size = box.size();
  if (!tree || static_cast<double>(values.size()) != size.x * size.y * size.z)
  {
    throw std::invalid_argument("the values to copy a grid to have another type or size");
  }
  const std::size_t strideY = static_cast<std::size_t>(size.x);
  const std::size_t strideZ = strideY * static_cast<std::size_t>(size.y);
  // Layers of blocks are the units of work: the blocks in one are neighbors in the tree.
  const auto blockOf = [](int index) { return index & ~(leafSize - 1); };
  const int firstLayer = blockOf(box.first.z);
  const int layers = box.empty() ? 0 : (blockOf(box.last.z) - firstLayer) / leafSize + 1;
  const auto copyLayer = [&](std::size_t layer)
  {
    VdbLookup<TreeType> lookup(**tree);
    const int z = firstLayer + static_cast<int>(layer) * leafSize;
    for (int y = blockOf(box.first.y); y <= box.last.y; y += leafSize)
    {
      for (int x = blockOf(box.first.x); x <= box.last.x; x += leafSize)
      {
        const glm::ivec3 block(x, y, z);
        const glm::ivec3 low = glm::max(block, box.first);
        const glm::ivec3 high = glm::min(block + leafSize - 1, box.last);
        const auto* leaf = lookup.probeConstLeaf(toCoord(block));
        const Real tile = leaf ? Real(0) : lookup.getValue(toCoord(block));
        for (int k = low.z; k <= high.z; ++k)
        {
          for (int j = low.y; j <= high.y; ++j)
          {
            Real* to = values.data() + strideZ * static_cast<std::size_t>(k - box.first.z) +
              strideY * static_cast<std::size_t>(j - box.first.y) - box.first.x;
            for (int i = low.x; i <= high.x; ++i)
            {
              const Real value = leaf ? leaf->getValue(static_cast<openvdb::Index>(
                                          (i & 7) * leafSize * leafSize + (j & 7) * leafSize + (k & 7)))
                                      : tile;
              to[i] = negate ? -value : value;
            }
          }
        }
      }
    }
  };
  return parallelFor(static_cast<std::size_t>(layers), copyLayer, progress);
}

template bool VdbGrid::copyTo(const VoxelBox&, bool, std::span<float>, const Progress&) const;
template bool VdbGrid::copyTo(const VoxelBox&, bool, std::span<double>, const Progress&) const;

} // namespace ink
