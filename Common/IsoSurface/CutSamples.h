// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "IsoSurface/ActiveCellId.h"
#include "IsoSurface/ActiveCells.h"
#include "IsoSurface/ResampledSamples.h"

#include <glm/vec3.hpp>

#include <vector>

namespace ink
{

template <class T>
class GridField;

/// What is added to an iso-surface where it leaves the volume.
enum class CutSurface
{
  Open, ///< nothing
  Rim,  ///< samples along the cut, with normals from the surface's over the side's: an edge, one line
  Cap   ///< the rim, samples on all of the side that lies inside of the surface, as if all beyond were
        ///< outside, and samples along the edges between such sides
};

/// Samples on the sides of a volume.
struct CutSamples
{
  std::vector<glm::dvec3> points;  ///< in world units
  std::vector<glm::dvec3> normals; ///< unit, out of the volume
  std::vector<ActiveCellId> cells; ///< those at the side that the samples lie in, by their global index
};

/// The samples that a rim has at each position. Their normals turn by 15 degrees from one to the next, from
/// the surface's over the side's to the opposite of the surface's and a little beyond, so that from
/// everywhere one of them faces away just so, as a surface does beyond a contour.
constexpr int rimNormals = 13;
/// The first ones, up to a little beyond the side's normal, do for viewers who do not face both surface and
/// side. The others are to have discs of half the radius: to who looks along the cut all are on edge, and
/// would make blots of it.
constexpr int rimOuterNormals = 7;

/// The samples that an edge between two sides has at each position. Their normals turn from the one side's to
/// the other's, by 15 degrees of a right angle from one to the next.
constexpr int capEdgeNormals = 7;

/// Samples where an iso-surface meets the sides of the volume: `rimNormals` of them in each face of a cell
/// that lies on a side and that the surface crosses, at the mean of its intersections with the face's edges,
/// and with Cap one in the middle of each such face all of whose corners are inside, that is at or above the
/// iso-value, and `capEdgeNormals` of them in the middle of each edge of a face that lies on two sides and is
/// inside. The order is that of the sides, x before z and the lower before the upper one, then of the faces.
/// Faces with a missing corner have no samples. Discs of isoSurfaceSampleRadius, of the divided grid, leave
/// no holes.
///
/// @param first, last the global indices of the whole volume's first and last sample: its sides
/// @param selection the cells to process
/// @param resampling as for sampleResampledIsoSurfaces: samples are those of faces of the resampled grid, of
///   the values that the surface lies at
template <class T>
CutSamples sampleCut(const GridField<T>& field, double isoValue, CutSurface kind, const glm::ivec3& first,
  const glm::ivec3& last, const CellSelection& selection = {}, const IsoSurfaceResampling& resampling = {});

} // namespace ink
