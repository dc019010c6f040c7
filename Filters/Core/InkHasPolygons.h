// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkHasPolygons_h
#define InkHasPolygons_h

#include "vtkPolyData.h"

/// Whether poly data covers a surface with polygons or triangle strips.
inline bool InkHasPolygons(vtkPolyData* data)
{
  return data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0;
}

#endif
