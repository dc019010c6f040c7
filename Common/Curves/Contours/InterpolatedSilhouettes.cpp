// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/InterpolatedSilhouettes.h"

#include "Curves/Contours/SurfaceEdges.h"

#include <algorithm>
#include <utility>

namespace ink
{

namespace
{

NormalCone::Item itemAt(const ContourSurface& surface, std::uint32_t corner)
{
  return { surface.corners[corner].position, glm::dvec3(surface.corners[corner].normal) };
}

/// Where the silhouette in a face comes from and leads to: the edge from corner i to the next one, by which
/// corners have the eye in front of them. None where all have, or none has.
struct FaceEnds
{
  std::uint8_t from; ///< from such a corner to another
  std::uint8_t to;
};
constexpr FaceEnds endsByFront[8] = { {}, { 0, 2 }, { 1, 0 }, { 1, 2 }, { 2, 1 }, { 0, 1 }, { 2, 0 }, {} };
constexpr std::uint8_t nextCorner[3] = { 1, 2, 0 };

} // namespace

InterpolatedSilhouettes::InterpolatedSilhouettes(const ContourSurface& surface)
  : Faces(surface.faces.size(), 3,
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
  this->Edges = SilhouetteClusters(this->SharpEdges.size(), 4,
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

/// Finds the silhouette within a face.
struct InterpolatedSilhouettes::FaceFinder
{
  const ContourSurface& surface;
  const Eye& eye;

  void prefetch(std::size_t face) const { prefetchObject(this->surface.faces[face]); }
  void prefetchItems(std::size_t face) const
  {
    for (const std::uint32_t corner : this->surface.faces[face])
    {
      prefetchObject(this->surface.corners[corner]);
    }
  }

  void find(std::size_t face, std::vector<ContourSegment>& segments) const
  {
    const Triangle& corners = this->surface.faces[face];
    unsigned front = 0;
    for (int i = 0; i < 3; ++i)
    {
      front |= static_cast<unsigned>(isFront(this->surface.facing(corners[i], this->eye))) << i;
    }
    const auto [from, to] = endsByFront[front];
    if (from != to)
    {
      const auto nodeOn = [&](std::uint8_t edge)
      { return ContourNode::between(corners[edge], corners[nextCorner[edge]]); };
      const auto id = static_cast<std::uint32_t>(face);
      segments.push_back({ nodeOn(from), nodeOn(to), id, id });
    }
  }
};

/// Finds the silhouette along a sharp edge.
struct InterpolatedSilhouettes::EdgeFinder
{
  const ContourSurface& surface;
  const std::vector<SharpEdge>& edges;
  const Eye& eye;

  void prefetch(std::size_t edge) const { prefetchObject(this->edges[edge]); }
  void prefetchItems(std::size_t) const {}

  void find(std::size_t index, std::vector<ContourSegment>& segments) const
  {
    const SharpEdge& edge = this->edges[index];
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
      const double atBegin = this->surface.facing(begin, this->eye);
      const double atEnd = this->surface.facing(end, this->eye);
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
    ContourNode node = ContourNode::at(this->surface.sites[edge.corners[0][0]]);
    for (int i = 0; i <= count; ++i)
    {
      const ContourNode next = i == count
        ? ContourNode::at(this->surface.sites[edge.corners[0][1]])
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
};

std::vector<ContourSegment> InterpolatedSilhouettes::find(
  const ContourSurface& surface, const Eye& eye, SilhouetteSearch search) const
{
  std::vector<ContourSegment> segments =
    searchSilhouettes(this->Faces, eye, search, FaceFinder{ surface, eye });
  const std::vector<ContourSegment> onEdges =
    searchSilhouettes(this->Edges, eye, search, EdgeFinder{ surface, this->SharpEdges, eye });
  segments.insert(segments.end(), onEdges.begin(), onEdges.end());
  return segments;
}

} // namespace ink
