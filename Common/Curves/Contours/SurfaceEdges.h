// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/ParallelSort.h"
#include "Curves/Contours/ContourSurface.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace ink
{

/// Where a face has an edge: from its corner `corner` to the next one, which may lie at either end.
struct FaceEdge
{
  std::uint32_t site0; ///< the lower one
  std::uint32_t site1;
  std::uint32_t face;
  std::uint8_t corner;
  bool forward; ///< whether the face runs from site0 to site1

  /// The face's corners at site0 and site1.
  std::pair<std::uint32_t, std::uint32_t> corners(const ContourSurface& surface) const
  {
    const std::uint32_t first = surface.faces[this->face][this->corner];
    const std::uint32_t second = surface.faces[this->face][(this->corner + 1) % 3];
    return this->forward ? std::pair(first, second) : std::pair(second, first);
  }
};

/// Calls visit(std::span<const FaceEdge>) for each edge with all faces at it, in the order of its sites and
/// these in theirs.
/// @param wanted says of the sites of an edge whether it is visited
template <class Wanted, class Visit>
void visitEdges(const ContourSurface& surface, const Wanted& wanted, const Visit& visit)
{
  std::vector<FaceEdge> edges;
  for (std::uint32_t face = 0; face < surface.faces.size(); ++face)
  {
    for (std::uint8_t corner = 0; corner < 3; ++corner)
    {
      const std::uint32_t from = surface.sites[surface.faces[face][corner]];
      const std::uint32_t to = surface.sites[surface.faces[face][(corner + 1) % 3]];
      if (wanted(from, to))
      {
        edges.push_back({ std::min(from, to), std::max(from, to), face, corner, from < to });
      }
    }
  }
  parallelSort(edges.begin(), edges.end(),
    [](const FaceEdge& a, const FaceEdge& b)
    {
      const auto key = [](const FaceEdge& e) { return std::uint64_t(e.site0) << 32 | e.site1; };
      return std::pair(key(a), a.face) < std::pair(key(b), b.face);
    });
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
  {
    while (
      end < edges.size() && edges[end].site0 == edges[begin].site0 && edges[end].site1 == edges[begin].site1)
    {
      ++end;
    }
    visit(std::span<const FaceEdge>(edges).subspan(begin, end - begin));
  }
}

} // namespace ink
