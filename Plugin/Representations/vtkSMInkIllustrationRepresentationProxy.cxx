// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkIllustrationRepresentationProxy.h"

#include "vtkInkIllustrationStyle.h"
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkIllustrationRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkIllustrationRepresentationProxy::GetControls()
{
  static constexpr auto suggest = [](vtkSMProxy* proxy, const char* property)
  {
    constexpr const char* array = "IllustrationScalars";
    ChooseArray(proxy, array);
    vtkSMInkIsoValueInitializationHelper::SetSuggested(proxy, property, array);
  };
  static constexpr Start starts[] = {
    { "IllustrationAutomaticIsoValue", 0, "IllustrationIsoValue", suggest, 0 },
    { "IllustrationAutomaticOuterIsoValue", 0, "IllustrationOuterIsoValue", suggest, 1 },
  };
  static constexpr Controls controls{ "Illustration", "IllustrationPreset", {}, starts };
  return controls;
}

vtkSMInkIllustrationRepresentationProxy::vtkSMInkIllustrationRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkIllustrationStyle>::New(), GetControls())
{
}

vtkSMInkIllustrationRepresentationProxy::~vtkSMInkIllustrationRepresentationProxy() = default;
