// SPDX-License-Identifier: BSD-3-Clause
#include "InkKeepRange.h"

#include "Statistics/FiniteRange.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

#include <array>
#include <cstddef>
#include <span>

namespace
{

template <class T>
ink::FiniteRange RangeOf(vtkDataArray* array)
{
  auto* values = vtkAOSDataArrayTemplate<T>::FastDownCast(array);
  return values ? ink::findFiniteRange(std::span<const T>(
                    values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues())))
                : ink::FiniteRange();
}

void Keep(vtkDataArray* array, vtkInformationInformationVectorKey* key, const std::array<double, 2>& range)
{
  vtkNew<vtkInformationVector> components;
  components->SetNumberOfInformationObjects(1);
  components->GetInformationObject(0)->Set(vtkDataArray::COMPONENT_RANGE(), range.data(), 2);
  array->GetInformation()->Set(key, components);
}

} // namespace

void InkKeepRange(vtkDataArray* array)
{
  if (array->GetNumberOfComponents() != 1)
  {
    return;
  }
  ink::FiniteRange found;
  switch (array->GetDataType())
  {
    vtkTemplateMacro(found = RangeOf<VTK_TT>(array));
    default:
      break;
  }
  if (found.least > found.greatest)
  {
    return;
  }
  const std::array<double, 2> range{ found.least, found.greatest };
  Keep(array, vtkAbstractArray::PER_FINITE_COMPONENT(), range);
  if (found.notFinite == 0)
  {
    Keep(array, vtkAbstractArray::PER_COMPONENT(), range);
  }
}
