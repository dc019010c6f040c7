// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkIllustrationRepresentationProxy
 * @brief   presets of illustrations
 *
 * IllustrationPreset, and iso-values that suit the image when they are no longer automatic.
 *
 * @sa vtkInkIllustrationStyle vtkInkIllustrationRepresentation
 */
#ifndef vtkSMInkIllustrationRepresentationProxy_h
#define vtkSMInkIllustrationRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMInkPresetRepresentationProxy.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkIllustrationRepresentationProxy
  : public vtkSMInkPresetRepresentationProxy
{
public:
  static vtkSMInkIllustrationRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkIllustrationRepresentationProxy, vtkSMInkPresetRepresentationProxy);

protected:
  vtkSMInkIllustrationRepresentationProxy();
  ~vtkSMInkIllustrationRepresentationProxy() override;

private:
  vtkSMInkIllustrationRepresentationProxy(const vtkSMInkIllustrationRepresentationProxy&) = delete;
  void operator=(const vtkSMInkIllustrationRepresentationProxy&) = delete;

  static const Controls& GetControls();
};

#endif
