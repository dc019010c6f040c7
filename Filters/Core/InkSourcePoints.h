// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSourcePoints_h
#define InkSourcePoints_h

#include "InkAllocate.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <vector>

/// The point array of a mesh with more points than the one it was made of, whose points come first: the id of
/// the point there that each is, or is near to. Selection finds these.
inline constexpr const char* InkSourcePointsName = "InkSourcePointIds";

/// Null where a mesh has the points that it was made of.
inline vtkIdTypeArray* InkGetSourcePoints(vtkPolyData* mesh)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray(InkSourcePointsName));
  const bool fits =
    ids && ids->GetNumberOfComponents() == 1 && ids->GetNumberOfTuples() == mesh->GetNumberOfPoints();
  return fits ? ids : nullptr;
}

/// @param sources of InkGetSourcePoints
inline vtkIdType InkSourcePoint(vtkIdTypeArray* sources, vtkIdType point)
{
  return sources ? sources->GetValue(point) : point;
}

/// @param output has the points of the mesh, then one for each of further
/// @param mesh what it was made of, itself perhaps of another one
/// @param further for each further point an earlier one of the output
inline void InkSetSourcePoints(vtkPolyData* output, vtkPolyData* mesh, const std::vector<vtkIdType>& further)
{
  vtkIdTypeArray* before = InkGetSourcePoints(mesh);
  const vtkIdType own = mesh->GetNumberOfPoints();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(InkSourcePointsName);
  InkSetNumberOfTuples(ids, own + static_cast<vtkIdType>(further.size()));
  for (vtkIdType i = 0; i < own; ++i)
  {
    ids->SetValue(i, InkSourcePoint(before, i));
  }
  for (std::size_t i = 0; i < further.size(); ++i)
  {
    ids->SetValue(own + static_cast<vtkIdType>(i), ids->GetValue(further[i]));
  }
  output->GetPointData()->AddArray(ids);
}

#endif
