// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkLineArtRepresentationProxy.h"

#include "vtkInkLineArtStyle.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkLineArtRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkLineArtRepresentationProxy::GetControls()
{
  static constexpr Start starts[] = { { "LineArtAutomaticIsoValue", 0, "LineArtIsoValue", ISO_VALUE, 0 },
    { "LineArtContourMethod", vtkInkSilhouetteMapper::VOXEL_SEGMENTS, "LineArtContourValueRange", RANGE } };
  static constexpr Controls controls{ "LineArt", "LineArtPreset", "LineArtScalars", {}, starts };
  return controls;
}

vtkSMInkLineArtRepresentationProxy::vtkSMInkLineArtRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkLineArtStyle>::New(), GetControls())
{
}

vtkSMInkLineArtRepresentationProxy::~vtkSMInkLineArtRepresentationProxy() = default;
