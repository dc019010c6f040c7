// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkStippleRepresentationProxy
 * @brief   the two levels of control of stipples, in the panel and in scripts
 *
 * A change of the property StipplePreset sets the six sliders StippleGradient to StippleColor, and what else
 * the preset has; a change of a slider sets the mapper's properties that it stands for, as
 * vtkInkStippleControls has it. These can be changed one by one after that. So it is where a person or a
 * script sets them; where values are brought back (undo, a state, a copy, a person's defaults), every
 * property keeps what is brought back. The properties that take part are vtkSMInkIntVectorProperty and
 * vtkSMInkDoubleVectorProperty, which tell the one from the other.
 *
 * @sa vtkInkStippleControls vtkInkStippleRepresentation vtkSMInkDoubleVectorProperty
 */
#ifndef vtkSMInkStippleRepresentationProxy_h
#define vtkSMInkStippleRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkNew.h"                            // for the members
#include "vtkSMRepresentationProxy.h"

#include <string> // for properties' names

class vtkInkStippleControls;
class vtkSMProperty;
struct vtkSMInkStippleSlider;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkStippleRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMInkStippleRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkStippleRepresentationProxy, vtkSMRepresentationProxy);

  /// Whether a property of such a proxy has the value that the preset and the sliders give it. Those that
  /// follow neither always have.
  static bool IsAsFollowed(vtkSMProperty* property);

protected:
  vtkSMInkStippleRepresentationProxy();
  ~vtkSMInkStippleRepresentationProxy() override;

  int ReadXMLAttributes(vtkSMSessionProxyManager* manager, vtkPVXMLElement* element) override;
  void SetPropertyModifiedFlag(const char* name, int flag) override;

private:
  vtkSMInkStippleRepresentationProxy(const vtkSMInkStippleRepresentationProxy&) = delete;
  void operator=(const vtkSMInkStippleRepresentationProxy&) = delete;

  friend class vtkSMInkRestoring;

  bool IsAsFollowed(const std::string& name);
  void ReadControls();
  void FollowPreset();
  void FollowSlider(const vtkSMInkStippleSlider& slider);

  vtkNew<vtkInkStippleControls> Controls;
  int Restoring = 0; ///< above 0: changes are brought back, or this object's own
};

#endif
