// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSurfaceOf_h
#define InkSurfaceOf_h

#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;

/// The faces of points with cells: a vtkPolyData as it is, of other data sets the surface, with the arrays of
/// its points and cells but without global ids of cells, as one cell may have several faces. Without cells,
/// the points.
vtkSmartPointer<vtkPolyData> InkSurfaceOf(vtkPointSet* input);

#endif
