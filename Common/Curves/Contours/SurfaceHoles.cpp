// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/SurfaceHoles.h"

#include <algorithm>
#include <cstddef>

namespace ink
{

namespace
{

std::uint64_t edgeBetween(std::uint32_t site, std::uint32_t other)
{
  const auto [low, high] = std::minmax(site, other);
  return std::uint64_t(low) << 32 | high;
}

/// Where a silhouette meets the border of a hole.
struct End
{
  std::uint32_t hole;
  bool leaves; ///< the hole, in the direction of the silhouette
  std::uint32_t segment;
  auto operator<=>(const End&) const = default;
};

} // namespace

SurfaceHoles::SurfaceHoles(const std::vector<HoleEdge>& edges)
{
  this->Edges.reserve(edges.size());
  for (const HoleEdge& edge : edges)
  {
    this->Edges.push_back({ edgeBetween(edge.edge.from.corner0, edge.edge.to.corner0), edge.hole });
  }
  std::sort(this->Edges.begin(), this->Edges.end());
}

void SurfaceHoles::bridge(const ContourSurface& surface, std::vector<ContourSegment>& segments) const
{
  if (this->Edges.empty())
  {
    return;
  }
  std::vector<End> ends;
  const auto addEnd = [&](const ContourNode& node, bool leaves, std::size_t segment)
  {
    const Edge wanted{ edgeBetween(surface.sites[node.corner0], surface.sites[node.corner1]), 0 };
    const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), wanted);
    if (found != this->Edges.end() && found->sites == wanted.sites)
    {
      ends.push_back({ found->hole, leaves, static_cast<std::uint32_t>(segment) });
    }
  };
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    addEnd(segments[i].from, true, i);
    addEnd(segments[i].to, false, i);
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end)
  {
    while (end < ends.size() && ends[end].hole == ends[begin].hole)
    {
      ++end;
    }
    if (end == begin + 2 && !ends[begin].leaves && ends[begin + 1].leaves)
    {
      const ContourSegment& before = segments[ends[begin].segment];
      segments.push_back({ before.to, segments[ends[begin + 1].segment].from, before.face, before.face });
    }
  }
}

} // namespace ink
