// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkContoursRepresentationProxy.h"

#include "vtkInkContoursStyle.h"
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkContoursRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkContoursRepresentationProxy::GetControls()
{
  static constexpr auto suggest = [](vtkSMProxy* proxy, const char* property)
  {
    constexpr const char* array = "ContoursScalars";
    ChooseArray(proxy, array);
    vtkSMInkIsoValueInitializationHelper::SetSuggested(proxy, property, array);
  };
  static constexpr Start starts[] = { { "ContoursAutomaticIsoValue", 0, "ContoursIsoValue", suggest } };
  static constexpr Controls controls{ "Contours", "ContoursPreset", {}, starts };
  return controls;
}

vtkSMInkContoursRepresentationProxy::vtkSMInkContoursRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkContoursStyle>::New(), GetControls())
{
}

vtkSMInkContoursRepresentationProxy::~vtkSMInkContoursRepresentationProxy() = default;
