// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/InterpolatedSilhouettes.h"

#include "Curves/Contours/SurfaceEdges.h"

#include <algorithm>

namespace ink
{

namespace
{

NormalCone::Item itemAt(const ContourSurface& surface, std::uint32_t corner)
{
  return { surface.corners[corner].position, glm::dvec3(surface.corners[corner].normal) };
}

void findInFace(
  const ContourSurface& surface, const Eye& eye, std::uint32_t face, std::vector<ContourSegment>& segments)
{
  const Triangle& corners = surface.faces[face];
  const bool front[3] = { isFront(surface.facing(corners[0], eye)), isFront(surface.facing(corners[1], eye)),
    isFront(surface.facing(corners[2], eye)) };
  if (front[0] == front[1] && front[1] == front[2])
  {
    return;
  }
  ContourSegment segment{ {}, {}, face, face };
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    if (front[i] != front[next])
    {
      (front[i] ? segment.from : segment.to) = ContourNode::between(corners[i], corners[next]);
    }
  }
  segments.push_back(segment);
}

} // namespace

InterpolatedSilhouettes::InterpolatedSilhouettes(const ContourSurface& surface)
  : Faces(surface.faces.size(),
      [&](std::size_t begin, std::size_t end, std::vector<NormalCone::Item>& items)
      {
        for (std::size_t face = begin; face < end; ++face)
        {
          for (const std::uint32_t corner : surface.faces[face])
          {
            items.push_back(itemAt(surface, corner));
          }
        }
      })
{
  if (surface.siteNormals.empty())
  {
    return;
  }
  std::vector<std::uint8_t> isSplit(surface.corners.size());
  for (std::size_t corner = 0; corner < surface.sites.size(); ++corner)
  {
    isSplit[surface.sites[corner]] |= surface.sites[corner] != corner;
  }
  visitEdges(
    surface, [&](std::uint32_t a, std::uint32_t b) { return isSplit[a] || isSplit[b]; },
    [&](std::span<const FaceEdge> edge)
    {
      if (edge.size() != 2)
      {
        return; // chains end at a border, and where many faces meet
      }
      const auto [a0, a1] = edge[0].corners(surface);
      const auto [b0, b1] = edge[1].corners(surface);
      if (a0 != b0 || a1 != b1)
      {
        this->SharpEdges.push_back({ { edge[0].face, edge[1].face }, { { { a0, a1 }, { b0, b1 } } } });
      }
    });
  this->Edges = NormalClusters(this->SharpEdges.size(),
    [&](std::size_t begin, std::size_t end, std::vector<NormalCone::Item>& items)
    {
      for (std::size_t edge = begin; edge < end; ++edge)
      {
        for (const auto& corners : this->SharpEdges[edge].corners)
        {
          items.push_back(itemAt(surface, corners[0]));
          items.push_back(itemAt(surface, corners[1]));
        }
      }
    });
}

void InterpolatedSilhouettes::findOnEdge(
  const ContourSurface& surface, const Eye& eye, const SharpEdge& edge, std::vector<ContourSegment>& segments)
{
  // Where n.v of a side changes its sign, as a fraction of the edge.
  struct Change
  {
    double at;
    int side;
  };
  Change changes[2];
  int count = 0;
  bool front[2];
  for (int side = 0; side < 2; ++side)
  {
    const auto& [begin, end] = edge.corners[side];
    const double atBegin = surface.facing(begin, eye);
    const double atEnd = surface.facing(end, eye);
    front[side] = isFront(atBegin);
    if (front[side] != isFront(atEnd))
    {
      changes[count++] = { atBegin / (atBegin - atEnd), side };
    }
  }
  if (count == 2 && changes[1].at < changes[0].at)
  {
    std::swap(changes[0], changes[1]);
  }
  ContourNode node = ContourNode::at(surface.sites[edge.corners[0][0]]);
  for (int i = 0; i <= count; ++i)
  {
    const ContourNode next = i == count
      ? ContourNode::at(surface.sites[edge.corners[0][1]])
      : ContourNode::between(edge.corners[changes[i].side][0], edge.corners[changes[i].side][1]);
    if (front[0] != front[1])
    {
      segments.push_back({ node, next, edge.faces[0], edge.faces[1] });
    }
    node = next;
    if (i < count)
    {
      front[changes[i].side] = !front[changes[i].side];
    }
  }
}

std::vector<ContourSegment> InterpolatedSilhouettes::find(
  const ContourSurface& surface, const Eye& eye, SilhouetteSearch search) const
{
  std::vector<ContourSegment> segments = searchSilhouettes(this->Faces, surface.faces.size(), eye, search,
    [&](std::size_t face, std::vector<ContourSegment>& found)
    { findInFace(surface, eye, static_cast<std::uint32_t>(face), found); });
  const std::vector<ContourSegment> onEdges =
    searchSilhouettes(this->Edges, this->SharpEdges.size(), eye, search,
      [&](std::size_t edge, std::vector<ContourSegment>& found)
      { findOnEdge(surface, eye, this->SharpEdges[edge], found); });
  segments.insert(segments.end(), onEdges.begin(), onEdges.end());
  return segments;
}

} // namespace ink
