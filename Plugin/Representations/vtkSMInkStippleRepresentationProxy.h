// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkStippleRepresentationProxy
 * @brief   the two levels of control of stipples
 *
 * StipplePreset, and the sliders StippleGradient to StippleColor, which vtkInkStippleStyle gives their
 * meaning.
 *
 * @sa vtkInkStippleStyle vtkInkStippleRepresentation
 */
#ifndef vtkSMInkStippleRepresentationProxy_h
#define vtkSMInkStippleRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMInkPresetRepresentationProxy.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkStippleRepresentationProxy
  : public vtkSMInkPresetRepresentationProxy
{
public:
  static vtkSMInkStippleRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkStippleRepresentationProxy, vtkSMInkPresetRepresentationProxy);

protected:
  vtkSMInkStippleRepresentationProxy();
  ~vtkSMInkStippleRepresentationProxy() override;

private:
  vtkSMInkStippleRepresentationProxy(const vtkSMInkStippleRepresentationProxy&) = delete;
  void operator=(const vtkSMInkStippleRepresentationProxy&) = delete;

  static const Controls& GetControls();
};

#endif
