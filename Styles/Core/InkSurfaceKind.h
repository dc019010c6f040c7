// SPDX-License-Identifier: BSD-3-Clause
/// What of poly data covers a surface: polygons, or discs around points, see InkHasDiscs.
#ifndef InkSurfaceKind_h
#define InkSurfaceKind_h

#include "InkDiscStipples.h" // IWYU pragma: export

#include "vtkPolyData.h"

inline bool InkHasPolygons(vtkPolyData* data)
{
  return data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0;
}

#endif
