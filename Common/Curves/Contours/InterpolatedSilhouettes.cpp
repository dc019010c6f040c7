// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/InterpolatedSilhouettes.h"

#include "Curves/Contours/SurfaceEdges.h"

#include <algorithm>
#include <bit>
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

/// Appends the segments of some faces in a row.
/// @param front bit 3 f + i: whether the eye is in front of corner i of face f
void addSegments(const ContourSurface& surface, std::size_t begin, std::uint32_t front,
  std::vector<ContourSegment>& segments)
{
  constexpr std::uint32_t firstCorners = 0x249249;
  const std::uint32_t any = front | front >> 1 | front >> 2;
  const std::uint32_t all = front & front >> 1 & front >> 2;
  for (std::uint32_t left = any & ~all & firstCorners; left != 0; left &= left - 1)
  {
    const int bit = std::countr_zero(left);
    const auto face = static_cast<std::uint32_t>(begin + bit / 3);
    const Triangle& corners = surface.faces[face];
    const auto [from, to] = endsByFront[front >> bit & 7];
    const auto nodeOn = [&](std::uint8_t edge)
    { return ContourNode::between(corners[edge], corners[edge == 2 ? 0 : edge + 1]); };
    segments.push_back({ nodeOn(from), nodeOn(to), face, face });
  }
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
  , Corners(surface.corners.size(), this->Faces.ball(),
      [&](std::uint32_t corner)
      { return std::pair(glm::dvec3(surface.corners[corner].normal), surface.corners[corner].position); })
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
  static_assert(NormalClusters::clusterSize == FacingPlanes::atOnce && sizeof(Triangle) == 12);
  const FacingPlanes::View corners(this->Corners, eye);
  std::vector<ContourSegment> segments = searchSilhouettes(this->Faces, surface.faces.size(), eye, search,
    [&](std::size_t begin, std::size_t end, std::vector<ContourSegment>& found)
    {
      std::uint32_t front = 0;
      std::uint32_t unknown = (1u << 3 * (end - begin)) - 1;
      const std::uint32_t* first = surface.faces[begin].data();
      if (search == SilhouetteSearch::Hierarchy && end - begin == NormalClusters::clusterSize)
      {
        for (int part = 0; part < 3; ++part)
        {
          const FacingPlanes::Sides sides = corners.sides(first + FacingPlanes::atOnce * part);
          front |= sides.front << FacingPlanes::atOnce * part;
          unknown ^= (sides.front | sides.back) << FacingPlanes::atOnce * part;
        }
      }
      for (; unknown != 0; unknown &= unknown - 1)
      {
        const int corner = std::countr_zero(unknown);
        front |= static_cast<std::uint32_t>(isFront(surface.facing(first[corner], eye))) << corner;
      }
      addSegments(surface, begin, front, found);
    });
  const std::vector<ContourSegment> onEdges =
    searchSilhouettes(this->Edges, this->SharpEdges.size(), eye, search,
      [&](std::size_t begin, std::size_t end, std::vector<ContourSegment>& found)
      {
        for (std::size_t edge = begin; edge < end; ++edge)
        {
          findOnEdge(surface, eye, this->SharpEdges[edge], found);
        }
      });
  segments.insert(segments.end(), onEdges.begin(), onEdges.end());
  return segments;
}

} // namespace ink
