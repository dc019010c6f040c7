// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/ChosenPoints.h"

#include "Core/ParallelChunks.h"
#include "Mesh/SurfaceSides.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

namespace ink
{

namespace
{

/// See areApart in SurfaceSides.h.
bool areApart(const DartPoint& a, const DartPoint& b, const glm::vec3& offset, float squaredDistance)
{
  const float up = glm::dot(a.normal, offset);
  const float otherUp = glm::dot(b.normal, offset);
  return ink::areApart(glm::dot(a.normal, b.normal), up * up, otherUp * otherUp, squaredDistance);
}

/// Whether blocks of the same color never touch, a block's color being its Morton code modulo `colors`.
consteval bool areColorsApart(std::uint64_t colors)
{
  for (std::uint64_t a = 0; a < 64; ++a)
  {
    for (std::uint64_t b = 0; b < a; ++b)
    {
      const glm::uvec3 offset = mortonCell(a) - mortonCell(b) + 1u;
      if (offset.x < 3 && offset.y < 3 && offset.z < 3 && a % colors == b % colors)
      {
        return false;
      }
    }
  }
  return true;
}

static_assert(areColorsApart(ChosenPoints::colors));

} // namespace

void ChosenPoints::findNeighbors(const std::vector<bool>& wanted)
{
  const std::size_t mask = std::bit_ceil(2 * this->Cells.size() + 1) - 1;
  std::vector<std::uint32_t> table(mask + 1, noPoint);
  const auto slotOf = [&](std::uint64_t cell)
  {
    std::size_t slot = (cell * 0x9e3779b97f4a7c15u >> 24) & mask;
    while (table[slot] != noPoint && this->Cells[table[slot]] != cell)
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  };
  for (std::uint32_t i = 0; i < this->Cells.size(); ++i)
  {
    table[slotOf(this->Cells[i])] = i;
  }
  std::vector<std::vector<std::pair<std::uint32_t, std::uint8_t>>> found(chunksOf(this->Cells.size()));
  this->Begin.assign(this->Cells.size() + 1, 0);
  parallelForChunks(this->Cells.size(),
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const glm::uvec3 cell = mortonCell(this->Cells[i]);
        const std::size_t before = found[chunk].size();
        for (std::uint8_t direction = 0; wanted[i] && direction < 27; ++direction)
        {
          // Negative values wrap around to out of range.
          const glm::uvec3 other = (cell + glm::uvec3(direction % 3, direction / 3 % 3, direction / 9) - 1u) &
            ((1u << mortonBits) - 1u);
          if (const std::uint32_t neighbor = table[slotOf(mortonOf(other))]; neighbor != noPoint)
          {
            found[chunk].emplace_back(neighbor, direction);
          }
        }
        this->Begin[i + 1] = static_cast<std::uint32_t>(found[chunk].size() - before);
      }
    });
  std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
  this->Neighbors.resize(this->Begin.back());
  this->Directions.resize(this->Begin.back());
  parallelForChunks(this->Cells.size(),
    [&](std::size_t chunk, std::size_t begin, std::size_t)
    {
      std::size_t next = this->Begin[begin];
      for (const auto& [neighbor, direction] : found[chunk])
      {
        this->Neighbors[next] = neighbor;
        this->Directions[next++] = direction;
      }
    });
}

float ChosenPoints::distance(std::uint32_t index, float width) const
{
  const DartPoint& point = this->Points[index];
  const float reach = width * point.radius;
  const std::uint32_t cell = this->CellOf[index];
  const glm::vec3 low = glm::vec3(mortonCell(this->Cells[cell])) * this->Width;
  const auto within = [&](int axis)
  {
    return (point.position[axis] - reach < low[axis] ? 1u : 0u) | 2u |
      (point.position[axis] + reach >= low[axis] + this->Width ? 4u : 0u);
  };
  const unsigned ranges[3] = { within(0), within(1), within(2) };
  float least = width;
  for (std::uint32_t n = this->Begin[cell]; n < this->Begin[cell + 1]; ++n)
  {
    const unsigned direction = this->Directions[n];
    if (!(ranges[0] >> direction % 3 & ranges[1] >> direction / 3 % 3 & ranges[2] >> direction / 9 & 1u))
    {
      continue;
    }
    for (std::uint32_t i = this->Heads[this->Neighbors[n]]; i != noPoint; i = this->Next[i])
    {
      const DartPoint& other = this->Points[i];
      const glm::vec3 offset = other.position - point.position;
      const float squared = glm::dot(offset, offset);
      const float radius = std::min(point.radius, other.radius);
      const float limit = least * radius;
      if (squared < limit * limit && !areApart(point, other, offset, squared))
      {
        least = std::sqrt(squared) / radius;
      }
    }
  }
  return least < width ? least : std::numeric_limits<float>::infinity();
}

} // namespace ink
