// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/RingOrder.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ink
{

namespace
{

/// Appends the ring of a closed fan whose triangles run the same way round, by a search for each next link,
/// which is fastest for few. @return whether it is one
bool appendOriented(std::vector<LinkEdge>& links, std::vector<std::uint32_t>& ring)
{
  const std::size_t count = links.size();
  const std::size_t begin = ring.size();
  // Links that have been followed stand in front.
  for (std::size_t at = 0; at + 1 < count; ++at)
  {
    ring.push_back(links[at].from);
    std::size_t next = at + 1;
    while (next < count && links[next].from != links[at].to)
    {
      ++next;
    }
    if (next == count)
    {
      return false;
    }
    std::swap(links[at + 1], links[next]);
  }
  ring.push_back(links.back().from);
  if (links.back().to != ring[begin])
  {
    return false;
  }
  // A point that is passed twice has more than two triangles at its edge.
  for (auto point = ring.begin() + static_cast<std::ptrdiff_t>(begin); point != ring.end(); ++point)
  {
    if (std::find(point + 1, ring.end(), *point) != ring.end())
    {
      return false;
    }
  }
  return true;
}

/// The points that a walk from triangle to triangle passes, along links in both directions that are sorted by
/// where they start, at most two at each point.
std::vector<std::uint32_t> walk(const std::vector<LinkEdge>& links, const LinkEdge& first)
{
  std::vector<std::uint32_t> passed;
  for (LinkEdge at = first;;)
  {
    passed.push_back(at.from);
    auto next = std::partition_point(
      links.begin(), links.end(), [&](const LinkEdge& link) { return link.from < at.to; });
    next += next->triangle == at.triangle;
    if (next == links.end() || next->from != at.to)
    {
      passed.push_back(at.to);
      return passed;
    }
    at = *next;
    if (at.from == first.from)
    {
      return passed;
    }
  }
}

} // namespace

RingShape appendRing(std::vector<LinkEdge>& links, std::vector<std::uint32_t>& ring)
{
  constexpr std::size_t few = 16;
  if (links.empty())
  {
    return RingShape::Isolated;
  }
  const std::size_t begin = ring.size();
  if (links.size() >= 3 && links.size() <= few)
  {
    if (appendOriented(links, ring))
    {
      return RingShape::Closed;
    }
    ring.resize(begin);
  }

  const LinkEdge first = links[0];
  const std::size_t triangles = links.size();
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const LinkEdge link = links[i];
    links.push_back({ link.to, link.from, link.triangle });
  }
  std::sort(links.begin(), links.end(),
    [](const LinkEdge& a, const LinkEdge& b)
    { return std::tie(a.from, a.triangle) < std::tie(b.from, b.triangle); });
  std::size_t ends = 0;
  bool branches = false;
  LinkEdge start = first;
  for (std::size_t i = 0, next = 0; i < links.size(); i = next)
  {
    while (next < links.size() && links[next].from == links[i].from)
    {
      ++next;
    }
    ring.push_back(links[i].from);
    branches |= next - i > 2;
    if (next - i == 1)
    {
      ++ends;
      start = links[i];
    }
  }
  if (branches || ends > 2)
  {
    return RingShape::NonManifold;
  }
  const std::vector<std::uint32_t> passed = walk(links, start);
  const bool all = passed.size() == ring.size() - begin;
  if (ends == 2)
  {
    return all ? RingShape::Open : RingShape::NonManifold;
  }
  if (!all || passed.size() < 3)
  {
    return RingShape::NonManifold;
  }
  std::copy(passed.begin(), passed.end(), ring.begin() + static_cast<std::ptrdiff_t>(begin));
  return RingShape::Closed;
}

} // namespace ink
