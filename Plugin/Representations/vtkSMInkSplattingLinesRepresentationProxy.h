// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkSplattingLinesRepresentationProxy
 * @brief   the iso-value of splatting lines
 *
 * One that suits the image when it is no longer automatic; there are no presets.
 *
 * @sa vtkInkSplattingLinesStyle vtkInkSplattingLinesRepresentation
 */
#ifndef vtkSMInkSplattingLinesRepresentationProxy_h
#define vtkSMInkSplattingLinesRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMInkPresetRepresentationProxy.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkSplattingLinesRepresentationProxy
  : public vtkSMInkPresetRepresentationProxy
{
public:
  static vtkSMInkSplattingLinesRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkSplattingLinesRepresentationProxy, vtkSMInkPresetRepresentationProxy);

protected:
  vtkSMInkSplattingLinesRepresentationProxy();
  ~vtkSMInkSplattingLinesRepresentationProxy() override;

private:
  vtkSMInkSplattingLinesRepresentationProxy(const vtkSMInkSplattingLinesRepresentationProxy&) = delete;
  void operator=(const vtkSMInkSplattingLinesRepresentationProxy&) = delete;

  static const Controls& GetControls();
};

#endif
