// SPDX-License-Identifier: BSD-3-Clause
#include "InkTrimArray.h"

#include "InkVTKCompat.h"

#include "vtkDataArray.h"

void InkTrimArray(vtkDataArray* array)
{
  const vtkIdType tuples = array->GetNumberOfTuples();
  const vtkIdType capacity = InkGetCapacity(array) / array->GetNumberOfComponents();
  if (capacity > tuples + tuples / 4)
  {
    array->SetNumberOfTuples(tuples + tuples / 8);
    array->Squeeze();
    array->SetNumberOfTuples(tuples);
  }
}
