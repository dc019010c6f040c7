// SPDX-License-Identifier: BSD-3-Clause
// Cubes of space that a Poisson disk sampling works in, one beside the other.
#pragma once

#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ink
{

/// Indices sorted by block.
template <class Thing>
class BlockLists
{
public:
  /// @param parts indices with their blocks
  BlockLists(std::span<const std::vector<std::pair<std::uint32_t, Thing>>> parts, std::size_t blocks)
    : Begin(blocks + 1, 0)
  {
    for (const auto& part : parts)
    {
      for (const auto& [block, thing] : part)
      {
        ++this->Begin[block + 1];
      }
    }
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    this->Things.resize(this->Begin.back());
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    for (const auto& part : parts)
    {
      for (const auto& [block, thing] : part)
      {
        this->Things[next[block]++] = thing;
      }
    }
  }

  std::span<const Thing> of(std::size_t block) const
  {
    return std::span(this->Things).subspan(this->Begin[block], this->Begin[block + 1] - this->Begin[block]);
  }

private:
  std::vector<std::size_t> Begin;
  std::vector<Thing> Things;
};

/// Assigns ids to occupied blocks.
class BlockTable
{
public:
  /// @param block each coordinate from -2^20 up to but excluding 2^20
  std::uint32_t at(const glm::ivec3& block);
  std::span<const glm::ivec3> blocks() const { return this->Blocks; }

private:
  std::unordered_map<std::uint64_t, std::uint32_t> Ids;
  std::vector<glm::ivec3> Blocks;
  glm::ivec3 LastBlock{ std::numeric_limits<int>::max() };
  std::uint32_t LastName = 0;
};

/// A mesh with its triangles sorted by blocks of space, so that neighbors on the surface are close in memory.
class BlockSortedMesh
{
public:
  /// @param points in units of the smallest radius
  /// @param block the side of a block in the same unit
  BlockSortedMesh(const TriangleMesh& mesh, std::span<const glm::vec3> points, float block);
  BlockSortedMesh(const BlockSortedMesh&) = delete;
  BlockSortedMesh& operator=(const BlockSortedMesh&) = delete;

  const TriangleMesh& view() const { return this->View; }
  /// A triangle's index in the original mesh.
  std::uint32_t idOf(std::uint32_t triangle) const { return this->Order[triangle]; }

private:
  std::vector<Triangle> Triangles;
  std::vector<float> Density;
  std::vector<std::uint32_t> Order;
  TriangleMesh View;
};

} // namespace ink
