// SPDX-License-Identifier: BSD-3-Clause
#include "InkAllocate.h"

#include "InkVTKCompat.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"

#include <cstddef>
#include <new>

namespace
{

/// Whether there is memory to grow an array to that many tuples: VTK adds its previous size.
void Require(vtkAbstractArray* array, vtkIdType tuples)
{
  const vtkIdType values = tuples * array->GetNumberOfComponents();
  const vtkIdType capacity = InkGetCapacity(array);
  if (values <= capacity)
  {
    return;
  }
  // Not malloc and free, which compilers elide if the result is only compared with null (Clang, GCC from 15
  // on).
  ::operator delete(::operator new(
    static_cast<std::size_t>(values + capacity) * static_cast<std::size_t>(array->GetDataTypeSize())));
}

} // namespace

void InkReserve(vtkAbstractArray* array, vtkIdType tuples)
{
  Require(array, tuples);
  InkReserveTuples(array, tuples);
}

void InkSetNumberOfTuples(vtkAbstractArray* array, vtkIdType tuples)
{
  Require(array, tuples);
  array->SetNumberOfTuples(tuples);
}

void InkSetNumberOfPoints(vtkPoints* points, vtkIdType count)
{
  Require(points->GetData(), count);
  points->SetNumberOfPoints(count);
}
