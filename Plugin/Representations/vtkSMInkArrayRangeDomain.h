// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkArrayRangeDomain
 * @brief   the range of the array that is drawn, also where none is chosen by name
 *
 * A vtkSMArrayRangeDomain knows no array of the name "Active Scalars", and has no range then. This one has
 * that of the input's active scalars, or else of its first array, of points, or else of cells: of what is
 * drawn.
 */
#ifndef vtkSMInkArrayRangeDomain_h
#define vtkSMInkArrayRangeDomain_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMArrayRangeDomain.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkArrayRangeDomain : public vtkSMArrayRangeDomain
{
public:
  static vtkSMInkArrayRangeDomain* New();
  vtkTypeMacro(vtkSMInkArrayRangeDomain, vtkSMArrayRangeDomain);

  using vtkSMArrayRangeDomain::Update;
  void Update(vtkSMProperty* property) override;

protected:
  vtkSMInkArrayRangeDomain();
  ~vtkSMInkArrayRangeDomain() override;

private:
  vtkSMInkArrayRangeDomain(const vtkSMInkArrayRangeDomain&) = delete;
  void operator=(const vtkSMInkArrayRangeDomain&) = delete;
};

#endif
