// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkContoursRepresentationProxy.h"

#include "vtkInkContoursStyle.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkContoursRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkContoursRepresentationProxy::GetControls()
{
  static constexpr Start starts[] = { { "ContoursAutomaticIsoValue", 0, "ContoursIsoValue", ISO_VALUE, 0 },
    { "ContoursMethod", vtkInkSilhouetteMapper::VOXEL_SEGMENTS, "ContoursValueRange", RANGE } };
  static constexpr Controls controls{ "Contours", "ContoursPreset", "ContoursScalars", {}, starts };
  return controls;
}

vtkSMInkContoursRepresentationProxy::vtkSMInkContoursRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkContoursStyle>::New(), GetControls())
{
}

vtkSMInkContoursRepresentationProxy::~vtkSMInkContoursRepresentationProxy() = default;
