// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkLineArtRepresentationProxy.h"

#include "vtkInkLineArtStyle.h"
#include "vtkInkSilhouetteMapper.h"
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"

vtkStandardNewMacro(vtkSMInkLineArtRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkLineArtRepresentationProxy::GetControls()
{
  static constexpr const char* array = "LineArtScalars";
  static constexpr auto suggest = [](vtkSMProxy* proxy, const char* property)
  {
    ChooseArray(proxy, array);
    vtkSMInkIsoValueInitializationHelper::SetSuggested(proxy, property, array);
  };
  static constexpr auto takeRange = [](vtkSMProxy* proxy, const char* property)
  {
    ChooseArray(proxy, array);
    proxy->GetProperty(property)->ResetToDomainDefaults();
  };
  static constexpr Start starts[] = { { "LineArtAutomaticIsoValue", 0, "LineArtIsoValue", suggest, 0 },
    { "LineArtContourMethod", vtkInkSilhouetteMapper::VOXEL_SEGMENTS, "LineArtContourValueRange",
      takeRange } };
  static constexpr Controls controls{ "LineArt", "LineArtPreset", {}, starts };
  return controls;
}

vtkSMInkLineArtRepresentationProxy::vtkSMInkLineArtRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkLineArtStyle>::New(), GetControls())
{
}

vtkSMInkLineArtRepresentationProxy::~vtkSMInkLineArtRepresentationProxy() = default;
