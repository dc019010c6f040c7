// SPDX-License-Identifier: BSD-3-Clause
#include "InkAllocate.h"

#include "InkVTKCompat.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"

#include <cstddef>
#include <new>

namespace
{

/// Whether there is memory for what an array takes when it grows to so many tuples: VTK adds what it had.
void Require(vtkAbstractArray* array, vtkIdType tuples)
{
  const vtkIdType values = tuples * array->GetNumberOfComponents();
  const vtkIdType capacity = InkGetCapacity(array);
  if (values <= capacity)
  {
    return;
  }
  // Not malloc and free, which compilers leave out where only null is asked for (Clang, GCC from 15 on).
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
