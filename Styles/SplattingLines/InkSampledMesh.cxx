// SPDX-License-Identifier: BSD-3-Clause
#include "InkSampledMesh.h"

#include "InkSampleFaces.h"
#include "InkSourcePoints.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>

namespace
{

/// Values of points of the array to color by; null if there is none.
vtkSmartPointer<vtkDataArray> FindPointColors(vtkPolyData* points, const InkColorArray& colors)
{
  vtkDataArray* ofPoints = points->GetPointData()->GetArray(colors.Name.c_str());
  vtkDataArray* ofCells = points->GetCellData()->GetArray(colors.Name.c_str());
  if (!colors.OfCells || !ofCells)
  {
    return colors.OfCells ? nullptr : ofPoints;
  }
  vtkNew<vtkPolyData> cells;
  cells->CopyStructure(points);
  cells->GetCellData()->AddArray(ofCells);
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(cells);
  toPoints->Update();
  return toPoints->GetOutput()->GetPointData()->GetArray(colors.Name.c_str());
}

} // namespace

vtkSmartPointer<vtkPolyData> InkKnowPoints(vtkPolyData* points, const InkColorArray& colors)
{
  auto known = vtkSmartPointer<vtkPolyData>::New();
  known->ShallowCopy(points);
  InkSetSourcePoints(known, points, {});
  known->GetPointData()->SetActiveScalars(nullptr);
  if (const vtkSmartPointer<vtkDataArray> values = FindPointColors(points, colors))
  {
    auto named = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
    named->ShallowCopy(values);
    named->SetName(InkColorsName);
    known->GetPointData()->SetScalars(named);
  }
  return known;
}

void InkKnowFaces(vtkPolyData* mesh, const InkColorArray& colors, vtkPolyData* samples)
{
  vtkPointData* data = samples->GetPointData();
  auto* faces = vtkIdTypeArray::SafeDownCast(data->GetArray("FaceId"));
  auto* corners = vtkIdTypeArray::SafeDownCast(data->GetArray("FacePoints"));
  vtkDataArray* weights = data->GetArray("BarycentricCoordinates");
  if (!faces || !corners || !weights)
  {
    return; // none were made
  }
  const vtkIdType count = samples->GetNumberOfPoints();
  vtkDataArray* values = colors.OfCells ? mesh->GetCellData()->GetArray(colors.Name.c_str())
                                        : mesh->GetPointData()->GetArray(colors.Name.c_str());
  vtkSmartPointer<vtkDataArray> taken;
  if (values)
  {
    taken.TakeReference(values->NewInstance());
    taken->SetName(InkColorsName);
    taken->SetNumberOfComponents(values->GetNumberOfComponents());
    taken->SetNumberOfTuples(count);
  }
  vtkIdTypeArray* before = InkGetSourcePoints(mesh);
  vtkNew<vtkIdTypeArray> sources;
  sources->SetName(InkSourcePointsName);
  sources->SetNumberOfTuples(count);
  vtkNew<vtkIdList> face;
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::array<vtkIdType, 3> ids;
    corners->GetTypedTuple(i, ids.data());
    std::array<double, 3> shares;
    weights->GetTuple(i, shares.data());
    const auto nearest = std::max_element(shares.begin(), shares.end()) - shares.begin();
    sources->SetValue(i, InkSourcePoint(before, ids[static_cast<std::size_t>(nearest)]));
    if (taken && colors.OfCells)
    {
      taken->SetTuple(i, faces->GetValue(i), values);
    }
    else if (taken)
    {
      face->Reset();
      for (const vtkIdType id : ids)
      {
        face->InsertNextId(id);
      }
      taken->InterpolateTuple(i, face, values, shares.data());
    }
  }
  InkRemoveFaces(samples);
  data->AddArray(sources);
  data->SetScalars(taken);
}
