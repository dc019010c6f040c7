// SPDX-License-Identifier: BSD-3-Clause
// What differs between the VTK versions that vtkInk builds with, from 9.2 on; for OpenGL see
// InkOpenGLCompat.h.
#ifndef InkVTKCompat_h
#define InkVTKCompat_h

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

/// Whether the user asked this algorithm to stop. vtkAlgorithm::CheckAbort, which also asks the algorithms
/// upstream, came on the way from VTK 9.2 to 9.3.
inline bool InkCheckAbort(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/// How many values an array has memory for. VTK 9.7 renamed it.
inline vtkIdType InkGetCapacity(vtkAbstractArray* array)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
  return array->GetCapacity();
#else
  return array->GetSize();
#endif
}

/// Gives an array memory for so many tuples, or more, and keeps what is in it.
inline void InkReserveTuples(vtkAbstractArray* array, vtkIdType tuples)
{
  if (InkGetCapacity(array) < tuples * array->GetNumberOfComponents())
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
    array->ReserveTuples(tuples);
#else
    array->Resize(tuples);
#endif
  }
}

/// Whether a cell of a vtkUnstructuredGrid has faces of its own, as polyhedra. VTK 9.4 changed how they are
/// kept.
template <class Grid>
bool InkHasFaces(Grid* grid, vtkIdType cell)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  auto* faces = grid->GetPolyhedronFaceLocations();
  return faces && cell < faces->GetNumberOfCells() && faces->GetCellSize(cell) > 0;
#else
  auto* faces = grid->GetFaceLocations();
  return faces && cell < faces->GetNumberOfValues() && faces->GetValue(cell) >= 0;
#endif
}

#endif
