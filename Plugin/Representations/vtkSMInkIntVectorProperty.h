// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkIntVectorProperty
 * @brief   a property that others follow, or that follows others, where a person sets it
 *
 * A vtkSMIntVectorProperty of a vtkSMInkPresetRepresentationProxy. What brings back values that were there
 * before (undo, a state, a copy, the defaults) sets this property only, and none that follows it.
 *
 * @sa vtkSMInkPresetRepresentationProxy
 */
#ifndef vtkSMInkIntVectorProperty_h
#define vtkSMInkIntVectorProperty_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMIntVectorProperty.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkIntVectorProperty : public vtkSMIntVectorProperty
{
public:
  static vtkSMInkIntVectorProperty* New();
  vtkTypeMacro(vtkSMInkIntVectorProperty, vtkSMIntVectorProperty);

  void Copy(vtkSMProperty* source) override;
  void ResetToXMLDefaults() override;
  /// Whether traces and scripts can leave it out: it is the default, and what it follows gives the same.
  bool IsValueDefault() override;

protected:
  vtkSMInkIntVectorProperty();
  ~vtkSMInkIntVectorProperty() override;

  void ReadFrom(const vtkSMMessage* message, int offset, vtkSMProxyLocator* locator) override;
  int LoadState(vtkPVXMLElement* element, vtkSMProxyLocator* locator) override;

private:
  vtkSMInkIntVectorProperty(const vtkSMInkIntVectorProperty&) = delete;
  void operator=(const vtkSMInkIntVectorProperty&) = delete;
};

#endif
