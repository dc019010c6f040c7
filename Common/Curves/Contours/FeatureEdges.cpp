// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/FeatureEdges.h"

#include "Curves/Contours/SurfaceEdges.h"

#include <glm/trigonometric.hpp>

#include <cmath>

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

} // namespace

FeatureEdges::FeatureEdges(const ContourSurface& surface, double creaseAngle)
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
      else if (angleBetween(surface, edge[0], edge[1]) > least)
      {
        this->creases.push_back(segment);
      }
    });
}

} // namespace ink
