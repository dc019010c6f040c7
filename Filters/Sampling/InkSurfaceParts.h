// SPDX-License-Identifier: BSD-3-Clause
// The connected parts of iso-surfaces that come as points.
#ifndef InkSurfaceParts_h
#define InkSurfaceParts_h

#include "vtkInkFiltersSamplingModule.h" // for the export macro

#include "IsoSurface/ActiveCellComponents.h"

#include <cstddef>
#include <span>
#include <vector>

class vtkDataArray;

/// Removes the points of parts that are not selected, surface by surface.
///
/// @param cells of all points, in any order; several may share one
/// @param counts the number of points of each surface, one surface after the other; those that are left are
///   returned in it
/// @param arrays with a tuple a point or more, contiguous in memory; `cells` may be the memory of one of
/// them.
///   They keep their size; those that are left come first
VTKINKFILTERSSAMPLING_EXPORT void InkKeepParts(std::span<const ink::ActiveCellId> cells,
  const ink::ComponentSelection& selection, std::span<vtkDataArray* const> arrays,
  std::vector<std::size_t>& counts);

#endif
