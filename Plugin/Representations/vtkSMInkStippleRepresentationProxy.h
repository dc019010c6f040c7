// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkStippleRepresentationProxy
 * @brief   the two levels of control of stipples, in the panel and in scripts
 *
 * A change of the property StipplePreset sets the six sliders StippleGradient to StippleColor, and what else
 * the preset has; a change of a slider sets the mapper's properties that it stands for, as
 * vtkInkStippleControls has it. These can be changed one by one after that. While a state is read every
 * property keeps what the state says.
 *
 * @sa vtkInkStippleControls vtkInkStippleRepresentation
 */
#ifndef vtkSMInkStippleRepresentationProxy_h
#define vtkSMInkStippleRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkNew.h"                            // for the members
#include "vtkSMRepresentationProxy.h"

class vtkInkStippleControls;
struct vtkSMInkStippleSlider;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkStippleRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMInkStippleRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkStippleRepresentationProxy, vtkSMRepresentationProxy);

protected:
  vtkSMInkStippleRepresentationProxy();
  ~vtkSMInkStippleRepresentationProxy() override;

  int ReadXMLAttributes(vtkSMSessionProxyManager* manager, vtkPVXMLElement* element) override;
  void SetPropertyModifiedFlag(const char* name, int flag) override;

private:
  vtkSMInkStippleRepresentationProxy(const vtkSMInkStippleRepresentationProxy&) = delete;
  void operator=(const vtkSMInkStippleRepresentationProxy&) = delete;

  bool ReadsState();
  void ReadControls();
  void FollowPreset();
  void FollowSlider(const vtkSMInkStippleSlider& slider);

  vtkNew<vtkInkStippleControls> Controls;
  bool Following = false; ///< changes are this object's own, or there are not all properties yet
};

#endif
