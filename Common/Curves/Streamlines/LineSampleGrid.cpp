// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/LineSampleGrid.h"

#include "Core/Hash.h"
#include "Mesh/SurfaceSides.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace ink
{

namespace
{

constexpr std::size_t fewestSlots = 1024;
/// Of squared distances to cells, which are rounded.
constexpr float roundingMargin = 1.01f;

/// 21 bits of each coordinate: bricks that share them are 2 million bricks apart, which only costs time.
std::uint64_t brickOf(const glm::ivec3& cell)
{
  constexpr std::uint64_t mask = (1u << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x >> 2) & mask) |
    (static_cast<std::uint64_t>(cell.y >> 2) & mask) << 21 |
    (static_cast<std::uint64_t>(cell.z >> 2) & mask) << 42;
}

std::size_t indexInBrick(const glm::ivec3& cell)
{
  return static_cast<std::size_t>((cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4);
}

/// areNear as a function that is surely inlined: shared libraries may replace exported ones.
inline bool areClose(const LineSample& a, const LineSample& b, float distance)
{
  const glm::vec3 offset = b.position - a.position;
  const float squared = glm::dot(offset, offset);
  if (!(squared < distance * distance))
  {
    return false;
  }
  const float up = glm::dot(a.normal, offset);
  const float otherUp = glm::dot(b.normal, offset);
  return !areApart(glm::dot(a.normal, b.normal), up * up, otherUp * otherUp, squared);
}

} // namespace

bool areNear(const LineSample& a, const LineSample& b, float distance)
{
  return areClose(a, b, distance);
}

LineSampleGrid::LineSampleGrid(float cellSize)
  : Scale(1.0f / cellSize)
  , Slots(fewestSlots)
{
}

std::size_t LineSampleGrid::slotOf(std::uint64_t key) const
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t slot = hash(key) & mask;
  while (this->Slots[slot].brick != none && this->Slots[slot].key != key)
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void LineSampleGrid::grow()
{
  std::vector<Slot> slots(4 * this->Slots.size());
  std::swap(slots, this->Slots);
  for (const Slot& slot : slots)
  {
    if (slot.brick != none)
    {
      this->Slots[this->slotOf(slot.key)] = slot;
    }
  }
}

void LineSampleGrid::insert(const LineSample& sample)
{
  const glm::ivec3 cell(glm::floor(sample.position * this->Scale));
  const std::uint64_t key = brickOf(cell);
  std::size_t slot = this->slotOf(key);
  if (this->Slots[slot].brick == none)
  {
    if (2 * (this->Bricks.size() + 1) > this->Slots.size())
    {
      this->grow();
      slot = this->slotOf(key);
    }
    this->Slots[slot] = { key, static_cast<std::uint32_t>(this->Bricks.size()) };
    this->Bricks.emplace_back().fill(none);
  }
  std::uint32_t& first = this->Bricks[this->Slots[slot].brick][indexInBrick(cell)];
  if (first == none || this->Blocks[first].count == blockSize)
  {
    this->Blocks.push_back({ {}, 0, first });
    first = static_cast<std::uint32_t>(this->Blocks.size() - 1);
  }
  Block& block = this->Blocks[first];
  block.samples[block.count++] = sample;
}

bool LineSampleGrid::hasNear(std::uint32_t block, const LineSample& sample, float distance) const
{
  for (; block != none; block = this->Blocks[block].next)
  {
    const Block& some = this->Blocks[block];
    for (std::uint32_t i = 0; i < some.count; ++i)
    {
      if (areClose(sample, some.samples[i], distance))
      {
        return true;
      }
    }
  }
  return false;
}

bool LineSampleGrid::isNear(const LineSample& sample, float distance) const
{
  const glm::vec3 scaled = sample.position * this->Scale;
  const glm::ivec3 own(glm::floor(scaled));
  std::uint64_t key = brickOf(own);
  const auto brickAt = [this](std::uint64_t at)
  {
    const std::uint32_t found = this->Slots[this->slotOf(at)].brick;
    return found == none ? nullptr : &this->Bricks[found];
  };
  const Brick* brick = brickAt(key);
  // Most of what is near is in the same cell.
  if (brick && this->hasNear((*brick)[indexInBrick(own)], sample, distance))
  {
    return true;
  }
  const float reach = distance * this->Scale;
  const glm::ivec3 low(glm::floor(scaled - reach));
  const glm::ivec3 high(glm::floor(scaled + reach));
  // What a coordinate adds to the squared distance to a cell.
  const auto aside = [](float at, int cell, int ownCell)
  {
    const float gap = cell < ownCell ? at - static_cast<float>(cell + 1)
                                     : (cell > ownCell ? static_cast<float>(cell) - at : 0.0f);
    return gap * gap;
  };
  const float most = reach * reach * roundingMargin;
  for (int z = low.z; z <= high.z; ++z)
  {
    const float asideZ = aside(scaled.z, z, own.z);
    for (int y = low.y; y <= high.y; ++y)
    {
      const float asideY = asideZ + aside(scaled.y, y, own.y);
      for (int x = low.x; x <= high.x; ++x)
      {
        const glm::ivec3 cell(x, y, z);
        if (cell == own || asideY + aside(scaled.x, x, own.x) > most)
        {
          continue;
        }
        if (const std::uint64_t ownKey = brickOf(cell); ownKey != key)
        {
          key = ownKey;
          brick = brickAt(key);
        }
        if (brick && this->hasNear((*brick)[indexInBrick(cell)], sample, distance))
        {
          return true;
        }
      }
    }
  }
  return false;
}

void LineSampleGrid::clear()
{
  if (!this->Bricks.empty())
  {
    std::fill(this->Slots.begin(), this->Slots.end(), Slot());
    this->Bricks.clear();
    this->Blocks.clear();
  }
}

} // namespace ink
