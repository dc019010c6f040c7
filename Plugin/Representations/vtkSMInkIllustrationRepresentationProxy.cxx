// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkIllustrationRepresentationProxy.h"

#include "vtkInkIllustrationStyle.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkIllustrationRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkIllustrationRepresentationProxy::GetControls()
{
  static constexpr Start starts[] = {
    { "IllustrationAutomaticIsoValue", 0, "IllustrationIsoValue", ISO_VALUE, 0 },
    { "IllustrationAutomaticOuterIsoValue", 0, "IllustrationOuterIsoValue", ISO_VALUE, 1 },
  };
  static constexpr Controls controls{ "Illustration", "IllustrationPreset", "IllustrationScalars", {},
    starts };
  return controls;
}

vtkSMInkIllustrationRepresentationProxy::vtkSMInkIllustrationRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkIllustrationStyle>::New(), GetControls())
{
}

vtkSMInkIllustrationRepresentationProxy::~vtkSMInkIllustrationRepresentationProxy() = default;
