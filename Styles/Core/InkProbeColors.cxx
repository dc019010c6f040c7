// SPDX-License-Identifier: BSD-3-Clause
#include "InkProbeColors.h"

#include "vtkInkIsoSurfaceSampler.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

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

/// The voxel nearest to a point of those at or above a value: among the corners of its cell or, as smoothing
/// moves surfaces, some voxels around; else the nearest one.
vtkIdType FindInside(vtkImageData* image, vtkDataArray* labels, double isoValue, double point[3])
{
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(point, index);
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  vtkIdType nearest = -1;
  for (int around = 0; around < 4 && nearest < 0; ++around)
  {
    int begin[3];
    int end[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int cell = static_cast<int>(std::floor(index[axis]));
      begin[axis] = std::clamp(cell - around, extent[2 * axis], extent[2 * axis + 1]);
      end[axis] = std::clamp(cell + 1 + around, extent[2 * axis], extent[2 * axis + 1]);
    }
    double least = std::numeric_limits<double>::infinity();
    int at[3];
    for (at[2] = begin[2]; at[2] <= end[2]; ++at[2])
    {
      for (at[1] = begin[1]; at[1] <= end[1]; ++at[1])
      {
        for (at[0] = begin[0]; at[0] <= end[0]; ++at[0])
        {
          const double distance = std::hypot(spacing[0] * (at[0] - index[0]), spacing[1] * (at[1] - index[1]),
            spacing[2] * (at[2] - index[2]));
          const vtkIdType id = image->ComputePointId(at);
          if (distance < least && labels->GetComponent(id, 0) >= isoValue)
          {
            least = distance;
            nearest = id;
          }
        }
      }
    }
  }
  return nearest >= 0 ? nearest : std::max<vtkIdType>(image->FindPoint(point), 0);
}

vtkSmartPointer<vtkDataArray> FromWithin(
  vtkImageData* image, vtkDataArray* colors, double isoValue, vtkPolyData* points)
{
  vtkDataArray* labels = image->GetPointData()->GetScalars();
  const auto taken = vtkSmartPointer<vtkDataArray>::Take(colors->NewInstance());
  taken->SetName(InkColorsName);
  taken->SetNumberOfComponents(colors->GetNumberOfComponents());
  taken->SetNumberOfTuples(points->GetNumberOfPoints());
  const auto take = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      double point[3];
      points->GetPoint(i, point);
      taken->SetTuple(i, FindInside(image, labels, isoValue, point), colors);
    }
  };
  vtkSMPTools::For(0, points->GetNumberOfPoints(), take);
  return taken;
}

/// Replaces labels by their order among those of an image at or above a value.
vtkSmartPointer<vtkDataArray> OrderOf(vtkDataArray* taken, vtkDataArray* labels, double isoValue)
{
  std::set<double> all;
  double last = std::numeric_limits<double>::quiet_NaN();
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    // Neighbors mostly have the same.
    const double label = labels->GetComponent(i, 0);
    if (label != last && label >= isoValue)
    {
      all.insert(label);
    }
    last = label;
  }
  std::map<double, float> orders;
  const float steps = std::max(static_cast<float>(all.size()) - 1.0F, 1.0F);
  for (const double label : all)
  {
    orders.emplace(label, static_cast<float>(orders.size()) / steps);
  }
  auto order = vtkSmartPointer<vtkFloatArray>::New();
  order->SetName(InkLabelOrderName);
  order->SetNumberOfValues(taken->GetNumberOfTuples());
  for (vtkIdType i = 0; i < taken->GetNumberOfTuples(); ++i)
  {
    order->SetValue(i, orders[taken->GetComponent(i, 0)]);
  }
  return order;
}

} // namespace

const char* InkFindColors(vtkDataSet* points)
{
  vtkPointData* data = points->GetPointData();
  return data->HasArray(InkColorsName)  ? InkColorsName
    : data->HasArray(InkLabelOrderName) ? InkLabelOrderName
                                        : nullptr;
}

void InkProbeColors(vtkImageData* image, const std::string& array, bool inOrder,
  vtkInkIsoSurfaceSampler* sampler, vtkPolyData* points)
{
  vtkPointData* data = image->GetPointData();
  vtkDataArray* drawn = data->GetScalars();
  vtkDataArray* colors = array.empty() ? drawn : data->GetArray(array.c_str());
  if (!colors || points->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkPointData* ofPoints = points->GetPointData();
  if (!sampler->GetLabelMap())
  {
    ofPoints->SetScalars(Interpolated(image, colors, points));
    return;
  }
  const double isoValue = sampler->GetValue(0);
  const vtkSmartPointer<vtkDataArray> taken = FromWithin(image, colors, isoValue, points);
  ofPoints->SetScalars(inOrder && colors == drawn ? OrderOf(taken, drawn, isoValue) : taken);
}
