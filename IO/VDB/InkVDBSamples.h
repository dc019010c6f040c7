// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkVDBSamples_h
#define InkVDBSamples_h

#include "Core/Progress.h"
#include "Fields/Grid/GridGeometry.h"
#include "Fields/Vdb/VdbGrid.h"
#include "IsoSurface/Vdb/VdbTiles.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <optional>
#include <vector>

class vtkFloatArray;
class vtkPoints;

/// What of a grid is sampled, and how.
struct InkVDBSampleRequest
{
  std::vector<double> IsoValues;
  /// Its arithmetic is that of DoubleArithmetic and of the points.
  ink::VdbTileOptions Options;
  bool DoubleArithmetic;
  int PointsPrecision; ///< as in vtkAlgorithm; the default depends on the grid

  /// Whether surfaces are those of masks, smoothed, divided, cut or of some parts only: sampled in tiles
  /// instead of in the active cells of the tree.
  bool TakesTiles() const;
};

/// Points on a grid's iso-surfaces, those of one after the other.
struct InkVDBSamples
{
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkFloatArray> Normals; ///< null if the options say so
  std::vector<std::size_t> Counts;        ///< the points of each iso-value
  ink::GridGeometry Cells;                ///< in which there is one point each
};

/// Of a piece of the grid.
/// @return nothing when stopped
/// @throws ink::VdbTooLarge
std::optional<InkVDBSamples> InkSampleVDB(
  const ink::VdbGrid& grid, const InkVDBSampleRequest& request, const ink::Progress& progress);

#endif
