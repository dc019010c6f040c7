// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSMInkRestoring_h
#define vtkSMInkRestoring_h

#include "vtkSMInkPresetRepresentationProxy.h"
#include "vtkSMProperty.h"

/// While it lives, changes of the property's proxy bring back what was there before: none makes others
/// follow.
class vtkSMInkRestoring
{
public:
  explicit vtkSMInkRestoring(vtkSMProperty* property)
    : vtkSMInkRestoring(vtkSMInkPresetRepresentationProxy::SafeDownCast(property->GetParent()))
  {
  }
  explicit vtkSMInkRestoring(vtkSMInkPresetRepresentationProxy* proxy)
    : Proxy(proxy)
  {
    if (this->Proxy)
    {
      ++this->Proxy->Restoring;
    }
  }
  ~vtkSMInkRestoring()
  {
    if (this->Proxy)
    {
      --this->Proxy->Restoring;
    }
  }
  vtkSMInkRestoring(const vtkSMInkRestoring&) = delete;
  void operator=(const vtkSMInkRestoring&) = delete;

private:
  vtkSMInkPresetRepresentationProxy* const Proxy;
};

#endif
