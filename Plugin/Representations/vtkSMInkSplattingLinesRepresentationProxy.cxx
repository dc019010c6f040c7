// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkSplattingLinesRepresentationProxy.h"

#include "vtkInkSplattingLinesStyle.h"
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkSplattingLinesRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkSplattingLinesRepresentationProxy::GetControls()
{
  static constexpr auto suggest = [](vtkSMProxy* proxy, const char* property)
  {
    constexpr const char* array = "LinesScalars";
    ChooseArray(proxy, array);
    vtkSMInkIsoValueInitializationHelper::SetSuggested(proxy, property, array);
  };
  static constexpr Start starts[] = { { "LinesAutomaticIsoValue", 0, "LinesIsoValue", suggest, 0 } };
  static constexpr Controls controls{ "Lines", "", {}, starts };
  return controls;
}

vtkSMInkSplattingLinesRepresentationProxy::vtkSMInkSplattingLinesRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkSplattingLinesStyle>::New(), GetControls())
{
}

vtkSMInkSplattingLinesRepresentationProxy::~vtkSMInkSplattingLinesRepresentationProxy() = default;
