// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkIsoValueInitializationHelper
 * @brief   lets a new filter start with the iso-value that suits its input
 *
 * Sets the property ContourValues of a filter of images, whose property SelectInputScalars says which array
 * it looks at, unless it has been set already.
 *
 * @sa vtkPVInkIsoValueInformation
 */
#ifndef vtkSMInkIsoValueInitializationHelper_h
#define vtkSMInkIsoValueInitializationHelper_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

#include <optional> // for the suggestion

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkIsoValueInitializationHelper
  : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMInkIsoValueInitializationHelper* New();
  vtkTypeMacro(vtkSMInkIsoValueInitializationHelper, vtkSMProxyInitializationHelper);

  void PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType since) override;

#ifndef __VTK_WRAP__
  /// What suits the proxy's Input, by the array that one of its properties chooses: nothing where there is no
  /// image, or no two different values. Makes the input up to date.
  static std::optional<double> Suggest(vtkSMProxy* proxy, const char* arrayProperty);
  /// The value that a vtkInkRepresentation used last for one of its surfaces; nothing where it made none.
  static std::optional<double> FindUsed(vtkSMProxy* representation, int surface);
#endif

protected:
  vtkSMInkIsoValueInitializationHelper();
  ~vtkSMInkIsoValueInitializationHelper() override;

private:
  vtkSMInkIsoValueInitializationHelper(const vtkSMInkIsoValueInitializationHelper&) = delete;
  void operator=(const vtkSMInkIsoValueInitializationHelper&) = delete;
};

#endif
