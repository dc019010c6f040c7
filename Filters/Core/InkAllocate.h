// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkAllocate_h
#define InkAllocate_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkType.h"

class vtkAbstractArray;
class vtkPoints;

// Allocate memory of VTK arrays, or throw std::bad_alloc. VTK's own methods abort the program when allocation
// fails in builds without NDEBUG, such as Debian's ParaView; so these functions try the allocation
// beforehand.

/// Reserves memory for at least that many tuples; keeps the array's values.
VTKINKFILTERSCORE_EXPORT void InkReserve(vtkAbstractArray* array, vtkIdType tuples);

/// Sets the number of tuples.
VTKINKFILTERSCORE_EXPORT void InkSetNumberOfTuples(vtkAbstractArray* array, vtkIdType tuples);

/// Sets the number of points.
VTKINKFILTERSCORE_EXPORT void InkSetNumberOfPoints(vtkPoints* points, vtkIdType count);

#endif
