// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkAllocate_h
#define InkAllocate_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkType.h"

class vtkAbstractArray;
class vtkPoints;

// Memory for VTK's arrays, or std::bad_alloc where there is none. Their own methods end the program then
// where VTK was built without NDEBUG, as Debian's ParaView is; so it is asked for beforehand.

/// Room for so many tuples, or more; keeps what is in the array.
VTKINKFILTERSCORE_EXPORT void InkReserve(vtkAbstractArray* array, vtkIdType tuples);

/// So many tuples.
VTKINKFILTERSCORE_EXPORT void InkSetNumberOfTuples(vtkAbstractArray* array, vtkIdType tuples);

/// So many points.
VTKINKFILTERSCORE_EXPORT void InkSetNumberOfPoints(vtkPoints* points, vtkIdType count);

#endif
