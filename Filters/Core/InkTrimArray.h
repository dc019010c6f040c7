// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTrimArray_h
#define InkTrimArray_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

class vtkDataArray;

/// Gives memory back that an array was promised and does not need, down to an eighth more than it holds, when
/// it has a quarter more or beyond: GetActualMemorySize counts what was promised. The eighth is for the next
/// run of a filter that fills the array again. Nothing is copied where the system can cut memory in place, as
/// glibc does.
VTKINKFILTERSCORE_EXPORT void InkTrimArray(vtkDataArray* array);

#endif
