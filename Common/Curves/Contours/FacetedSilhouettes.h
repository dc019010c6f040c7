// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/LargePages.h"
#include "Curves/Contours/ContourSegments.h"
#include "Curves/Contours/ContourSurface.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/SilhouetteSearch.h"

#include <cstdint>
#include <vector>

namespace ink
{

/// Silhouettes as edges between a face seen from its front and one seen from its back. Which sides of two
/// faces belong together follows from how these run along the edge, so the mesh need not be oriented.
class FacetedSilhouettes
{
public:
  explicit FacetedSilhouettes(const ContourSurface& surface);

  /// In the order of the edges' sites.
  std::vector<ContourSegment> find(const Eye& eye, SilhouetteSearch search) const;

private:
  struct Finder;

  struct Edge
  {
    std::uint32_t site0;
    std::uint32_t site1;
    std::uint32_t face0;
    std::uint32_t face1;
    double side1; ///< -1 where the front of face1 belongs to the back of face0, else 1
  };

  /// A face's plane: n.v = normal.(e - Origin) - offset for an eye at e.
  struct Plane
  {
    glm::dvec3 normal; ///< unit length, or zero
    double offset;
  };

  glm::dvec3 Origin = glm::dvec3(0.0);
  LargePageVector<Plane> Planes; ///< of faces
  LargePageVector<Edge> Edges;
  SilhouetteClusters Clusters;
};

} // namespace ink
