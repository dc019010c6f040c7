// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/ContourSegments.h"
#include "Curves/Contours/ContourSurface.h"
#include "Curves/Contours/SurfaceHoles.h"

#include <vector>

namespace ink
{

/// Of the surface's diagonal: which creases styles leave out, see FeatureEdges.
inline constexpr double defaultShortestCrease = 0.05;

/// The edges of a surface that are contours for every eye, by what they are, in the order of their sites.
struct FeatureEdges
{
  std::vector<ContourSegment> creases;     ///< between two faces at an angle
  std::vector<ContourSegment> borders;     ///< of one face
  std::vector<ContourSegment> nonManifold; ///< of more than two faces
  std::vector<HoleEdge> holes;             ///< borders that are left out

  /// @param creaseAngle between the faces' normals, in degrees; an edge of a larger one is a crease
  /// @param shortestCrease of the surface's diagonal: creases that end within the surface, and with all that
  ///   they join are no longer than that, are left out. Noise makes such; the edges of a machine part,
  ///   however short, end at others.
  /// @param shortestBorder of the surface's diagonal: borders that are no longer than that, with all borders
  ///   that they join, are left out, as around triangles that a scan lacks
  /// @param sharpOnly whether an edge where the two faces have the same normals at both ends is none
  FeatureEdges(const ContourSurface& surface, double creaseAngle, double shortestCrease = 0.0,
    double shortestBorder = 0.0, bool sharpOnly = false);
};

} // namespace ink
