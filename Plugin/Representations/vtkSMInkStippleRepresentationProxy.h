// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkStippleRepresentationProxy
 * @brief   the two levels of control of stipples, in the panel and in scripts
 *
 * A change of the property StipplePreset sets the six sliders StippleGradient to StippleColor, and what else
 * the preset has; a change of a slider sets the mapper's properties that it stands for, as
 * vtkInkStippleStyle has it. These can be changed one by one after that. So it is where a person or a
 * script sets them; where values are brought back (undo, a state, a copy, a person's defaults), every
 * property keeps what is brought back. The properties that take part, `tracked` in the style's table of
 * parameters, are vtkSMInkIntVectorProperty and vtkSMInkDoubleVectorProperty, which tell the one from the
 * other.
 *
 * @sa vtkInkStippleStyle vtkInkStippleRepresentation vtkSMInkDoubleVectorProperty
 */
#ifndef vtkSMInkStippleRepresentationProxy_h
#define vtkSMInkStippleRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkNew.h"                            // for the style
#include "vtkSMInkRepresentationProxy.h"

#include <string> // for properties' names
#include <vector> // for properties' names

class vtkInkStippleStyle;
class vtkSMProperty;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkStippleRepresentationProxy
  : public vtkSMInkRepresentationProxy
{
public:
  static vtkSMInkStippleRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkStippleRepresentationProxy, vtkSMInkRepresentationProxy);

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
  void FollowPreset();
  void FollowSlider(const std::string& slider);
  /// Sets the style's preset as it is chosen here, and the sliders, or leaves these as the preset has them.
  void SetControls(bool sliders);
  /// The properties that a preset sets.
  std::vector<std::string> GetFollowers();

  const vtkNew<vtkInkStippleStyle> Style; ///< draws nothing; says what presets and sliders set
  int Restoring = 0;                      ///< above 0: changes are brought back, or this object's own
};

#endif
