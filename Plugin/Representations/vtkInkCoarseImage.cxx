// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkCoarseImage.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

std::array<int, 3> CountPoints(vtkImageData* image, const std::array<int, 3>& strides)
{
  const int* points = image->GetDimensions();
  std::array<int, 3> taken;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    taken[axis] = (points[axis] - 1) / strides[axis] + 1;
  }
  return taken;
}

/// How many points further the next one is along each axis: as evenly spaced in the world as that goes.
std::array<int, 3> FindStrides(vtkImageData* image, vtkIdType mostPoints)
{
  std::array<double, 3> spacing;
  std::transform(image->GetSpacing(), image->GetSpacing() + 3, spacing.begin(),
    [](double step) { return step != 0.0 ? std::abs(step) : 1.0; });
  const double finest = *std::min_element(spacing.begin(), spacing.end());
  const int longest = *std::max_element(image->GetDimensions(), image->GetDimensions() + 3);
  std::array strides{ 1, 1, 1 };
  for (int apart = 1; apart <= longest; ++apart)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      strides[axis] = std::max(1, static_cast<int>(std::lround(apart * finest / spacing[axis])));
    }
    const auto [x, y, z] = CountPoints(image, strides);
    if (vtkIdType{ x } * y * z <= mostPoints)
    {
      break;
    }
  }
  return strides;
}

/// Copies what stands at every so many-th point; on all threads, where vtkExtractVOI takes a second.
struct TakePoints
{
  const int* Points;
  const std::array<int, 3>& Taken;
  const std::array<int, 3>& Strides;

  template <class Array>
  void operator()(Array* from, vtkDataArray* to) const
  {
    const auto source = vtk::DataArrayTupleRange(from);
    auto target = vtk::DataArrayTupleRange(Array::FastDownCast(to));
    const auto takeSlices = [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType z = begin; z < end; ++z)
      {
        for (vtkIdType y = 0; y < this->Taken[1]; ++y)
        {
          const vtkIdType row =
            (z * this->Strides[2] * this->Points[1] + y * this->Strides[1]) * this->Points[0];
          const vtkIdType targetRow = (z * this->Taken[1] + y) * this->Taken[0];
          for (vtkIdType x = 0; x < this->Taken[0]; ++x)
          {
            target[targetRow + x] = source[row + x * this->Strides[0]];
          }
        }
      }
    };
    vtkSMPTools::For(0, this->Taken[2], takeSlices);
  }
};

} // namespace

vtkSmartPointer<vtkImageData> vtkInkCoarseImage(vtkImageData* image, vtkIdType mostPoints)
{
  const std::array strides = FindStrides(image, mostPoints);
  if (strides == std::array{ 1, 1, 1 } || image->GetCellData()->GetNumberOfArrays() > 0)
  {
    return image;
  }
  const std::array taken = CountPoints(image, strides);
  const double* spacing = image->GetSpacing();
  const int* extent = image->GetExtent();
  double origin[3];
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], origin);
  auto coarse = vtkSmartPointer<vtkImageData>::New();
  coarse->SetDimensions(taken.data());
  coarse->SetSpacing(spacing[0] * strides[0], spacing[1] * strides[1], spacing[2] * strides[2]);
  coarse->SetOrigin(origin);
  coarse->SetDirectionMatrix(image->GetDirectionMatrix());
  const TakePoints take{ image->GetDimensions(), taken, strides };
  vtkPointData* from = image->GetPointData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    if (!array)
    {
      continue; // of texts
    }
    const auto fewer = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    fewer->SetName(array->GetName());
    fewer->SetNumberOfComponents(array->GetNumberOfComponents());
    fewer->CopyComponentNames(array);
    fewer->SetNumberOfTuples(coarse->GetNumberOfPoints());
    if (!vtkArrayDispatch::Dispatch::Execute(array, take, fewer.Get()))
    {
      take(array, fewer.Get());
    }
    coarse->GetPointData()->AddArray(fewer);
    if (array == from->GetScalars())
    {
      coarse->GetPointData()->SetScalars(fewer);
    }
  }
  return coarse;
}
