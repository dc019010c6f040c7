// SPDX-License-Identifier: BSD-3-Clause
#include "InkMakeMask.h"

#include <cmath>

vtkSmartPointer<vtkDataArray> InkMakeMask(vtkDataArray* labels, double isoValue)
{
  auto mask = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(labels->GetDataType()));
  const vtkIdType count = labels->GetNumberOfTuples();
  mask->SetNumberOfTuples(count);
  for (vtkIdType n = 0; n < count; ++n)
  {
    const double value = labels->GetComponent(n, 0);
    mask->SetComponent(n, 0, !std::isfinite(value) ? value : value >= isoValue ? 1.0 : 0.0);
  }
  return mask;
}
