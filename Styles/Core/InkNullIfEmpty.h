// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkNullIfEmpty_h
#define InkNullIfEmpty_h

#include "vtkPolyData.h"

/// Null for a piece without points, too: mappers draw nothing then, and warn of nothing.
inline vtkPolyData* InkNullIfEmpty(vtkPolyData* piece)
{
  return piece && piece->GetNumberOfPoints() > 0 ? piece : nullptr;
}

#endif
