// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkContourLines_h
#define InkContourLines_h

#include "Curves/Contours/Contours.h"

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkType.h"

#include <span>

class vtkPolyData;

/// Makes contours the lines of a vtkPolyData: closed ones end with the id of their first point; the cell
/// array `ContourKind`, and a point array for each that the contours have: `Normals`, `RadialCurvature`,
/// `ArcLength`, `CellId`.
/// @param pointType VTK_FLOAT or VTK_DOUBLE
/// @param cellIds the cell of each element of the surface; empty: elements are cells
VTKINKFILTERSCORE_EXPORT void InkMakeContourLines(
  const ink::Contours& contours, int pointType, std::span<const vtkIdType> cellIds, vtkPolyData* output);

#endif
