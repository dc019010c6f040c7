// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkDoubleVectorProperty
 * @brief   a property that others follow, or that follows others, where a person sets it
 *
 * A vtkSMDoubleVectorProperty of a vtkSMInkPresetRepresentationProxy. What brings back values that were
 * there before (undo, a state, a copy, the defaults) sets this property only, and none that follows it.
 *
 * @sa vtkSMInkPresetRepresentationProxy
 */
#ifndef vtkSMInkDoubleVectorProperty_h
#define vtkSMInkDoubleVectorProperty_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMDoubleVectorProperty.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkDoubleVectorProperty : public vtkSMDoubleVectorProperty
{
public:
  static vtkSMInkDoubleVectorProperty* New();
  vtkTypeMacro(vtkSMInkDoubleVectorProperty, vtkSMDoubleVectorProperty);

  void Copy(vtkSMProperty* source) override;
  void ResetToXMLDefaults() override;
  /// Whether traces and scripts can leave it out: it is the default, and what it follows gives the same.
  bool IsValueDefault() override;
  /// Whether it has the value that it was made with.
  bool IsUnset();

protected:
  vtkSMInkDoubleVectorProperty();
  ~vtkSMInkDoubleVectorProperty() override;

  void ReadFrom(const vtkSMMessage* message, int offset, vtkSMProxyLocator* locator) override;
  int LoadState(vtkPVXMLElement* element, vtkSMProxyLocator* locator) override;

private:
  vtkSMInkDoubleVectorProperty(const vtkSMInkDoubleVectorProperty&) = delete;
  void operator=(const vtkSMInkDoubleVectorProperty&) = delete;
};

#endif
