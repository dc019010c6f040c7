// SPDX-License-Identifier: BSD-3-Clause
#include "InkMakeMask.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <cmath>

namespace
{

struct MaskLabels
{
  template <class Labels, class Mask>
  void operator()(Labels* labels, Mask* mask, double isoValue) const
  {
    using Value = vtk::GetAPIType<Labels>;
    const auto from = vtk::DataArrayValueRange<1>(labels);
    auto to = vtk::DataArrayValueRange<1>(mask);
    std::transform(from.cbegin(), from.cend(), to.begin(),
      [isoValue](Value label)
      {
        const auto value = static_cast<double>(label);
        return std::isfinite(value) ? static_cast<Value>(value >= isoValue) : label;
      });
  }
};

} // namespace

vtkSmartPointer<vtkDataArray> InkMakeMask(vtkDataArray* labels, double isoValue)
{
  auto mask = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(labels->GetDataType()));
  mask->SetNumberOfTuples(labels->GetNumberOfTuples());
  const MaskLabels fill;
  if (!vtkArrayDispatch::Dispatch2SameValueType::Execute(labels, mask, fill, isoValue))
  {
    fill(labels, mask.Get(), isoValue);
  }
  return mask;
}
