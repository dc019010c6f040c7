// SPDX-License-Identifier: BSD-3-Clause
#include "InkContourLines.h"

#include "InkAllocate.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{

/// Adds an array with one value per point, if there are any.
template <class Array, class Values, class Convert>
void AddArray(const char* name, const Values& values, vtkPolyData* output, const Convert& convert)
{
  if (values.empty())
  {
    return;
  }
  vtkNew<Array> array;
  array->SetName(name);
  InkSetNumberOfTuples(array, static_cast<vtkIdType>(values.size()));
  std::transform(values.begin(), values.end(), array->GetPointer(0), convert);
  output->GetPointData()->AddArray(array);
}

} // namespace

void InkMakeContourLines(
  const ink::Contours& contours, int pointType, std::span<const vtkIdType> cellIds, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  InkSetNumberOfPoints(points, static_cast<vtkIdType>(contours.positions.size()));
  for (std::size_t i = 0; i < contours.positions.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), &contours.positions[i].x);
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> kinds;
  kinds->SetName("ContourKind");
  InkSetNumberOfTuples(kinds, static_cast<vtkIdType>(contours.kinds.size()));
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    const auto begin = static_cast<vtkIdType>(contours.chains.offsets[chain]);
    const auto end = static_cast<vtkIdType>(contours.chains.offsets[chain + 1]);
    const bool closed = contours.chains.closed[chain] != 0;
    lines->InsertNextCell(static_cast<int>(end - begin + (closed ? 1 : 0)));
    for (vtkIdType point = begin; point < end; ++point)
    {
      lines->InsertCellPoint(point);
    }
    if (closed)
    {
      lines->InsertCellPoint(begin);
    }
    kinds->SetValue(static_cast<vtkIdType>(chain), static_cast<unsigned char>(contours.kinds[chain]));
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(kinds);

  if (!contours.normals.empty())
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    InkSetNumberOfTuples(normals, static_cast<vtkIdType>(contours.normals.size()));
    for (std::size_t i = 0; i < contours.normals.size(); ++i)
    {
      normals->SetTypedTuple(static_cast<vtkIdType>(i), &contours.normals[i].x);
    }
    output->GetPointData()->SetNormals(normals);
  }
  const auto same = [](auto value) { return value; };
  AddArray<vtkFloatArray>("RadialCurvature", contours.radialCurvature, output, same);
  AddArray<vtkDoubleArray>("ArcLength", contours.arcLength, output, same);
  AddArray<vtkIdTypeArray>("CellId", contours.elements, output,
    [&](std::int64_t element) {
      return cellIds.empty() ? static_cast<vtkIdType>(element) : cellIds[static_cast<std::size_t>(element)];
    });
}
