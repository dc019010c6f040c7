// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceBlocks.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"

#include <glm/common.hpp>

#include <numeric>
#include <unordered_map>
#include <utility>

namespace ink
{

namespace
{

constexpr float farthestMoved = 0.125f;

/// Three random numbers in [0, 1).
glm::vec3 unitVector(std::uint64_t random)
{
  constexpr std::uint64_t mask = (1 << 21) - 1;
  return glm::vec3(random & mask, random >> 21 & mask, random >> 42 & mask) * 0x1p-21f;
}

/// Sorts items by their cells, chunk by chunk: each lists the cells that its items lie in, which are few.
class CellSort
{
public:
  /// @param cellOf(i) the cell of item i
  template <class CellOf>
  CellSort(std::size_t count, const CellOf& cellOf)
    : Chunks(chunksOf(count))
    , Own(count)
  {
    parallelForChunks(count,
      [&](std::size_t number, std::size_t begin, std::size_t end)
      {
        Chunk& chunk = this->Chunks[number];
        std::unordered_map<std::uint64_t, std::uint32_t> known;
        std::uint32_t last = 0;
        for (std::size_t i = begin; i < end; ++i)
        {
          const glm::ivec3 cell = cellOf(i);
          // Most are in the same cell as the previous one.
          if (chunk.cells.empty() || cell != chunk.cells[last])
          {
            last =
              known.emplace(SurfaceBlocks::key(cell), static_cast<std::uint32_t>(known.size())).first->second;
            if (last == chunk.cells.size())
            {
              chunk.cells.push_back(cell);
              chunk.counts.push_back(0);
            }
          }
          this->Own[i] = last;
          ++chunk.counts[last];
        }
      });
  }

  /// Finds the block of each cell, in the order in which items have them.
  /// @param blockOf(cell) adds one where there is none
  template <class BlockOf>
  void findBlocks(const BlockOf& blockOf)
  {
    for (Chunk& chunk : this->Chunks)
    {
      for (const glm::ivec3& cell : chunk.cells)
      {
        chunk.blocks.push_back(blockOf(cell));
      }
    }
  }

  /// Where the items of each block begin, one after the other, and last, their number.
  std::vector<std::size_t> findBegins(std::size_t blocks)
  {
    std::vector<std::size_t> begins(blocks + 1, 0);
    this->visitCells([&](std::uint32_t block, std::size_t& count) { begins[block + 1] += count; });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::size_t> next(begins);
    // From now on where each cell's items of a chunk begin.
    this->visitCells([&](std::uint32_t block, std::size_t& count)
      { count = std::exchange(next[block], next[block] + count); });
    return begins;
  }

  /// Calls move(from, to) for each item; to be called once, after findBegins.
  template <class Move>
  void sort(const Move& move)
  {
    parallelForChunks(this->Own.size(),
      [&](std::size_t number, std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          move(i, this->Chunks[number].counts[this->Own[i]]++);
        }
      });
  }

private:
  struct Chunk
  {
    std::vector<glm::ivec3> cells;
    std::vector<std::uint32_t> blocks; // of the cells
    std::vector<std::size_t> counts;   // of the cells' items
  };

  template <class Visit>
  void visitCells(const Visit& visit)
  {
    for (Chunk& chunk : this->Chunks)
    {
      for (std::size_t i = 0; i < chunk.cells.size(); ++i)
      {
        visit(chunk.blocks[i], chunk.counts[i]);
      }
    }
  }

  std::vector<Chunk> Chunks;
  std::vector<std::uint32_t> Own; // the number of each item's cell in its chunk
};

} // namespace

std::uint64_t SurfaceBlocks::key(const glm::ivec3& cell)
{
  constexpr int bits = 21;
  const glm::uvec3 positive(cell + (1 << (bits - 1)));
  return std::uint64_t(positive.x) << (2 * bits) | std::uint64_t(positive.y) << bits | positive.z;
}

int SurfaceBlocks::color(std::size_t block) const
{
  const glm::ivec3 parity = this->Cells[block] & 1;
  return parity.x + 2 * parity.y + 4 * parity.z;
}

SurfaceBlocks::SurfaceBlocks(std::span<const glm::vec3> middles, std::span<const double> areas,
  std::span<const std::uint64_t> keys, std::span<const std::uint32_t> chosen, float side, std::uint64_t seed,
  std::vector<SpacedSample>& samples)
  : Samples(samples)
{
  const glm::vec3 shift = unitVector(hash(seed, 1));
  const std::uint64_t ownSeed = hash(seed, 2);
  const auto cellOf = [&](std::uint32_t piece)
  {
    const std::uint64_t id = keys.empty() ? piece : keys[piece];
    const glm::vec3 moved = farthestMoved * (2.0f * unitVector(hash(ownSeed ^ id)) - 1.0f);
    return glm::ivec3(glm::floor(middles[piece] / side + shift + moved));
  };
  const auto blockOf = [&](const glm::ivec3& cell)
  {
    const auto [entry, isNew] = this->Ids.emplace(key(cell), static_cast<std::uint32_t>(this->Cells.size()));
    if (isNew)
    {
      this->Cells.push_back(cell);
    }
    return entry->second;
  };
  const std::size_t count = chosen.size();
  CellSort sortOfPieces(count, [&](std::size_t i) { return cellOf(chosen[i]); });
  CellSort sortOfSamples(samples.size(), [&](std::size_t i) { return cellOf(samples[i].piece); });
  sortOfPieces.findBlocks(blockOf);
  sortOfSamples.findBlocks(blockOf);
  this->FirstPiece = sortOfPieces.findBegins(this->Cells.size());
  this->Pieces.resize(count);
  sortOfPieces.sort([&](std::size_t from, std::size_t to) { this->Pieces[to] = chosen[from]; });
  if (keys.empty())
  {
    this->Areas.resize(count + 1);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Areas[i + 1] = this->Areas[i] + areas[this->Pieces[i]];
    }
  }
  this->FirstSample = sortOfSamples.findBegins(this->Cells.size());
  std::vector<SpacedSample> sorted(samples.size());
  sortOfSamples.sort([&](std::size_t from, std::size_t to) { sorted[to] = samples[from]; });
  samples = std::move(sorted);
}

} // namespace ink
