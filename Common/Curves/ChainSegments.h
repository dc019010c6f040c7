// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Polylines.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A segment by its two nodes.
using Segment = std::array<std::uint32_t, 2>;

/// Segments that have been joined to polylines.
struct Chains
{
  Polylines polylines;
  std::vector<std::uint32_t> nodes;    ///< of each point
  std::vector<std::uint32_t> segments; ///< of each point, the segment to the next one; an open chain's last
                                       ///< point repeats the one before
};

/// Joins segments at the nodes that two of them share; where one, three or more meet, chains end. Each
/// segment is in one chain, but for those from a node to itself, which are left out. Chains are in the order
/// of their first segments, and run from node 0 to node 1 of these; a closed one begins there.
Chains chainSegments(std::span<const Segment> segments, std::size_t nodeCount);

} // namespace ink
