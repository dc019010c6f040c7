// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkStippleRepresentationProxy.h"

#include "vtkInkStippleStyle.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkStippleRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkStippleRepresentationProxy::GetControls()
{
  static constexpr const char* sliders[] = { "StippleGradient", "StippleSharpness", "StippleOrientation",
    "StippleDistance", "StippleInterior", "StippleColor" };
  static constexpr Start starts[] = {
    { "UseScalarWindow", 1, "ScalarWindow", RANGE },
    { "StippleSource", vtkInkStippleStyle::ISO_SURFACE, "StippleIsoValue", ISO_VALUE },
  };
  static constexpr Controls controls{ "Stipple", "StipplePreset", "StippleBy", sliders, starts };
  return controls;
}

vtkSMInkStippleRepresentationProxy::vtkSMInkStippleRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkStippleStyle>::New(), GetControls())
{
}

vtkSMInkStippleRepresentationProxy::~vtkSMInkStippleRepresentationProxy() = default;
