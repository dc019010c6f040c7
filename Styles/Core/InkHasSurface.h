// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkHasSurface_h
#define InkHasSurface_h

#include "InkDiscStipples.h"
#include "InkHasPolygons.h"

/// Whether data has polygons, or points with normals and radii, which cover a surface with discs.
inline bool InkHasSurface(vtkPolyData* data)
{
  return InkHasPolygons(data) || InkHasDiscs(data);
}

#endif
