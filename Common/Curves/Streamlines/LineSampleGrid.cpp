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

/// 21 bits of each coordinate: cells that share them are 2 million cells apart, which only costs time.
std::uint64_t keyOf(int x, int y, int z)
{
  constexpr std::uint64_t mask = (1u << 21) - 1;
  return (static_cast<std::uint64_t>(x) & mask) | (static_cast<std::uint64_t>(y) & mask) << 21 |
    (static_cast<std::uint64_t>(z) & mask) << 42;
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

std::size_t LineSampleGrid::slotOf(std::uint64_t cell) const
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t slot = hash(cell) & mask;
  while (this->Slots[slot].block != none && this->Slots[slot].cell != cell)
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
    if (slot.block != none)
    {
      this->Slots[this->slotOf(slot.cell)] = slot;
    }
  }
}

void LineSampleGrid::insert(const LineSample& sample)
{
  const glm::ivec3 cell(glm::floor(sample.position * this->Scale));
  const std::uint64_t key = keyOf(cell.x, cell.y, cell.z);
  Slot* slot = &this->Slots[this->slotOf(key)];
  if (slot->block == none && 2 * ++this->Used > this->Slots.size())
  {
    this->grow();
    slot = &this->Slots[this->slotOf(key)];
  }
  slot->cell = key;
  if (slot->block == none || this->Blocks[slot->block].count == blockSize)
  {
    this->Blocks.push_back({ {}, 0, slot->block });
    slot->block = static_cast<std::uint32_t>(this->Blocks.size() - 1);
  }
  Block& block = this->Blocks[slot->block];
  block.samples[block.count++] = sample;
}

bool LineSampleGrid::isNear(const LineSample& sample, float distance) const
{
  const glm::ivec3 low(glm::floor((sample.position - distance) * this->Scale));
  const glm::ivec3 high(glm::floor((sample.position + distance) * this->Scale));
  for (int z = low.z; z <= high.z; ++z)
  {
    for (int y = low.y; y <= high.y; ++y)
    {
      for (int x = low.x; x <= high.x; ++x)
      {
        std::uint32_t next = this->Slots[this->slotOf(keyOf(x, y, z))].block;
        while (next != none)
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
  if (this->Used > 0)
  {
    std::fill(this->Slots.begin(), this->Slots.end(), Slot());
    this->Blocks.clear();
    this->Used = 0;
  }
}

} // namespace ink
