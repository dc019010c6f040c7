// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkMapper.h"

#include "InkDrawingProgress.h"
#include "InkFrame.h"
#include "InkMarks.h"
#include "InkReportedMessages.h"
#include "InkShiftScale.h"
#include "InkSourcePoints.h"
#include "InkUploadEvent.h"
#include "InkViewUniforms.h"
#include "InkWindowResources.h"

#include "InkOpenGLCompat.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlaneCollection.h"
#include "vtkPointSet.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

/// Parts of a picture's time, about.
constexpr double MarksBegin = 0.2; ///< those before are sent to the GPU
constexpr double OverlayBegins = 0.9;

} // namespace

class vtkInkMapper::vtkInternals
{
public:
  InkReportedMessages Reported;
  InkWindowResources<InkMarks> Windows;
  vtkSmartPointer<vtkInkMapper> Overlay;
};

vtkInkMapper::vtkInkMapper()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkInkMapper::~vtkInkMapper() = default;

void vtkInkMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UploadTime: " << this->GetUploadTime() << "\n";
  os << indent << "Overlay: " << this->GetOverlay() << "\n";
}

void vtkInkMapper::SetOverlay(vtkInkMapper* overlay)
{
  if (overlay == this)
  {
    vtkErrorMacro("A mapper does not draw over itself; expected another one.");
    return;
  }
  if (this->Internals->Overlay != overlay)
  {
    this->Internals->Overlay = overlay;
    this->Modified();
  }
}

vtkInkMapper* vtkInkMapper::GetOverlay()
{
  return this->Internals->Overlay;
}

vtkMTimeType vtkInkMapper::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->GetOverlay() ? std::max(own, this->GetOverlay()->GetMTime()) : own;
}

double* vtkInkMapper::GetBounds()
{
  vtkInkMapper* overlay = this->GetOverlay();
  const double* own = this->Superclass::GetBounds();
  if (overlay && overlay->GetInputDataSet())
  {
    vtkBoundingBox both(own);
    both.AddBounds(overlay->GetBounds());
    both.GetBounds(this->Bounds);
  }
  return this->Bounds;
}

void vtkInkMapper::ReportOnce(const std::string& error)
{
  if (this->Internals->Reported.Add(this->GetInputDataSet()->GetMTime(), error))
  {
    vtkErrorMacro(<< error);
  }
}

void vtkInkMapper::ComputeBounds()
{
  this->ComputePointBounds(nullptr);
}

void vtkInkMapper::ComputePointBounds(vtkUnsignedCharArray* ghosts)
{
  vtkDataSet* input = this->GetInputDataSet();
  vtkMath::UninitializeBounds(this->Bounds);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return;
  }
  input->GetBounds(this->Bounds);
  auto* points = vtkPointSet::SafeDownCast(input);
  if (points &&
    (ghosts || std::any_of(this->Bounds, this->Bounds + 6, [](double b) { return !std::isfinite(b); })))
  {
    InkShiftScale::FindFiniteBounds(points->GetPoints(), this->Bounds, ghosts);
  }
}

InkMarks* vtkInkMapper::FindMarksToDraw(vtkRenderer* renderer)
{
  vtkDataSet* input = this->GetInputDataSet();
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    this->ReportOnce("Drawing needs a vtkOpenGLRenderWindow.");
    return nullptr;
  }
  vtkPlaneCollection* planes = this->GetClippingPlanes();
  if (planes && planes->GetNumberOfItems() > InkViewUniforms::MaximumClippingPlanes)
  {
    std::ostringstream message;
    message << "Only the first " << InkViewUniforms::MaximumClippingPlanes << " of the "
            << planes->GetNumberOfItems() << " clipping planes are used.";
    this->ReportOnce(message.str());
  }
  InkMarks& marks = this->Internals->Windows.Get(
    window, [this](vtkOpenGLRenderWindow* current) { return this->MakeMarks(current); });
  vtkTimerLog::MarkStartEvent(InkUploadEvent);
  const bool there = this->UpdateMarks(marks);
  vtkTimerLog::MarkEndEvent(InkUploadEvent);
  return there ? &marks : nullptr;
}

InkMarks* vtkInkMapper::GetMarks(vtkWindow* window) const
{
  return this->Internals->Windows.Find(window);
}

void vtkInkMapper::ForEachMarks(const std::function<void(const InkMarks&)>& function) const
{
  this->Internals->Windows.ForEach(function);
}

vtkMTimeType vtkInkMapper::GetUploadTime()
{
  vtkMTimeType latest = 0;
  this->ForEachMarks([&](const InkMarks& marks) { latest = std::max(latest, marks.GetUploadTime()); });
  return latest;
}

void vtkInkMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->InvokeEvent(vtkCommand::StartEvent);
  for (int port = 0; port < this->GetNumberOfInputPorts() && !this->Static; ++port)
  {
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      this->GetInputAlgorithm(port, 0)->Update();
    }
  }
  this->InvokeEvent(vtkCommand::EndEvent);

  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector)
  {
    selector->BeginRenderProp();
    if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
    {
      selector->RenderCompositeIndex(1);
    }
  }
  InkDrawingProgress progress(this, this->GetOverlay() ? OverlayBegins : 1.0);
  progress.Until(MarksBegin);
  if (InkMarks* marks = this->FindMarksToDraw(renderer))
  {
    progress.Report();
    vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
    InkFrame frame{ renderer, actor, {}, {}, progress };
    state->vtkglGetIntegerv(GL_VIEWPORT, frame.Viewport.data());
    if (selector)
    {
      auto* points = vtkPolyData::SafeDownCast(this->GetInputDataSet());
      vtkIdTypeArray* sources = points ? InkGetSourcePoints(points) : nullptr;
      selector->UpdateMaximumPointId(
        sources ? sources->GetValueRange(0)[1] : this->GetInputDataSet()->GetNumberOfPoints() - 1);
      frame.Ids.emplace(selector);
    }
    if (frame.Viewport[2] > 0 && frame.Viewport[3] > 0)
    {
      const vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
      state->vtkglDisable(GL_CULL_FACE);
      this->DrawMarks(*marks, frame);
      progress.Until(1.0);
      progress.Report();
    }
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
  else if (this->GetOverlay())
  {
    this->RenderOverlay(renderer, actor);
  }
  this->UpdateProgress(1.0);
}

void vtkInkMapper::RenderOverlay(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInkMapper* overlay = this->GetOverlay();
  if (overlay->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  if (overlay->GetClippingPlanes() != this->GetClippingPlanes())
  {
    overlay->SetClippingPlanes(this->GetClippingPlanes());
  }
  const InkProgressPart part(this, overlay, OverlayBegins, 1.0);
  overlay->RenderPiece(renderer, actor);
}

void vtkInkMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Windows.Release(window);
  if (this->GetOverlay())
  {
    this->GetOverlay()->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
