// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkLineArtRepresentationProxy
 * @brief   presets of line art
 *
 * LineArtPreset, and an iso-value that suits the image when it is no longer automatic.
 *
 * @sa vtkInkLineArtStyle vtkInkLineArtRepresentation
 */
#ifndef vtkSMInkLineArtRepresentationProxy_h
#define vtkSMInkLineArtRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMInkPresetRepresentationProxy.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkLineArtRepresentationProxy
  : public vtkSMInkPresetRepresentationProxy
{
public:
  static vtkSMInkLineArtRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkLineArtRepresentationProxy, vtkSMInkPresetRepresentationProxy);

protected:
  vtkSMInkLineArtRepresentationProxy();
  ~vtkSMInkLineArtRepresentationProxy() override;

private:
  vtkSMInkLineArtRepresentationProxy(const vtkSMInkLineArtRepresentationProxy&) = delete;
  void operator=(const vtkSMInkLineArtRepresentationProxy&) = delete;

  static const Controls& GetControls();
};

#endif
