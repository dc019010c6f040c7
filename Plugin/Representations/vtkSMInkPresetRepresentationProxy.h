// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkPresetRepresentationProxy
 * @brief   presets and sliders that stand for several properties, in the panel and in scripts
 *
 * A change of the preset's property sets what the preset has; a change of a slider sets the properties that
 * it stands for, as the style has it. These can be changed one by one after that. So it is where a person or
 * a script sets them; where values are brought back (undo, a state, a copy, a person's defaults), every
 * property keeps what is brought back. The properties that take part, `tracked` in the style's table of
 * parameters, are vtkSMInkIntVectorProperty and vtkSMInkDoubleVectorProperty, which tell the one from the
 * other. Some properties start with a value that suits the input when they are switched on. An iso-value
 * shows what is drawn while it is automatic, and is automatic no more when it is set.
 *
 * A subclass says for which style, and which properties these are.
 *
 * @sa vtkInkStyle vtkSMInkDoubleVectorProperty
 */
#ifndef vtkSMInkPresetRepresentationProxy_h
#define vtkSMInkPresetRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMInkRepresentationProxy.h"
#include "vtkSmartPointer.h" // for the style

#include <span>   // for sliders
#include <string> // for properties' names
#include <vector> // for properties' names

class vtkInkStyle;
class vtkSMProperty;
struct InkParameter;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkPresetRepresentationProxy
  : public vtkSMInkRepresentationProxy
{
public:
  vtkTypeMacro(vtkSMInkPresetRepresentationProxy, vtkSMInkRepresentationProxy);

  /// Whether a property of such a proxy has the value that the preset and the sliders give it. Those that
  /// follow neither always have.
  static bool IsAsFollowed(vtkSMProperty* property);
  /// Whether its value only shows what was chosen automatically.
  static bool ShowsChosen(vtkSMProperty* property);

  void ViewUpdated(vtkSMProxy* view) override;

protected:
  enum StartValue
  {
    ISO_VALUE, ///< the one that suits the array
    RANGE      ///< of the array
  };
  /// What starts with a value that suits the input when it is switched on.
  struct Start
  {
    const char* Switch;
    int On;
    const char* Property;
    StartValue Value;
    int Surface = -1; ///< of which it is the iso-value, automatic until it is switched on; negative: none
  };
  /// The names of properties.
  struct Controls
  {
    const char* Prefix; ///< before those of parameters, as far as they have it
    const char* Preset;
    const char* Array; ///< chooses the array
    std::span<const char* const> Sliders;
    std::span<const Start> Starts;
  };
  /// @param style draws nothing; says what presets and sliders set
  vtkSMInkPresetRepresentationProxy(vtkSmartPointer<vtkInkStyle> style, const Controls& controls);
  ~vtkSMInkPresetRepresentationProxy() override;

  int ReadXMLAttributes(vtkSMSessionProxyManager* manager, vtkPVXMLElement* element) override;
  void SetPropertyModifiedFlag(const char* name, int flag) override;

private:
  vtkSMInkPresetRepresentationProxy(const vtkSMInkPresetRepresentationProxy&) = delete;
  void operator=(const vtkSMInkPresetRepresentationProxy&) = delete;

  friend class vtkSMInkRestoring;

  bool IsAsFollowed(const std::string& name);
  void FollowPreset();
  void FollowSlider(const std::string& slider);
  /// Sets the style's preset as it is chosen here, and the sliders, or leaves these as the preset has them.
  void SetControls(bool sliders);
  /// The properties that a preset sets.
  std::vector<std::string> GetFollowers();

  void SetStartValue(const Start& start);
  bool IsOn(const Start& start);
  bool IsAutomatic(const Start& start) { return start.Surface >= 0 && !this->IsOn(start); }
  bool IsSlider(const std::string& name) const;
  /// The parameter that a property sets, whose name it has, or has after the prefix; null for others.
  const InkParameter* ParameterOf(const std::string& property) const;
  std::vector<double> ValueOf(const std::string& property) const;

  const vtkSmartPointer<vtkInkStyle> Style;
  const Controls Named;
  int Restoring = 0; ///< above 0: changes are brought back, or this object's own
};

#endif
