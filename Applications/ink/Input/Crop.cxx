// SPDX-License-Identifier: BSD-3-Clause
#include "Crop.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "InkHasPolygons.h"
#include "Input.h"

#include "vtkBox.h"
#include "vtkClipPolyData.h"
#include "vtkExtractVOI.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace ink::cli
{
namespace
{

[[noreturn]] void failWithNothing(const double bounds[6])
{
  throw Failure("--crop: nothing lies in the box; the data is from " + formatNumber(bounds[0]) + " to " +
    formatNumber(bounds[1]) + " in x, " + formatNumber(bounds[2]) + " to " + formatNumber(bounds[3]) +
    " in y and " + formatNumber(bounds[4]) + " to " + formatNumber(bounds[5]) + " in z");
}

/// The voxels whose middles lie in the box, or, of an oblique volume, in the box of voxels around it.
vtkSmartPointer<vtkImageData> cropImage(vtkImageData* image, const std::array<double, 6>& box)
{
  double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
  double high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double point[3] = { box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2)] };
    double index[3];
    image->TransformPhysicalPointToContinuousIndex(point, index);
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], index[axis]);
      high[axis] = std::max(high[axis], index[axis]);
    }
  }
  const int* whole = image->GetExtent();
  int part[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    // A border that was meant to be a voxel's middle is one.
    constexpr double rounding = 1e-6;
    const double first = std::max<double>(std::ceil(low[axis] - rounding), whole[2 * axis]);
    const double last = std::min<double>(std::floor(high[axis] + rounding), whole[2 * axis + 1]);
    if (first > last)
    {
      failWithNothing(image->GetBounds());
    }
    part[2 * axis] = static_cast<int>(first);
    part[2 * axis + 1] = static_cast<int>(last);
  }
  vtkNew<vtkExtractVOI> extract;
  extract->SetInputData(image);
  extract->SetVOI(part);
  extract->Update();
  // An image of its own, whose voxels are counted from zero.
  double origin[3];
  image->TransformIndexToPhysicalPoint(part[0], part[2], part[4], origin);
  auto cropped = vtkSmartPointer<vtkImageData>::New();
  cropped->ShallowCopy(extract->GetOutput());
  cropped->SetExtent(0, part[1] - part[0], 0, part[3] - part[2], 0, part[5] - part[4]);
  cropped->SetOrigin(origin);
  return cropped;
}

vtkSmartPointer<vtkPolyData> cropMesh(vtkPolyData* mesh, const std::array<double, 6>& box)
{
  auto cropped = vtkSmartPointer<vtkPolyData>::New();
  if (InkHasPolygons(mesh))
  {
    vtkNew<vtkBox> inside;
    inside->SetBounds(box.data());
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(mesh);
    clip->SetClipFunction(inside);
    clip->InsideOutOn();
    clip->Update();
    cropped->ShallowCopy(clip->GetOutput());
  }
  else
  {
    vtkNew<vtkIdList> kept;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      if (p[0] >= box[0] && p[0] <= box[1] && p[1] >= box[2] && p[1] <= box[3] && p[2] >= box[4] &&
        p[2] <= box[5])
      {
        kept->InsertNextId(i);
      }
    }
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType());
    mesh->GetPoints()->GetPoints(kept, points);
    cropped->SetPoints(points);
    cropped->GetPointData()->CopyAllocate(mesh->GetPointData(), kept->GetNumberOfIds());
    cropped->GetPointData()->CopyData(mesh->GetPointData(), kept);
  }
  if (cropped->GetNumberOfPoints() == 0)
  {
    failWithNothing(mesh->GetBounds());
  }
  return cropped;
}

} // namespace

void crop(Input& input, const std::array<double, 6>& box)
{
  if (auto* image = vtkImageData::SafeDownCast(input.data))
  {
    input.data = cropImage(image, box);
  }
  else if (auto* mesh = vtkPolyData::SafeDownCast(input.data))
  {
    input.data = cropMesh(mesh, box);
  }
  else
  {
    throw Failure("--crop needs the whole volume at once: expected a larger --memory");
  }
}

} // namespace ink::cli
