// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A position on a surface with its normal, as lines are sampled.
struct LineSample
{
  glm::vec3 position;
  glm::vec3 normal;
};

/// Whether two samples are within a distance of each other on the surface. It is measured as a chord, but
/// samples on two sides of a thin wall, or on sheets above each other (ink::areApart), are never near.
bool areNear(const LineSample& a, const LineSample& b, float distance);

/// Samples of lines in a uniform grid of cubic cells, kept in bricks of 4 x 4 x 4 cells that are found by
/// their hash: what is near a position is found in a time that does not depend on the number of lines.
class LineSampleGrid
{
public:
  /// @param cellSize of positions' unit; the largest distance that is asked for
  explicit LineSampleGrid(float cellSize);

  void insert(const LineSample& sample);
  /// Whether a sample of the grid is within a distance, no more than the cell size, on the surface.
  bool isNear(const LineSample& sample, float distance) const;
  void clear();
  bool isEmpty() const { return this->Bricks.empty(); }

private:
  static constexpr std::uint32_t none = ~0u;
  static constexpr std::uint32_t blockSize = 6;
  /// Some samples of a cell.
  struct Block
  {
    LineSample samples[blockSize];
    std::uint32_t count;
    std::uint32_t next; ///< with more of the same cell
  };
  /// The first block of each cell.
  using Brick = std::array<std::uint32_t, 64>;
  struct Slot
  {
    std::uint64_t key;
    std::uint32_t brick = none;
  };

  std::size_t slotOf(std::uint64_t key) const;
  /// @param block the first one of a cell, or none
  bool hasNear(std::uint32_t block, const LineSample& sample, float distance) const;
  void grow();

  float Scale;
  std::vector<Slot> Slots;
  std::vector<Brick> Bricks;
  std::vector<Block> Blocks;
};

} // namespace ink
