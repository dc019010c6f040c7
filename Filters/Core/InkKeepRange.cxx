// SPDX-License-Identifier: BSD-3-Clause
#include "InkKeepRange.h"

#include "InkWithValues.h"
#include "Statistics/FiniteRange.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

#include <array>

namespace
{

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
  if (array->GetNumberOfComponents() != 1 || !array->HasStandardMemoryLayout())
  {
    return;
  }
  const ink::FiniteRange found =
    InkWithValues(array, [](auto values) { return ink::findFiniteRange(values); });
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
