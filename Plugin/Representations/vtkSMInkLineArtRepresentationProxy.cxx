// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkLineArtRepresentationProxy.h"

#include "vtkInkLineArtStyle.h"
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkLineArtRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkLineArtRepresentationProxy::GetControls()
{
  static constexpr auto suggest = [](vtkSMProxy* proxy, const char* property)
  {
    constexpr const char* array = "LineArtScalars";
    ChooseArray(proxy, array);
    vtkSMInkIsoValueInitializationHelper::SetSuggested(proxy, property, array);
  };
  static constexpr Start starts[] = { { "LineArtAutomaticIsoValue", 0, "LineArtIsoValue", suggest, 0 } };
  static constexpr Controls controls{ "LineArt", "LineArtPreset", {}, starts };
  return controls;
}

vtkSMInkLineArtRepresentationProxy::vtkSMInkLineArtRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkLineArtStyle>::New(), GetControls())
{
}

vtkSMInkLineArtRepresentationProxy::~vtkSMInkLineArtRepresentationProxy() = default;
