// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkDoubleVectorProperty.h"

#include "vtkSMInkPresetRepresentationProxy.h"
#include "vtkSMInkRestoring.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkDoubleVectorProperty);

vtkSMInkDoubleVectorProperty::vtkSMInkDoubleVectorProperty() = default;

vtkSMInkDoubleVectorProperty::~vtkSMInkDoubleVectorProperty() = default;

void vtkSMInkDoubleVectorProperty::Copy(vtkSMProperty* source)
{
  const vtkSMInkRestoring restoring(this);
  this->Superclass::Copy(source);
}

void vtkSMInkDoubleVectorProperty::ResetToXMLDefaults()
{
  const vtkSMInkRestoring restoring(this);
  this->Superclass::ResetToXMLDefaults();
}

bool vtkSMInkDoubleVectorProperty::IsValueDefault()
{
  return vtkSMInkPresetRepresentationProxy::ShowsChosen(this) ||
    (this->IsUnset() && vtkSMInkPresetRepresentationProxy::IsAsFollowed(this));
}

bool vtkSMInkDoubleVectorProperty::IsUnset()
{
  return this->Superclass::IsValueDefault();
}

void vtkSMInkDoubleVectorProperty::ReadFrom(
  const vtkSMMessage* message, int offset, vtkSMProxyLocator* locator)
{
  const vtkSMInkRestoring restoring(this);
  this->Superclass::ReadFrom(message, offset, locator);
}

int vtkSMInkDoubleVectorProperty::LoadState(vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  const vtkSMInkRestoring restoring(this);
  return this->Superclass::LoadState(element, locator);
}
