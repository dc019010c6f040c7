// SPDX-License-Identifier: BSD-3-Clause
#include "InkSubsample.h"

#include "Core/ParallelFor.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

namespace
{

struct TakePoints
{
  const int* Dimensions;
  const std::array<InkSubsampledAxis, 3>& Axes;
  bool InParallel; ///< not where several values share a byte

  template <class Array>
  void operator()(Array* from, vtkDataArray* to) const
  {
    const auto source = vtk::DataArrayTupleRange(from);
    auto target = vtk::DataArrayTupleRange(Array::FastDownCast(to));
    // No structured binding, which Clang before 16 does not let lambdas capture.
    const std::vector<int>& xs = this->Axes[0].Indices;
    const std::vector<int>& ys = this->Axes[1].Indices;
    const std::vector<int>& zs = this->Axes[2].Indices;
    const auto columns = static_cast<vtkIdType>(xs.size());
    const auto rows = static_cast<vtkIdType>(ys.size());
    const auto takeSlice = [&](std::size_t z)
    {
      vtkIdType point = static_cast<vtkIdType>(z) * rows * columns;
      for (const int y : ys)
      {
        const vtkIdType row = (static_cast<vtkIdType>(zs[z]) * this->Dimensions[1] + y) * this->Dimensions[0];
        for (const int x : xs)
        {
          target[point++] = source[row + x];
        }
      }
    };
    if (this->InParallel)
    {
      ink::parallelFor(zs.size(), takeSlice);
      return;
    }
    for (std::size_t z = 0; z < zs.size(); ++z)
    {
      takeSlice(z);
    }
  }
};

} // namespace

vtkSmartPointer<vtkImageData> InkSubsample(vtkImageData* image, const std::array<InkSubsampledAxis, 3>& axes)
{
  if (image->GetCellData()->GetNumberOfArrays() > 0)
  {
    return image;
  }
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  double origin[3];
  image->TransformContinuousIndexToPhysicalPoint(
    extent[0] + axes[0].First, extent[2] + axes[1].First, extent[4] + axes[2].First, origin);
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(static_cast<int>(axes[0].Indices.size()), static_cast<int>(axes[1].Indices.size()),
    static_cast<int>(axes[2].Indices.size()));
  result->SetSpacing(spacing[0] * axes[0].Step, spacing[1] * axes[1].Step, spacing[2] * axes[2].Step);
  result->SetOrigin(origin);
  result->SetDirectionMatrix(image->GetDirectionMatrix());
  result->GetFieldData()->ShallowCopy(image->GetFieldData());
  vtkPointData* from = image->GetPointData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    if (!array || array->GetNumberOfTuples() < image->GetNumberOfPoints())
    {
      continue;
    }
    const auto some = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    some->SetName(array->GetName());
    some->SetNumberOfComponents(array->GetNumberOfComponents());
    some->CopyComponentNames(array);
    some->SetNumberOfTuples(result->GetNumberOfPoints());
    const TakePoints take{ image->GetDimensions(), axes, array->GetDataType() != VTK_BIT };
    if (!vtkArrayDispatch::Dispatch::Execute(array, take, some.Get()))
    {
      take(array, some.Get());
    }
    result->GetPointData()->AddArray(some);
    if (array == from->GetScalars())
    {
      result->GetPointData()->SetScalars(some);
    }
  }
  return result;
}
