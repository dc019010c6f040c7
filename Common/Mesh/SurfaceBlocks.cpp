// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceBlocks.h"

#include "Core/Hash.h"
#include "Core/ParallelFor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace ink
{

namespace
{

constexpr float farthestMoved = 0.125f;
constexpr std::size_t chunkSize = 1 << 14;

/// Three random numbers in [0, 1).
glm::vec3 unitVector(std::uint64_t random)
{
  constexpr std::uint64_t mask = (1 << 21) - 1;
  return glm::vec3(random & mask, random >> 21 & mask, random >> 42 & mask) * 0x1p-21f;
}

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
    const std::uint64_t name = keys.empty() ? piece : keys[piece];
    const glm::vec3 moved = farthestMoved * (2.0f * unitVector(hash(ownSeed ^ name)) - 1.0f);
    return glm::ivec3(glm::floor(middles[piece] / side + shift + moved));
  };
  const auto findBlocks = [&](std::size_t count, const auto& pieceAt)
  {
    std::vector<glm::ivec3> cells(count);
    parallelFor((count + chunkSize - 1) / chunkSize,
      [&](std::size_t chunk)
      {
        for (std::size_t i = chunk * chunkSize; i < std::min((chunk + 1) * chunkSize, count); ++i)
        {
          cells[i] = cellOf(pieceAt(i));
        }
      });
    std::vector<std::uint32_t> blockOf(count);
    glm::ivec3 last(std::numeric_limits<int>::max());
    std::uint32_t lastName = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      // Most are in the same block as the previous one.
      if (cells[i] != last)
      {
        last = cells[i];
        const auto [entry, isNew] =
          this->Ids.emplace(key(last), static_cast<std::uint32_t>(this->Cells.size()));
        if (isNew)
        {
          this->Cells.push_back(last);
        }
        lastName = entry->second;
      }
      blockOf[i] = lastName;
    }
    return blockOf;
  };
  const std::size_t count = chosen.size();
  const std::vector<std::uint32_t> blockOf = findBlocks(count, [&](std::size_t i) { return chosen[i]; });
  const std::vector<std::uint32_t> blockOfSample =
    findBlocks(samples.size(), [&](std::size_t i) { return samples[i].piece; });
  // Counted one entry later, so that advancing each block's begin while filling ends with the begins.
  this->FirstPiece.assign(this->Cells.size() + 2, 0);
  for (const std::uint32_t block : blockOf)
  {
    ++this->FirstPiece[block + 2];
  }
  std::partial_sum(this->FirstPiece.begin(), this->FirstPiece.end(), this->FirstPiece.begin());
  this->Pieces.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Pieces[this->FirstPiece[blockOf[i] + 1]++] = chosen[i];
  }
  this->Areas.resize(count + 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Areas[i + 1] = this->Areas[i] + areas[this->Pieces[i]];
  }
  this->FirstSample.assign(this->Cells.size() + 2, 0);
  for (const std::uint32_t block : blockOfSample)
  {
    ++this->FirstSample[block + 2];
  }
  std::partial_sum(this->FirstSample.begin(), this->FirstSample.end(), this->FirstSample.begin());
  std::vector<SpacedSample> sorted(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    sorted[this->FirstSample[blockOfSample[i] + 1]++] = samples[i];
  }
  samples = std::move(sorted);
}

} // namespace ink
