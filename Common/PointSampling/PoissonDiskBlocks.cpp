// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PoissonDiskBlocks.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace ink
{
namespace
{

constexpr int blockBits = 21;

std::uint64_t blockKey(const glm::ivec3& block)
{
  const glm::uvec3 positive(block + (1 << (blockBits - 1)));
  return std::uint64_t(positive.x) << (2 * blockBits) | std::uint64_t(positive.y) << blockBits | positive.z;
}

} // namespace

std::uint32_t BlockTable::at(const glm::ivec3& block)
{
  // Consecutive triangles and darts are mostly in the same block.
  if (block == this->LastBlock)
  {
    return this->LastName;
  }
  const auto [entry, isNew] =
    this->Ids.emplace(blockKey(block), static_cast<std::uint32_t>(this->Blocks.size()));
  if (isNew)
  {
    this->Blocks.push_back(block);
  }
  this->LastBlock = block;
  this->LastName = entry->second;
  return entry->second;
}

BlockSortedMesh::BlockSortedMesh(const TriangleMesh& mesh, std::span<const glm::vec3> points, float block)
  : Triangles(mesh.triangles.size())
  , Density(mesh.triangleDensity.size())
  , Order(mesh.triangles.size())
{
  BlockTable table;
  std::vector<std::uint32_t> blocks(this->Order.size());
  for (std::size_t t = 0; t < this->Order.size(); ++t)
  {
    const glm::vec3 corner = points[mesh.triangles[t][0]] / block;
    blocks[t] = glm::all(glm::lessThan(glm::abs(corner), glm::vec3(0x1p20f)))
      ? table.at(glm::ivec3(glm::floor(corner)))
      : 0;
  }
  std::vector<std::uint32_t> next(table.blocks().size() + 2);
  for (const std::uint32_t id : blocks)
  {
    ++next[id + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::uint32_t t = 0; t < this->Order.size(); ++t)
  {
    this->Order[next[blocks[t]]++] = t;
  }
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    this->Triangles[i] = mesh.triangles[this->Order[i]];
    if (!this->Density.empty())
    {
      this->Density[i] = mesh.triangleDensity[this->Order[i]];
    }
  }
  this->View = { mesh.points, this->Triangles, mesh.pointDensity, this->Density };
}

} // namespace ink
