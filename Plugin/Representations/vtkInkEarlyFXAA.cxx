// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkEarlyFXAA.h"

#include "vtkCommand.h"
#include "vtkMultiProcessController.h"

namespace
{

// vtkSynchronizedRenderers, which keeps FXAA for later, listens to the same event with priority 0.
constexpr float BeforeSynchronizer = 1.0f;
constexpr float AfterSynchronizer = -1.0f;

} // namespace

vtkInkEarlyFXAA::~vtkInkEarlyFXAA()
{
  this->Detach();
}

void vtkInkEarlyFXAA::Attach(vtkRenderer* renderer)
{
  this->Detach();
  this->Renderer = renderer;
  this->Observers[0] =
    renderer->AddObserver(vtkCommand::StartEvent, this, &vtkInkEarlyFXAA::TakeFromView, BeforeSynchronizer);
  this->Observers[1] =
    renderer->AddObserver(vtkCommand::StartEvent, this, &vtkInkEarlyFXAA::GiveToRenderer, AfterSynchronizer);
}

void vtkInkEarlyFXAA::Detach()
{
  for (const unsigned long observer : this->Observers)
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveObserver(observer);
    }
  }
  this->Renderer = nullptr;
}

void vtkInkEarlyFXAA::TakeFromView()
{
  this->Taken = this->Active && this->Renderer->GetUseFXAA();
  if (this->Taken)
  {
    this->Renderer->SetUseFXAA(false);
  }
}

void vtkInkEarlyFXAA::GiveToRenderer()
{
  if (this->Taken && vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses() == 1)
  {
    this->Renderer->SetUseFXAA(true);
  }
  this->Taken = false;
}
