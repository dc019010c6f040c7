// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Vdb/VdbNoiseEstimate.h"

#include "Core/ParallelChunks.h"
#include "Fields/Vdb/VdbTree.h"
#include "Statistics/NoiseSampler.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

/// The grid's domain, as far as there is anything: beyond it nothing is looked at but how far values go on.
VoxelBox boxOf(const VdbGrid& grid)
{
  constexpr int around = 2 * static_cast<int>(leafSize);
  const VoxelBox domain = grid.domain();
  const VoxelBox active = grid.activeBox();
  return { glm::max(active.first, domain.first + around) - around,
    glm::min(active.last, domain.last - around) + around };
}

/// The voxels of a tree, for one thread.
template <class TreeType>
class Voxels
{
public:
  using T = typename TreeType::ValueType;

  Voxels(const VdbGrid& grid, const TreeType& tree, const VoxelBox& box, bool negate)
    : Box(box)
    , Lookup(tree)
    , Sign(negate ? T(-1) : T(1))
    , ActiveOnly(grid.info().surface.has_value())
  {
  }

  bool has(const glm::ivec3& voxel) const
  {
    if (glm::clamp(voxel, this->Box.first, this->Box.last) != voxel)
    {
      return false;
    }
    T value;
    const bool active = this->Lookup.probeValue(toCoord(voxel), value);
    return (active || !this->ActiveOnly) && std::isfinite(value);
  }

  T at(const glm::ivec3& voxel) const { return this->Sign * this->Lookup.getValue(toCoord(voxel)); }

private:
  VoxelBox Box;
  VdbLookup<TreeType> Lookup;
  T Sign;
  bool ActiveOnly;
};

template <class TreeType>
std::vector<NoiseSightings> lookAtLeaves(
  const VdbGrid& grid, const TreeType& tree, double isoValue, bool negate, const glm::ivec3& reach)
{
  std::vector<const typename TreeType::LeafNodeType*> leaves;
  tree.getNodes(leaves);
  constexpr std::size_t voxelsOfLeaf = leafSize * leafSize * leafSize;
  const std::size_t every = noiseStride(static_cast<double>(leaves.size()) * voxelsOfLeaf);
  const VoxelBox box = boxOf(grid);
  constexpr std::size_t leavesAtOnce = 256;
  std::vector<NoiseSightings> found(chunksOf(leaves.size(), leavesAtOnce));
  parallelForChunks(
    leaves.size(),
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      const Voxels<TreeType> voxels(grid, tree, box, negate);
      const NoiseSampler<Voxels<TreeType>> sampler(voxels, isoValue, reach);
      for (std::size_t leaf = begin; leaf < end; ++leaf)
      {
        for (std::size_t n = leaf * 7919 % every; n < voxelsOfLeaf; n += every)
        {
          sampler.look(
            toVector(leaves[leaf]->offsetToGlobalCoord(static_cast<openvdb::Index>(n))), found[chunk]);
        }
      }
    },
    leavesAtOnce);
  return found;
}

} // namespace

NoiseEstimate estimateNoise(const VdbGrid& grid, double isoValue, bool negate)
{
  const glm::dvec3 size = grid.info().domain.value_or(grid.activeBox()).size();
  const glm::ivec3 reach(size.x > 2.0, size.y > 2.0, size.z > 2.0);
  const std::vector<NoiseSightings> found =
    grid.tree().visit([&](const auto& tree) { return lookAtLeaves(grid, tree, isoValue, negate, reach); });
  return makeNoiseEstimate(found, reach);
}

} // namespace ink
