// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/ContourSegments.h"
#include "Curves/Contours/ContourSurface.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/SilhouetteSearch.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ink
{

/// Silhouettes as the zero set of n.v, which is interpolated linearly on faces from the normals at their
/// corners (Hertzmann and Zorin 2000, section 4.1). Where the normals of two faces differ along the edge
/// between them, n.v is discontinuous; there the silhouette is the part of the edge where its signs differ,
/// which joins what ends there on either side.
class InterpolatedSilhouettes
{
public:
  explicit InterpolatedSilhouettes(const ContourSurface& surface);

  /// In the order of faces, then of sharp edges. Within faces, what is seen from its front lies to the left,
  /// if faces run counterclockwise about their normals.
  std::vector<ContourSegment> find(
    const ContourSurface& surface, const Eye& eye, SilhouetteSearch search) const;

private:
  /// An edge between two faces with different normals at one of its ends at least.
  struct SharpEdge
  {
    std::array<std::uint32_t, 2> faces;
    std::array<std::array<std::uint32_t, 2>, 2> corners; ///< of each face, at the edge's begin and end
  };

  struct FaceFinder;
  struct EdgeFinder;

  SilhouetteClusters Faces;
  std::vector<SharpEdge> SharpEdges;
  SilhouetteClusters Edges;
};

} // namespace ink
