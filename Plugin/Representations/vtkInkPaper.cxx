// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkPaper.h"

#include "vtkCommand.h"
#include "vtkProcessModule.h"
#include "vtkRenderer.h"
#include "vtkSMViewProxy.h"

namespace
{

bool IsOnlyServer()
{
  vtkProcessModule* module = vtkProcessModule::GetProcessModule();
  const int type = vtkProcessModule::GetProcessType();
  return (type == vtkProcessModule::PROCESS_SERVER || type == vtkProcessModule::PROCESS_RENDER_SERVER) &&
    module->GetNumberOfLocalPartitions() == 1;
}

} // namespace

vtkInkPaper::~vtkInkPaper()
{
  this->Detach();
}

void vtkInkPaper::Attach(vtkRenderer* renderer)
{
  this->Detach();
  this->Renderer = renderer;
  // Before what a parallel ParaView does at the start of a picture, and after what it does at the end.
  // Papers are taken away in the opposite order.
  static float last = -1e6f;
  last += 1.0f;
  this->Observers[0] = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkInkPaper::Lay, 1.0f);
  this->Observers[2] = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkInkPaper::LayOnServer, -1.0f);
  this->Observers[1] = renderer->AddObserver(vtkCommand::EndEvent, this, &vtkInkPaper::TakeAway, last);
}

void vtkInkPaper::Detach()
{
  if (this->Renderer)
  {
    this->TakeAway(nullptr, 0, nullptr);
    for (const unsigned long observer : this->Observers)
    {
      this->Renderer->RemoveObserver(observer);
    }
  }
  this->Renderer = nullptr;
}

void vtkInkPaper::SetVisible(bool visible)
{
  this->Visible = visible;
}

void vtkInkPaper::SetFills(bool fills)
{
  this->Fills = fills;
}

bool vtkInkPaper::GetFills() const
{
  return this->Fills;
}

void vtkInkPaper::SetColor(double red, double green, double blue)
{
  this->Color[0] = red;
  this->Color[1] = green;
  this->Color[2] = blue;
}

void vtkInkPaper::Lay(vtkObject*, unsigned long, void*)
{
  vtkRenderer* renderer = this->Renderer;
  if (!this->Visible || !this->Fills || this->Laid || renderer->GetSelector() ||
    vtkSMViewProxy::GetTransparentBackground())
  {
    return;
  }
  this->Laid = true;
  renderer->GetBackground(this->Background);
  this->Alpha = renderer->GetBackgroundAlpha();
  this->Gradient = renderer->GetGradientBackground();
  this->Textured = renderer->GetTexturedBackground();
  renderer->SetBackground(this->Color);
  renderer->SetGradientBackground(false);
  renderer->SetTexturedBackground(false);
}

void vtkInkPaper::LayOnServer(vtkObject*, unsigned long, void*)
{
  // Pictures of several processes are put together of what they draw on nothing.
  if (this->Laid && IsOnlyServer())
  {
    this->Renderer->SetBackground(this->Color);
    this->Renderer->SetBackgroundAlpha(1.0);
  }
}

void vtkInkPaper::TakeAway(vtkObject*, unsigned long, void*)
{
  if (this->Laid)
  {
    this->Laid = false;
    this->Renderer->SetBackground(this->Background);
    this->Renderer->SetBackgroundAlpha(this->Alpha);
    this->Renderer->SetGradientBackground(this->Gradient);
    this->Renderer->SetTexturedBackground(this->Textured);
  }
}
