// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkSplattingLinesRepresentationProxy.h"

#include "vtkInkSplattingLinesStyle.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkSplattingLinesRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkSplattingLinesRepresentationProxy::GetControls()
{
  static constexpr Start starts[] = { { "LinesAutomaticIsoValue", 0, "LinesIsoValue", ISO_VALUE, 0 } };
  static constexpr Controls controls{ "Lines", "", "LinesScalars", {}, starts };
  return controls;
}

vtkSMInkSplattingLinesRepresentationProxy::vtkSMInkSplattingLinesRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkSplattingLinesStyle>::New(), GetControls())
{
}

vtkSMInkSplattingLinesRepresentationProxy::~vtkSMInkSplattingLinesRepresentationProxy() = default;
