// SPDX-License-Identifier: BSD-3-Clause
#include "InkSubsample.h"

#include "Core/ParallelFor.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstddef>

namespace
{

/// Of how many points or cells along each axis which are taken.
struct Lattice
{
  std::array<int, 3> Size;
  std::array<std::vector<int>, 3> Indices;

  vtkIdType CountAll() const { return vtkIdType{ this->Size[0] } * this->Size[1] * this->Size[2]; }
  vtkIdType CountTaken() const
  {
    return static_cast<vtkIdType>(
      this->Indices[0].size() * this->Indices[1].size() * this->Indices[2].size());
  }

  /// Of an axis of points the cells in the middle between those taken; a cell without extent along others.
  Lattice OfCells() const
  {
    Lattice cells;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::vector<int>& points = this->Indices[axis];
      cells.Size[axis] = std::max(this->Size[axis] - 1, 1);
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        cells.Indices[axis].push_back((points[i - 1] + points[i]) / 2);
      }
      if (points.size() == 1)
      {
        cells.Indices[axis].push_back(std::min(points[0], cells.Size[axis] - 1));
      }
    }
    return cells;
  }
};

struct TakeTuples
{
  const Lattice& Taken;
  bool InParallel; ///< not where several values share a byte

  template <class Array>
  void operator()(Array* from, vtkDataArray* to) const
  {
    const auto source = vtk::DataArrayTupleRange(from);
    auto target = vtk::DataArrayTupleRange(Array::FastDownCast(to));
    // No structured binding, which Clang before 16 does not let lambdas capture.
    const std::vector<int>& xs = this->Taken.Indices[0];
    const std::vector<int>& ys = this->Taken.Indices[1];
    const std::vector<int>& zs = this->Taken.Indices[2];
    const auto columns = static_cast<vtkIdType>(xs.size());
    const auto rows = static_cast<vtkIdType>(ys.size());
    const auto takeSlice = [&](std::size_t z)
    {
      vtkIdType tuple = static_cast<vtkIdType>(z) * rows * columns;
      for (const int y : ys)
      {
        const vtkIdType row = (static_cast<vtkIdType>(zs[z]) * this->Taken.Size[1] + y) * this->Taken.Size[0];
        for (const int x : xs)
        {
          target[tuple++] = source[row + x];
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

void TakeArrays(const Lattice& taken, vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    if (!array || array->GetNumberOfTuples() < taken.CountAll())
    {
      continue;
    }
    const auto some = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    some->SetName(array->GetName());
    some->SetNumberOfComponents(array->GetNumberOfComponents());
    some->CopyComponentNames(array);
    some->SetNumberOfTuples(taken.CountTaken());
    const TakeTuples take{ taken, array->GetDataType() != VTK_BIT };
    if (!vtkArrayDispatch::Dispatch::Execute(array, take, some.Get()))
    {
      take(array, some.Get());
    }
    to->AddArray(some);
    if (array == from->GetScalars())
    {
      to->SetScalars(some);
    }
  }
}

} // namespace

vtkSmartPointer<vtkImageData> InkSubsample(vtkImageData* image, const std::array<InkSubsampledAxis, 3>& axes)
{
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
  const int* size = image->GetDimensions();
  const Lattice points{ { size[0], size[1], size[2] },
    { axes[0].Indices, axes[1].Indices, axes[2].Indices } };
  TakeArrays(points, image->GetPointData(), result->GetPointData());
  TakeArrays(points.OfCells(), image->GetCellData(), result->GetCellData());
  return result;
}
