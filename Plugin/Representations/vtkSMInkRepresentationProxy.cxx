// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkRepresentationProxy.h"

#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMViewProxy.h"

vtkStandardNewMacro(vtkSMInkRepresentationProxy);

vtkSMInkRepresentationProxy::vtkSMInkRepresentationProxy() = default;

vtkSMInkRepresentationProxy::~vtkSMInkRepresentationProxy()
{
  this->Listen(nullptr);
}

void vtkSMInkRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  if (view != this->View)
  {
    this->Listen(view);
    // What the first picture starts with has passed already.
    this->SendTransparentBackground();
  }
}

void vtkSMInkRepresentationProxy::Listen(vtkSMProxy* view)
{
  if (this->View)
  {
    this->View->RemoveObserver(this->Observer);
  }
  this->View = view;
  if (view)
  {
    this->Observer = view->AddObserver(
      vtkCommand::StartEvent, this, &vtkSMInkRepresentationProxy::SendTransparentBackground);
  }
}

void vtkSMInkRepresentationProxy::SendTransparentBackground()
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetTransparentBackground"
         << static_cast<int>(vtkSMViewProxy::GetTransparentBackground()) << vtkClientServerStream::End;
  this->ExecuteStream(stream);
}
