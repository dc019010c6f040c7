// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMInkRepresentationProxy.h"

#include "vtkInkMagnification.h"
#include "vtkInkRepresentation.h"

#include "vtkBoundingBox.h"
#include "vtkClientServerStream.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <cmath>

vtkStandardNewMacro(vtkSMInkRepresentationProxy);

namespace
{

/// What the events of vtkSMViewProxy's pictures come with.
bool IsInteractive(void* flag)
{
  return *static_cast<int*>(flag) != 0;
}

} // namespace

vtkSMInkRepresentationProxy::vtkSMInkRepresentationProxy() = default;

vtkSMInkRepresentationProxy::~vtkSMInkRepresentationProxy()
{
  this->Listen(nullptr);
}

void vtkSMInkRepresentationProxy::AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer)
{
  this->Superclass::AddConsumer(property, consumer);
  if (vtkSMViewProxy::SafeDownCast(consumer))
  {
    this->Listen(consumer);
  }
}

void vtkSMInkRepresentationProxy::Listen(vtkSMProxy* view)
{
  if (this->View)
  {
    this->View->RemoveObserver(this->Start);
    this->View->RemoveObserver(this->End);
  }
  this->View = view;
  if (view)
  {
    this->Start = view->AddObserver(vtkCommand::StartEvent, this, &vtkSMInkRepresentationProxy::StartPicture);
    this->End = view->AddObserver(vtkCommand::EndEvent, this, &vtkSMInkRepresentationProxy::EndPicture);
  }
}

template <class Value>
void vtkSMInkRepresentationProxy::Send(const char* method, Value value)
{
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << method << value << vtkClientServerStream::End;
  this->ExecuteStream(stream);
}

void vtkSMInkRepresentationProxy::SetPreview(bool preview)
{
  this->Send("SetPreview", static_cast<int>(preview));
  // The view brings what it shows up to date then.
  this->MarkDirty(this);
}

void vtkSMInkRepresentationProxy::StartPicture(vtkObject*, unsigned long, void* interactive)
{
  this->Send("SetTransparentBackground", static_cast<int>(vtkSMViewProxy::GetTransparentBackground()));
  if (!IsInteractive(interactive))
  {
    this->FollowView();
  }
}

void vtkSMInkRepresentationProxy::EndPicture(vtkObject* view, unsigned long, void* interactive)
{
  // When the first picture started, what the data is may not have been known.
  if (!IsInteractive(interactive) && this->FollowView())
  {
    vtkSMViewProxy::SafeDownCast(view)->StillRender();
  }
}

double vtkSMInkRepresentationProxy::FindMagnification()
{
  const vtkSMPropertyHelper inputs(this, "Input");
  auto* input =
    inputs.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(inputs.GetAsProxy()) : nullptr;
  auto* view = vtkPVRenderView::SafeDownCast(this->View->GetClientSideObject());
  auto* representation = vtkInkRepresentation::SafeDownCast(this->GetClientSideObject());
  if (!input || !view || !representation)
  {
    return 0.0;
  }
  double bounds[6];
  input->GetDataInformation(inputs.GetOutputPort())->GetBounds(bounds);
  return vtkBoundingBox::IsValid(bounds)
    ? vtkInkFindMagnification(view->GetRenderer(), representation->ToWorld(vtkBoundingBox(bounds)))
    : 0.0;
}

bool vtkSMInkRepresentationProxy::FollowView()
{
  const double magnification = this->FindMagnification();
  const int step = magnification > 0.0 ? vtkInkFollowMagnification(this->Step, magnification) : this->Step;
  if (step == this->Step)
  {
    return false;
  }
  this->Step = step;
  this->Send("SetMagnification", std::exp2(step));
  // The view brings what it shows up to date then.
  this->MarkDirty(this);
  return true;
}
