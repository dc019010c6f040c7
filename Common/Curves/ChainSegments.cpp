// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/ChainSegments.h"

#include <algorithm>

namespace ink
{

namespace
{

struct Node
{
  std::uint32_t degree = 0;
  std::uint32_t segments[2] = {}; // the first two at it
};

std::vector<Node> joinNodes(std::span<const Segment> segments, std::size_t nodeCount)
{
  std::vector<Node> nodes(nodeCount);
  for (std::uint32_t i = 0; i < segments.size(); ++i)
  {
    for (const std::uint32_t end : segments[i])
    {
      Node& node = nodes[end];
      if (segments[i][0] != segments[i][1] && node.degree++ < 2)
      {
        node.segments[node.degree - 1] = i;
      }
    }
  }
  return nodes;
}

/// A segment and the node towards which it is walked along.
struct Step
{
  std::uint32_t segment;
  std::uint32_t to;
};

} // namespace

Chains chainSegments(std::span<const Segment> segments, std::size_t nodeCount)
{
  const std::vector<Node> nodes = joinNodes(segments, nodeCount);
  std::vector<std::uint8_t> done(segments.size());
  // The next step of a walk; false at a chain's end.
  const auto advance = [&](Step& step)
  {
    const Node& node = nodes[step.to];
    if (node.degree != 2)
    {
      return false;
    }
    step.segment = node.segments[node.segments[0] == step.segment];
    step.to = segments[step.segment][segments[step.segment][0] == step.to];
    return true;
  };
  std::vector<Step> back;
  Chains result;
  result.nodes.reserve(segments.size());
  result.segments.reserve(segments.size());
  for (std::uint32_t first = 0; first < segments.size(); ++first)
  {
    if (done[first] || segments[first][0] == segments[first][1])
    {
      continue;
    }
    // Backwards to the chain's begin, or all around to the first segment again.
    Step step{ first, segments[first][0] };
    bool closed = false;
    back.clear();
    do
    {
      done[step.segment] = 1;
      back.push_back(step);
    } while (advance(step) && !(closed = step.segment == first));
    const auto add = [&result](const Step& from)
    {
      result.segments.push_back(from.segment);
      result.nodes.push_back(from.to);
    };
    if (closed)
    {
      add(back.front());
      std::for_each(back.rbegin(), back.rend() - 1, add);
    }
    else
    {
      std::for_each(back.rbegin(), back.rend(), add);
      step = { first, segments[first][1] };
      result.nodes.push_back(step.to);
      while (advance(step))
      {
        done[step.segment] = 1;
        add(step);
      }
      result.segments.push_back(result.segments.back());
    }
    result.polylines.offsets.push_back(result.nodes.size());
    result.polylines.closed.push_back(closed);
  }
  return result;
}

} // namespace ink
