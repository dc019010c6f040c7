// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/ContourSurface.h"
#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/FacetedSilhouettes.h"
#include "Curves/Contours/InterpolatedSilhouettes.h"
#include "Curves/Contours/SilhouetteSearch.h"
#include "Curves/Contours/SurfaceHoles.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ink
{

/// Which contours of a mesh are found.
struct MeshContourOptions
{
  bool silhouettes = true;
  /// Whether silhouettes are edges between a face seen from its front and one seen from its back, instead of
  /// the zero set of n.v with normals interpolated across faces, which is smooth and lies near these edges.
  bool faceted = false;
  bool creases = false;
  double creaseAngle = 30.0; ///< in degrees, between the normals of the faces at an edge
  bool borders = false;
  bool nonManifold = false;
  /// Of the surface's diagonal, 0 to 1: creases that end within the surface, and with all that they join are
  /// no longer, are left out: specks, as noise makes them.
  double shortestCrease = 0.0;
  /// Of the surface's diagonal, 0 to 1: borders that with all that they join are no longer are left out:
  /// those around triangles that scans lack. Interpolated silhouettes go on across such holes.
  double shortestBorder = 0.0;
  /// Whether silhouettes leave out edges that are creases, which are contours already: what is drawn twice is
  /// darker. Then silhouettes end where such an edge begins.
  bool once = false;
  /// Whether creases are only edges along which the normals of the two faces differ, as of a mesh that is
  /// split at its feature edges; not those within a smooth but noisy part.
  bool sharpCreasesOnly = false;

  bool operator==(const MeshContourOptions&) const = default;
};

/// Finds the contours of a mesh for any eye. What does not depend on the eye, above all a hierarchy of cones
/// of normals that leaves out faces without a silhouette, is made once; so an eye costs time for the
/// contours' length and not for the number of faces.
///
/// Interpolated silhouettes: Hertzmann and Zorin 2000, section 4.1. The mesh needs neither be closed nor
/// manifold nor oriented. Points of equal position count as one; where normals differ there, the silhouette
/// follows the edge as far as one side is seen from its front and the other one from its back. Faces with a
/// point that is not finite are ignored. Results are the same for any number of threads.
class MeshContours
{
public:
  /// @param normals one per point, of any length, all to the same side of the surface; may be empty if
  ///   silhouettes are faceted or not wanted. Those that are zero or not finite are replaced by the mean of
  ///   those around.
  /// @throws std::invalid_argument if normals are needed and missing, or not one per point, or for an angle
  ///   that is not from 0 to 180
  MeshContours(
    const TriangleMesh& mesh, std::span<const glm::vec3> normals, const MeshContourOptions& options = {});

  /// Contours by kind, in the order of the enumeration. `elements` are indices of the mesh's triangles; of
  /// the two at an edge, one.
  /// @throws std::invalid_argument for an eye that is not finite, or with a direction of zero
  Contours find(const Eye& eye, const ContourArrays& arrays = {},
    SilhouetteSearch search = SilhouetteSearch::Hierarchy) const;

  /// Whether the surface has no border, so that a negative radial curvature tells where it hides its own
  /// silhouette: what has one may be seen from its inside.
  bool isClosed() const { return this->Surface.isClosed; }

private:
  MeshContourOptions Options;
  ContourSurface Surface;
  std::optional<InterpolatedSilhouettes> Interpolated;
  std::optional<FacetedSilhouettes> Faceted;
  Contours Features; ///< creases, borders and non-manifold edges, with all their arrays
  std::optional<SurfaceHoles> Holes;
  std::vector<std::uint64_t> Creases; ///< by the two faces at each edge, ascending; for `once`
};

} // namespace ink
