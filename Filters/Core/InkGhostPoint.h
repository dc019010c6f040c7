// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkGhostPoint_h
#define InkGhostPoint_h

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

/// Whether a point is hidden, or a duplicate of one that another piece has.
/// @param ghosts `vtkGhostType` or null
inline bool InkIsGhostPoint(vtkUnsignedCharArray* ghosts, vtkIdType point)
{
  constexpr unsigned char marks = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  return ghosts && point < ghosts->GetNumberOfTuples() && (ghosts->GetValue(point) & marks) != 0;
}

#endif
