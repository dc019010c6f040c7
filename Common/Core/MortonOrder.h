// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace ink
{

/// Morton order (Morton 1966), in which neighbors in space are mostly close in memory: the bits of a cell's
/// coordinates interleaved in one code, so that dropping three bits gives the cell of twice the width that
/// contains it.
inline constexpr int mortonBits = 21; // of a coordinate

/// Spreads the bits of a 21-bit number, inserting two zeros after each.
constexpr std::uint64_t spreadBits(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffffu;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffu;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fu;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3u;
  return (bits | bits << 2) & 0x1249249249249249u;
}

/// The inverse of spreadBits.
constexpr std::uint32_t gatherBits(std::uint64_t bits)
{
  bits &= 0x1249249249249249u;
  bits = (bits | bits >> 2) & 0x10c30c30c30c30c3u;
  bits = (bits | bits >> 4) & 0x100f00f00f00f00fu;
  bits = (bits | bits >> 8) & 0x001f0000ff0000ffu;
  bits = (bits | bits >> 16) & 0x001f00000000ffffu;
  return static_cast<std::uint32_t>(bits | bits >> 32);
}

constexpr std::uint64_t mortonOf(const glm::uvec3& cell)
{
  return spreadBits(cell.x) | spreadBits(cell.y) << 1 | spreadBits(cell.z) << 2;
}

constexpr glm::uvec3 mortonCell(std::uint64_t order)
{
  return { gatherBits(order), gatherBits(order >> 1), gatherBits(order >> 2) };
}

/// The code of the cell that a position lies in, where cells are of width 1 and the origin is in the middle
/// of them; of positions beyond the last cells, that of the nearest.
inline std::uint64_t mortonOfPosition(const glm::vec3& position)
{
  return mortonOf(glm::uvec3(glm::clamp(glm::floor(position) + 0x1p20f, 0.0f, 0x1p21f - 1.0f)));
}

/// The same for groups of what lies in one cell, with cells apart from where things often lie: where cells
/// meet is hardly a side of what lies around the origin, which would tear its groups, nor in the middles of a
/// grid's cells, on which rounding would decide.
inline std::uint64_t mortonOfGroup(const glm::vec3& position)
{
  return mortonOfPosition(position + glm::vec3(0.38f, 0.21f, 0.57f));
}

} // namespace ink
