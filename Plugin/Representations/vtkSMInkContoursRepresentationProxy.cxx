// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkContoursRepresentationProxy.h"

#include "vtkInkContoursStyle.h"
#include "vtkInkSilhouetteMapper.h"
#include "vtkSMInkIsoValueInitializationHelper.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"

vtkStandardNewMacro(vtkSMInkContoursRepresentationProxy);

const vtkSMInkPresetRepresentationProxy::Controls& vtkSMInkContoursRepresentationProxy::GetControls()
{
  static constexpr const char* array = "ContoursScalars";
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
  static constexpr Start starts[] = { { "ContoursAutomaticIsoValue", 0, "ContoursIsoValue", suggest, 0 },
    { "ContoursMethod", vtkInkSilhouetteMapper::VOXEL_SEGMENTS, "ContoursValueRange", takeRange } };
  static constexpr Controls controls{ "Contours", "ContoursPreset", {}, starts };
  return controls;
}

vtkSMInkContoursRepresentationProxy::vtkSMInkContoursRepresentationProxy()
  : vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkContoursStyle>::New(), GetControls())
{
}

vtkSMInkContoursRepresentationProxy::~vtkSMInkContoursRepresentationProxy() = default;
