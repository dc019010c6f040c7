// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/FacetedSilhouettes.h"

#include "Curves/Contours/SurfaceEdges.h"

namespace ink
{

FacetedSilhouettes::FacetedSilhouettes(const ContourSurface& surface)
{
  if (!surface.corners.empty())
  {
    this->Origin = surface.corners[0].position; // so that offsets lose no digits
  }
  this->Planes.reserve(surface.faces.size());
  for (std::uint32_t face = 0; face < surface.faces.size(); ++face)
  {
    const glm::dvec3 normal = surface.faceNormal(face);
    const glm::dvec3& position = surface.corners[surface.faces[face][0]].position;
    this->Planes.push_back({ normal, glm::dot(normal, position - this->Origin) });
  }
  visitEdges(
    surface, [](std::uint32_t, std::uint32_t) { return true; },
    [&](std::span<const FaceEdge> edge)
    {
      if (edge.size() == 2)
      {
        this->Edges.push_back({ edge[0].site0, edge[0].site1, edge[0].face, edge[1].face,
          edge[0].forward == edge[1].forward ? -1.0 : 1.0 });
      }
    });
  this->Clusters = SilhouetteClusters(this->Edges.size(), 2,
    [&](std::size_t begin, std::size_t end, std::vector<NormalCone::Item>& items)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Edge& edge = this->Edges[i];
        items.push_back(
          { surface.corners[surface.faces[edge.face0][0]].position, this->Planes[edge.face0].normal });
        items.push_back({ surface.corners[surface.faces[edge.face1][0]].position,
          edge.side1 * this->Planes[edge.face1].normal });
      }
    });
}

/// Finds out whether an edge is a silhouette.
struct FacetedSilhouettes::Finder
{
  const FacetedSilhouettes& silhouettes;
  glm::dvec3 eye; ///< from the origin of planes
  double perspective;

  double facing(std::uint32_t face) const
  {
    const auto& [normal, offset] = this->silhouettes.Planes[face];
    return glm::dot(normal, this->eye) - this->perspective * offset;
  }

  void prefetch(std::size_t edge) const { prefetchObject(this->silhouettes.Edges[edge]); }
  void prefetchItems(std::size_t edge) const
  {
    prefetchObject(this->silhouettes.Planes[this->silhouettes.Edges[edge].face0]);
    prefetchObject(this->silhouettes.Planes[this->silhouettes.Edges[edge].face1]);
  }

  void find(std::size_t index, std::vector<ContourSegment>& segments) const
  {
    const Edge& edge = this->silhouettes.Edges[index];
    if (isFront(this->facing(edge.face0)) != isFront(edge.side1 * this->facing(edge.face1)))
    {
      segments.push_back(
        { ContourNode::at(edge.site0), ContourNode::at(edge.site1), edge.face0, edge.face1 });
    }
  }
};

std::vector<ContourSegment> FacetedSilhouettes::find(const Eye& eye, SilhouetteSearch search) const
{
  return searchSilhouettes(
    this->Clusters, eye, search, Finder{ *this, eye.from(this->Origin), eye.parallel ? 0.0 : 1.0 });
}

} // namespace ink
