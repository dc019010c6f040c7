// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkStippleRepresentationProxy.h"

#include "vtkInkStippleStyle.h"
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"

vtkStandardNewMacro(vtkSMInkStippleRepresentationProxy);

namespace
{

constexpr const char* ArrayProperty = "StippleBy";

} // namespace

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkStippleRepresentationProxy::GetControls()
{
  static constexpr const char* sliders[] = { "StippleGradient", "StippleSharpness", "StippleOrientation",
    "StippleDistance", "StippleInterior", "StippleColor" };
  static constexpr Start starts[] = {
    { "UseScalarWindow", 1, "ScalarWindow",
      [](vtkSMProxy* proxy, const char* property)
      {
        ChooseArray(proxy, ArrayProperty);
        proxy->GetProperty(property)->ResetToDomainDefaults();
      } },
    { "StippleSource", vtkInkStippleStyle::ISO_SURFACE, "StippleIsoValue",
      [](vtkSMProxy* proxy, const char* property)
      {
        ChooseArray(proxy, ArrayProperty);
        vtkSMInkIsoValueInitializationHelper::SetSuggested(proxy, property, ArrayProperty);
      } },
  };
  static constexpr Controls controls{ "Stipple", "StipplePreset", sliders, starts };
  return controls;
}

vtkSMInkStippleRepresentationProxy::vtkSMInkStippleRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkStippleStyle>::New(), GetControls())
{
}

vtkSMInkStippleRepresentationProxy::~vtkSMInkStippleRepresentationProxy() = default;
