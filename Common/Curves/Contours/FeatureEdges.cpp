// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/FeatureEdges.h"

#include "Core/DisjointSets.h"
#include "Curves/Contours/SurfaceEdges.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace ink
{

namespace
{

/// Between the normals of two faces, in radians, whichever way these run; 0 for a face without area.
double angleBetween(const ContourSurface& surface, const FaceEdge& a, const FaceEdge& b)
{
  const glm::dvec3 normalA = surface.areaVector(a.face);
  const glm::dvec3 normalB = (a.forward == b.forward ? -1.0 : 1.0) * surface.areaVector(b.face);
  return std::atan2(glm::length(glm::cross(normalA, normalB)), glm::dot(normalA, normalB));
}

double diagonalOf(const ContourSurface& surface)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const ContourSurface::Corner& corner : surface.corners)
  {
    low = glm::min(low, corner.position);
    high = glm::max(high, corner.position);
  }
  return glm::distance(low, high);
}

/// Edges that have ends in common, by the sites of their ends.
class EdgeNetworks
{
public:
  explicit EdgeNetworks(std::size_t sites)
    : Sets(sites)
    , Degrees(sites)
    , Lengths(sites)
    , HasFreeEnd(sites)
  {
  }

  void join(std::span<const ContourSegment> edges)
  {
    for (const ContourSegment& edge : edges)
    {
      this->Sets.join(edge.from.corner0, edge.to.corner0);
      ++this->Degrees[edge.from.corner0];
      ++this->Degrees[edge.to.corner0];
    }
  }

  /// After all of them are joined.
  void measure(const ContourSurface& surface, std::span<const ContourSegment> edges)
  {
    for (const ContourSegment& edge : edges)
    {
      const std::uint32_t from = edge.from.corner0;
      const std::uint32_t to = edge.to.corner0;
      const std::uint32_t root = this->Sets.least(from);
      this->Lengths[root] += glm::distance(surface.corners[from].position, surface.corners[to].position);
      this->HasFreeEnd[root] |= this->Degrees[from] == 1 || this->Degrees[to] == 1;
    }
  }

  /// The same for all edges of a network.
  std::uint32_t networkAt(const ContourSegment& edge) { return this->Sets.least(edge.from.corner0); }

  double lengthAt(const ContourSegment& edge) { return this->Lengths[this->networkAt(edge)]; }

  bool hasFreeEndAt(const ContourSegment& edge) { return this->HasFreeEnd[this->networkAt(edge)]; }

private:
  DisjointSets Sets;
  std::vector<std::uint32_t> Degrees;
  std::vector<double> Lengths;
  std::vector<std::uint8_t> HasFreeEnd;
};

} // namespace

FeatureEdges::FeatureEdges(const ContourSurface& surface, double creaseAngle, double shortestCrease,
  double shortestBorder, bool sharpOnly)
{
  const double least = glm::radians(creaseAngle);
  visitEdges(
    surface, [](std::uint32_t, std::uint32_t) { return true; },
    [&](std::span<const FaceEdge> edge)
    {
      const ContourSegment segment{ ContourNode::at(edge[0].site0), ContourNode::at(edge[0].site1),
        edge.front().face, edge.size() > 1 ? edge[1].face : edge[0].face };
      if (edge.size() == 1)
      {
        this->borders.push_back(segment);
      }
      else if (edge.size() > 2)
      {
        this->nonManifold.push_back(segment);
      }
      else if (angleBetween(surface, edge[0], edge[1]) > least &&
        !(sharpOnly && edge[0].corners(surface) == edge[1].corners(surface)))
      {
        this->creases.push_back(segment);
      }
    });
  if (shortestCrease > 0.0 && !this->creases.empty())
  {
    EdgeNetworks networks(surface.corners.size());
    networks.join(this->creases);
    networks.join(this->borders);
    networks.join(this->nonManifold);
    networks.measure(surface, this->creases);
    const double longest = shortestCrease * diagonalOf(surface);
    std::erase_if(this->creases,
      [&](const ContourSegment& edge)
      { return networks.hasFreeEndAt(edge) && networks.lengthAt(edge) <= longest; });
  }
  if (shortestBorder > 0.0 && !this->borders.empty())
  {
    EdgeNetworks networks(surface.corners.size());
    networks.join(this->borders);
    networks.measure(surface, this->borders);
    const double longest = shortestBorder * diagonalOf(surface);
    std::erase_if(this->borders,
      [&](const ContourSegment& edge)
      {
        const bool isShort = networks.lengthAt(edge) <= longest;
        if (isShort)
        {
          this->holes.push_back({ edge, networks.networkAt(edge) });
        }
        return isShort;
      });
  }
}

} // namespace ink
