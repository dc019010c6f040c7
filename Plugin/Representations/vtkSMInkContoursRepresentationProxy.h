// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkContoursRepresentationProxy
 * @brief   presets of contours
 *
 * ContoursPreset, and an iso-value that suits the image when it is no longer automatic.
 *
 * @sa vtkInkContoursStyle vtkInkContoursRepresentation
 */
#ifndef vtkSMInkContoursRepresentationProxy_h
#define vtkSMInkContoursRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMInkPresetRepresentationProxy.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkContoursRepresentationProxy
  : public vtkSMInkPresetRepresentationProxy
{
public:
  static vtkSMInkContoursRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkContoursRepresentationProxy, vtkSMInkPresetRepresentationProxy);

protected:
  vtkSMInkContoursRepresentationProxy();
  ~vtkSMInkContoursRepresentationProxy() override;

private:
  vtkSMInkContoursRepresentationProxy(const vtkSMInkContoursRepresentationProxy&) = delete;
  void operator=(const vtkSMInkContoursRepresentationProxy&) = delete;

  static const Controls& GetControls();
};

#endif
