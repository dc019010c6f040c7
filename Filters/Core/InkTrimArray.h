// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTrimArray_h
#define InkTrimArray_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

class vtkDataArray;

/// Shrinks an array whose capacity exceeds its size by more than a quarter to a capacity of an eighth more,
/// since GetActualMemorySize counts the capacity. The eighth is for the next run of a filter that refills the
/// array. Nothing is copied where the allocator can shrink in place, as glibc's can.
VTKINKFILTERSCORE_EXPORT void InkTrimArray(vtkDataArray* array);

#endif
