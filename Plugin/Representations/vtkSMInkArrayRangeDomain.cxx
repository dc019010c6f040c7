// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkArrayRangeDomain.h"

#include "InkActiveScalars.h"
#include "InkChosenScalars.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMProperty.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkType.h"

vtkStandardNewMacro(vtkSMInkArrayRangeDomain);

namespace
{

/// The array that is drawn where none is chosen, see InkFirstValues; null if there is none.
const char* NameOfScalars(vtkPVDataSetAttributesInformation* attributes)
{
  if (const vtkPVArrayInformation* scalars =
        attributes->GetAttributeInformation(vtkDataSetAttributes::SCALARS))
  {
    return scalars->GetName();
  }
  const auto rankOf = [](vtkPVArrayInformation* array)
  { return InkRankOfArray(array->GetNumberOfComponents(), array->GetName()); };
  vtkPVArrayInformation* first = nullptr;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* array = attributes->GetArrayInformation(i);
    const bool isValues =
      array->GetName() && array->GetDataType() != VTK_STRING && !InkIsGhostArray(array->GetName());
    first = isValues && (!first || rankOf(array) < rankOf(first)) ? array : first;
  }
  return first ? first->GetName() : nullptr;
}

} // namespace

vtkSMInkArrayRangeDomain::vtkSMInkArrayRangeDomain() = default;

vtkSMInkArrayRangeDomain::~vtkSMInkArrayRangeDomain() = default;

void vtkSMInkArrayRangeDomain::Update(vtkSMProperty* property)
{
  vtkSMProperty* input = this->GetRequiredProperty("Input");
  vtkSMProperty* selection = this->GetRequiredProperty("ArraySelection");
  if (input && selection)
  {
    const vtkSMUncheckedPropertyHelper inputs(input);
    auto* source =
      inputs.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy()) : nullptr;
    constexpr unsigned int name = 4;
    if (source && InkChosenScalars(vtkSMUncheckedPropertyHelper(selection).GetAsString(name)).empty())
    {
      const int port = static_cast<int>(inputs.GetOutputPort());
      vtkPVDataInformation* information = source->GetDataInformation(inputs.GetOutputPort());
      for (const int association :
        { vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataObject::FIELD_ASSOCIATION_CELLS })
      {
        if (const char* array = NameOfScalars(information->GetAttributeInformation(association)))
        {
          this->Update(array, association, source, port);
          return;
        }
      }
    }
  }
  this->Superclass::Update(property);
}
