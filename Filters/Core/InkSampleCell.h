// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSampleCell_h
#define InkSampleCell_h

#include "Fields/Grid/GridGeometry.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <optional>

/// The field array of an iso-surface's samples that holds the edges of the cells sampled, three world
/// vectors: with the normal it says how much surface a sample stands for (ink::isoSurfaceSampleArea).
inline constexpr const char* InkSampleCellName = "SampleCell";

/// Adds the array for samples of a grid's cells.
inline void InkSetSampleCell(vtkPolyData* samples, const ink::GridGeometry& cells)
{
  const glm::dmat3 edges = cells.stepToWorld();
  vtkNew<vtkDoubleArray> array;
  array->SetName(InkSampleCellName);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(3);
  std::copy_n(&edges[0].x, 9, array->GetPointer(0));
  samples->GetFieldData()->AddArray(array);
}

/// The edges as columns, world units; nothing if the points have no array of three vectors.
inline std::optional<glm::dmat3> InkGetSampleCell(vtkPolyData* points)
{
  vtkDataArray* array = points->GetFieldData()->GetArray(InkSampleCellName);
  if (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != 3)
  {
    return {};
  }
  glm::dmat3 edges;
  for (int axis = 0; axis < 3; ++axis)
  {
    array->GetTuple(axis, &edges[axis].x);
  }
  return edges;
}

#endif
