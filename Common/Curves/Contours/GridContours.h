// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"
#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"
#include "Curves/Contours/NormalClusters.h"
#include "Curves/Contours/SilhouetteSearch.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/ActiveCells.h"
#include "IsoSurface/CellBricks.h"

#include <cstddef>
#include <vector>

namespace ink
{

/// How the contours of a grid's iso-surface are found.
struct GridContourOptions
{
  /// Newton steps with which points are projected onto the contour of the interpolated field, as in
  /// projectToContour; no point moves farther than a cell's diagonal. 0: points stay where the contour of the
  /// surface that is linear in tetrahedra passes their faces.
  int projectionSteps = 0;
  /// Exhaustive: all active cells are searched, not only those in bricks that may hold a contour.
  SilhouetteSearch search = SilhouetteSearch::Hierarchy;
};

/// Finds the occluding contours of a grid's iso-surface for any eye, straight from the samples (Burns et al.
/// 2005): where f = isoValue and grad f . v = 0, with v the vector to the eye. The surface is that of
/// findBrickContour, through the edges of tetrahedra, and grad f the field's differences at samples.
///
/// What does not depend on the eye is made once: the active cells in bricks of 4 x 4 x 4, and a tree of cones
/// of their normals; so an eye costs time for the contours' length and not for the surface. Normals are out
/// of the denser side. Chains are closed, or end at the grid's border or where samples are missing; seen from
/// outside, what faces the eye is on their left. Where the surface is parallel to the view and flat, as the
/// faces of a box for a parallel projection, n . v is 0 but for rounding, and what is found is arbitrary.
///
/// The same for any number of threads.
template <class T>
class GridContours
{
public:
  /// @param field kept as a view: its samples must outlive this
  /// @param selection the cells to search
  /// @param ranges as in findActiveCells
  /// @param progress when it asks to stop, no contours will be found
  GridContours(const GridField<T>& field, double isoValue, const CellSelection& selection = {},
    MinMaxBricks* ranges = nullptr, const Progress& progress = {});

  /// All are silhouettes. `elements` are indices of the grid's cells, i fastest.
  /// @throws std::invalid_argument for an eye that is not finite, or with a direction of zero
  Contours find(
    const Eye& eye, const ContourArrays& arrays = {}, const GridContourOptions& options = {}) const;

  /// Where the surface ends, see gridBorder; a closed surface has no border.
  Contours border(const ContourArrays& arrays = {}) const;

  /// The number of bricks with active cells, and of those that are searched for an eye.
  std::size_t brickCount() const { return this->Bricks.size(); }
  std::size_t searchedBrickCount(const Eye& eye) const;

private:
  GridField<T> Samples;
  double IsoValue;
  std::vector<CellBrick> Bricks;
  NormalClusters Normals; ///< of the bricks, in steps of the grid
};

} // namespace ink
