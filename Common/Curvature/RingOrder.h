// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{

/// How the triangles at a point are connected.
enum class RingShape : std::uint8_t
{
  Closed,      ///< one closed fan
  Open,        ///< one open fan, at a border
  NonManifold, ///< several fans, or an edge of more than two triangles
  Isolated     ///< no triangles
};

/// The edge of a triangle that is opposite to a point, in one of its two directions.
struct LinkEdge
{
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t triangle;
};

/// Appends the ring of a point to `ring`: the points that share an edge with it, each once; of a closed fan
/// in its order, in the direction of the first link, otherwise ascending.
/// @param links of all triangles at the point, in the directions in which they run; scratch space
RingShape appendRing(std::vector<LinkEdge>& links, std::vector<std::uint32_t>& ring);

} // namespace ink
