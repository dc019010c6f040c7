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

} // namespace

bool areNear(const LineSample& a, const LineSample& b, float distance)
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

bool LineSampleGrid::isNear(const LineSample& sample, float distance) const
{
  const glm::ivec3 low(glm::floor((sample.position - distance) * this->Scale));
  const glm::ivec3 high(glm::floor((sample.position + distance) * this->Scale));
  std::uint64_t key = 0;
  const Brick* brick = nullptr;
  bool isKnown = false;
  for (int z = low.z; z <= high.z; ++z)
  {
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        const glm::ivec3 cell(x, y, z);
        if (const std::uint64_t own = brickOf(cell); !isKnown || own != key)
        {
          const std::uint32_t found = this->Slots[this->slotOf(own)].brick;
          brick = found == none ? nullptr : &this->Bricks[found];
          key = own;
          isKnown = true;
        }
        for (std::uint32_t next = brick ? (*brick)[indexInBrick(cell)] : none; next != none;)
        {
          const Block& block = this->Blocks[next];
          for (std::uint32_t i = 0; i < block.count; ++i)
          {
            if (areNear(sample, block.samples[i], distance))
            {
              return true;
            }
          }
          next = block.next;
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
