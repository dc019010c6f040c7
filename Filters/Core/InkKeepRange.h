// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkKeepRange_h
#define InkKeepRange_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

class vtkDataArray;

/// Finds the range of an array of one component on all threads and keeps it where the array keeps its own
/// until it is modified, which otherwise looks for it when it is first asked, in many builds of VTK on one
/// thread. Nothing is done where no value is finite, nor for arrays of other memory than VTK's usual.
VTKINKFILTERSCORE_EXPORT void InkKeepRange(vtkDataArray* array);

#endif
