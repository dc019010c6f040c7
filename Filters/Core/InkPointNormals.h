// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointNormals_h
#define InkPointNormals_h

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

/// The normals at a point set's points: its active ones, otherwise an array "Normals" of 3 components, which
/// readers and vtkInk's filters make; null if there is neither.
inline vtkDataArray* InkPointNormals(vtkPointSet* data)
{
  vtkPointData* points = data->GetPointData();
  if (vtkDataArray* active = points->GetNormals())
  {
    return active;
  }
  vtkDataArray* named = points->GetArray("Normals");
  return named && named->GetNumberOfComponents() == 3 ? named : nullptr;
}

#endif
