// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSpacingRatios_h
#define InkSpacingRatios_h

#include "Core/Progress.h"
#include "InkMeshTriangles.h"

#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// The point array "SpacingRatio" of strokes: ink::hatching::localSpacing of each family, 1 for points
/// without strokes.
/// @param strokes lines alone, with the cell arrays "Priority", "Spacing" and "LineFamily" of vtkInkHatching
/// @param surface with normals
vtkSmartPointer<vtkFloatArray> InkSpacingRatios(
  vtkPolyData* strokes, const InkMeshTriangles& surface, const ink::Progress& progress);

#endif
