// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestVolume_h
#define InkTestVolume_h

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

/// Gives an image, whatever its position, scalars of a type, "Density", that are function(x, y, z) of the
/// world point.
template <class Function>
void InkTestFill(vtkImageData* image, int type, Function function)
{
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetName("Density");
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    double p[3];
    image->GetPoint(n, p);
    scalars->SetComponent(n, 0, function(p[0], p[1], p[2]));
  }
}

#endif
