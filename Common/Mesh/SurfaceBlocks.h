// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PointSampling/CandidatePoints.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace ink
{

/// The pieces of a surface in blocks of space, with the samples in each. Blocks have eight colors; those of
/// one color do not touch, so that they can be processed in parallel.
///
/// Processing block after block leaves artifacts along the blocks' sides. So blocks have a random offset, and
/// are ragged: the position by which a piece is assigned to a block is jittered by up to an eighth of a
/// block's side.
class SurfaceBlocks
{
public:
  /// The maximum edge length of pieces relative to a block's side. With it, blocks of one color are more than
  /// a third of a side apart, and pieces within a third of a side of each other are in the same or touching
  /// blocks.
  static constexpr float longestPiece = 0.25f;

  /// @param middles positions of all pieces, best in an order in which neighbors are mostly close
  /// @param areas of the pieces, in any unit; not needed with ids
  /// @param ids of the pieces, which random numbers hash; empty: their numbers
  /// @param chosen the pieces that blocks have
  /// @param side of the blocks
  /// @param samples of the surface, sorted by block here. Kept as a reference.
  SurfaceBlocks(std::span<const glm::vec3> middles, std::span<const double> areas,
    std::span<const std::uint64_t> ids, std::span<const std::uint32_t> chosen, float side, std::uint64_t seed,
    std::vector<SpacedSample>& samples);

  std::size_t count() const { return this->Cells.size(); }
  /// From 0 to 7.
  int color(std::size_t block) const;

  /// Of pieces without ids, the cumulative areas before each of the block's pieces and, last, at its end;
  /// they continue from block to block.
  std::span<const double> areas(std::size_t block) const
  {
    const std::size_t begin = this->FirstPiece[block];
    return std::span(this->Areas).subspan(begin, this->FirstPiece[block + 1] - begin + 1);
  }
  /// Of all pieces, without ids.
  double area() const { return this->Areas.back(); }
  std::span<const std::uint32_t> pieces(std::size_t block) const
  {
    const std::size_t begin = this->FirstPiece[block];
    return std::span(this->Pieces).subspan(begin, this->FirstPiece[block + 1] - begin);
  }
  std::span<const SpacedSample> samples(std::size_t block) const
  {
    const std::size_t begin = this->FirstSample[block];
    return std::span(this->Samples).subspan(begin, this->FirstSample[block + 1] - begin);
  }

  /// Calls visit(other) for a block and all that touch it.
  template <class Visit>
  void visitAround(std::size_t block, const Visit& visit) const
  {
    for (int direction = 0; direction < 27; ++direction)
    {
      const glm::ivec3 offset(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
      if (const auto found = this->Ids.find(key(this->Cells[block] + offset)); found != this->Ids.end())
      {
        visit(found->second);
      }
    }
  }

  /// A number for each cell.
  static std::uint64_t key(const glm::ivec3& cell);

private:
  std::vector<glm::ivec3> Cells;
  std::unordered_map<std::uint64_t, std::uint32_t> Ids;
  std::vector<std::uint32_t> Pieces; // block after block
  std::vector<double> Areas;
  std::vector<std::size_t> FirstPiece;
  std::vector<std::size_t> FirstSample;
  const std::vector<SpacedSample>& Samples;
};

} // namespace ink
