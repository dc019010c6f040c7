// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "InkChosenScalars.h"
#include "vtkPVInkIsoValueInformation.h"

#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProcessModule.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMInkIsoValueInitializationHelper);

namespace
{

/// The value that the processes of a proxy agree on.
std::optional<double> Gather(vtkSMProxy* proxy, vtkPVInkIsoValueInformation* information)
{
  proxy->GatherInformation(information);
  if (vtkProcessModule::GetSymmetricMPIMode())
  {
    information->Share(vtkMultiProcessController::GetGlobalController());
  }
  return information->GetFound() ? std::optional<double>(information->GetValue()) : std::nullopt;
}

} // namespace

vtkSMInkIsoValueInitializationHelper::vtkSMInkIsoValueInitializationHelper() = default;

vtkSMInkIsoValueInitializationHelper::~vtkSMInkIsoValueInitializationHelper() = default;

void vtkSMInkIsoValueInitializationHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType since)
{
  constexpr const char* arrayProperty = "SelectInputScalars";
  vtkSMProperty* values = proxy->GetProperty("ContourValues");
  vtkSMProperty* array = proxy->GetProperty(arrayProperty);
  if (!values || !array || values->GetMTime() > since)
  {
    return;
  }
  if (array->GetMTime() <= since)
  {
    array->ResetToDomainDefaults();
  }
  if (const std::optional<double> value = Suggest(proxy, arrayProperty))
  {
    vtkSMPropertyHelper(values).Set(0, *value);
    proxy->UpdateVTKObjects();
  }
}

std::optional<double> vtkSMInkIsoValueInitializationHelper::Suggest(
  vtkSMProxy* proxy, const char* arrayProperty)
{
  const vtkSMPropertyHelper inputs(proxy, "Input");
  auto input =
    inputs.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy()) : nullptr;
  if (!input)
  {
    return std::nullopt;
  }
  input->UpdatePipeline();
  vtkNew<vtkPVInkIsoValueInformation> information;
  information->SetPort(static_cast<int>(inputs.GetOutputPort()));
  const vtkSMPropertyHelper array(proxy, arrayProperty);
  constexpr unsigned int name = 4;
  if (array.GetNumberOfElements() > name)
  {
    information->SetArrayName(InkChosenScalars(array.GetAsString(name)));
  }
  return Gather(input, information);
}

std::optional<double> vtkSMInkIsoValueInitializationHelper::FindUsed(vtkSMProxy* representation, int surface)
{
  vtkNew<vtkPVInkIsoValueInformation> information;
  information->SetPort(surface);
  return Gather(representation, information);
}
