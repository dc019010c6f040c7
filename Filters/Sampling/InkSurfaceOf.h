// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSurfaceOf_h
#define InkSurfaceOf_h

#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;

/// The faces of a point set: a vtkPolyData is returned as it is, of other data sets the boundary surface,
/// with its point and cell arrays but without global cell ids, as one cell may have several faces. Without
/// cells, the points.
vtkSmartPointer<vtkPolyData> InkSurfaceOf(vtkPointSet* input);

#endif
