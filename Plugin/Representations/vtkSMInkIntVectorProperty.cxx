// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkIntVectorProperty.h"

#include "vtkSMInkPresetRepresentationProxy.h"
#include "vtkSMInkRestoring.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMInkIntVectorProperty);

vtkSMInkIntVectorProperty::vtkSMInkIntVectorProperty() = default;

vtkSMInkIntVectorProperty::~vtkSMInkIntVectorProperty() = default;

void vtkSMInkIntVectorProperty::Copy(vtkSMProperty* source)
{
  const vtkSMInkRestoring restoring(this);
  this->Superclass::Copy(source);
}

void vtkSMInkIntVectorProperty::ResetToXMLDefaults()
{
  const vtkSMInkRestoring restoring(this);
  this->Superclass::ResetToXMLDefaults();
}

bool vtkSMInkIntVectorProperty::IsValueDefault()
{
  return this->Superclass::IsValueDefault() && vtkSMInkPresetRepresentationProxy::IsAsFollowed(this);
}

void vtkSMInkIntVectorProperty::ReadFrom(const vtkSMMessage* message, int offset, vtkSMProxyLocator* locator)
{
  const vtkSMInkRestoring restoring(this);
  this->Superclass::ReadFrom(message, offset, locator);
}

int vtkSMInkIntVectorProperty::LoadState(vtkPVXMLElement* element, vtkSMProxyLocator* locator)
{
  const vtkSMInkRestoring restoring(this);
  return this->Superclass::LoadState(element, locator);
}
