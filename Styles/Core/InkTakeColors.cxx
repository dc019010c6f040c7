// SPDX-License-Identifier: BSD-3-Clause
#include "InkTakeColors.h"

#include "vtkInkIsoSurfaceSampler.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace
{

vtkSmartPointer<vtkDataArray> Interpolated(vtkImageData* image, vtkDataArray* colors, vtkPolyData* points)
{
  const auto named = vtkSmartPointer<vtkDataArray>::Take(colors->NewInstance());
  named->ShallowCopy(colors);
  named->SetName(InkColorsName);
  vtkNew<vtkImageData> source;
  source->CopyStructure(image);
  source->GetPointData()->SetScalars(named);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(points);
  probe->SetSourceData(source);
  probe->Update();
  return probe->GetOutput()->GetPointData()->GetArray(InkColorsName);
}

/// Of labels: from where the nearest voxel is at or above the iso-value, as smoothing moves surfaces.
vtkSmartPointer<vtkDataArray> FromWithin(
  vtkImageData* image, vtkDataArray* colors, double isoValue, vtkPolyData* points)
{
  vtkDataArray* labels = image->GetPointData()->GetScalars();
  vtkDataArray* normals = points->GetPointData()->GetNormals();
  const double* spacing = image->GetSpacing();
  const double voxel = std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  const auto taken = vtkSmartPointer<vtkDataArray>::Take(colors->NewInstance());
  taken->SetName(InkColorsName);
  taken->SetNumberOfComponents(colors->GetNumberOfComponents());
  taken->SetNumberOfTuples(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    vtkIdType nearest = -1;
    for (const double depth : { 0.5, 1.0, 1.5, 2.0, 3.0 })
    {
      double at[3];
      points->GetPoint(i, at);
      for (int axis = 0; normals && axis < 3; ++axis)
      {
        at[axis] -= depth * voxel * normals->GetComponent(i, axis);
      }
      const vtkIdType found = image->FindPoint(at);
      nearest = found < 0 ? nearest : found;
      if (found >= 0 && labels->GetComponent(found, 0) >= isoValue)
      {
        break;
      }
    }
    taken->SetTuple(i, std::max<vtkIdType>(nearest, 0), colors);
  }
  return taken;
}

} // namespace

void InkTakeColors(
  vtkImageData* image, const std::string& array, vtkInkIsoSurfaceSampler* sampler, vtkPolyData* points)
{
  vtkPointData* data = image->GetPointData();
  vtkDataArray* colors = array.empty() ? data->GetScalars() : data->GetArray(array.c_str());
  if (colors && points->GetNumberOfPoints() > 0)
  {
    points->GetPointData()->SetScalars(sampler->GetLabelMap()
        ? FromWithin(image, colors, sampler->GetValue(0), points)
        : Interpolated(image, colors, points));
  }
}
