// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesMapper.h"

#include "InkLocalFrame.h"
#include "InkSplatInput.h"
#include "InkSplatPasses.h"
#include "InkSplatPoints.h"
#include "InkSplatTargets.h"
#include "InkView.h"

#include "InkOpenGLCompat.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkInkSplattingLinesMapper);

namespace
{

constexpr const char* DefaultNormals = "Normals";
constexpr const char* DefaultRadius = "Radius";

} // namespace

class vtkInkSplattingLinesMapper::vtkInternals
{
public:
  /// What the points on the GPU were made from; modification times are unique, so no pointers are needed.
  struct Source
  {
    vtkMTimeType Points;
    vtkMTimeType Normals;
    vtkMTimeType Radii;
    double Radius;
    bool operator==(const Source&) const = default;
  };

  /// The splats of one actor in one renderer, and what they show.
  struct Drawing
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkActor> Actor;
    std::unique_ptr<InkSplatTargets> Targets;
    std::optional<InkView> View;
    InkSplatPasses::Splatting Splatting;
    vtkMTimeType UploadTime;
  };

  Drawing& Find(vtkRenderer* renderer, vtkActor* actor)
  {
    std::erase_if(this->Drawings, [](const Drawing& d) { return !d.Renderer || !d.Actor; });
    for (Drawing& drawing : this->Drawings)
    {
      if (drawing.Renderer == renderer && drawing.Actor == actor)
      {
        return drawing;
      }
    }
    Drawing& drawing = this->Drawings.emplace_back();
    drawing.Renderer = renderer;
    drawing.Actor = actor;
    return drawing;
  }

  InkSplatPoints Points;
  std::optional<Source> PointsSource; ///< what Points was read from
  vtkMTimeType ReportedTime = 0;      ///< of the input whose error was reported last
  std::string ReportedError;
  std::unique_ptr<InkSplatPasses> Passes;
  unsigned long WindowObserver = 0;
  std::vector<Drawing> Drawings;
};

vtkInkSplattingLinesMapper::vtkInkSplattingLinesMapper()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetInputArrayToProcess(NORMALS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, DefaultNormals);
  this->SetInputArrayToProcess(RADIUS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, DefaultRadius);
}

vtkInkSplattingLinesMapper::~vtkInkSplattingLinesMapper()
{
  this->ReleaseWindow();
}

void vtkInkSplattingLinesMapper::ReportOnce(const std::string& error)
{
  vtkInternals& internals = *this->Internals;
  const vtkMTimeType time = this->GetInput()->GetMTime();
  if (internals.ReportedTime < time || internals.ReportedError != error)
  {
    internals.ReportedTime = time;
    internals.ReportedError = error;
    vtkErrorMacro(<< error);
  }
}

void vtkInkSplattingLinesMapper::ComputeBounds()
{
  vtkPolyData* input = this->GetInput();
  vtkMath::UninitializeBounds(this->Bounds);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return;
  }
  input->GetBounds(this->Bounds);
  if (std::any_of(this->Bounds, this->Bounds + 6, [](double b) { return !std::isfinite(b); }))
  {
    InkLocalFrame::FindFiniteBounds(input->GetPoints(), this->Bounds);
  }
  double radius = this->Radius;
  vtkDataArray* radii = this->GetInputArrayToProcess(RADIUS, input);
  if (radii && radii->GetNumberOfComponents() == 1 && radii->GetNumberOfTuples() > 0)
  {
    radius = radii->GetFiniteRange()[1];
  }
  if (radius > 0.0 && vtkMath::AreBoundsInitialized(this->Bounds))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[2 * axis] -= radius;
      this->Bounds[2 * axis + 1] += radius;
    }
  }
}

bool vtkInkSplattingLinesMapper::UpdatePoints(vtkRenderer* renderer)
{
  vtkInternals& internals = *this->Internals;
  vtkPolyData* input = this->GetInput();
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return false;
  }

  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    this->ReportOnce("Splatting lines need a vtkOpenGLRenderWindow.");
    return false;
  }

  const auto chosenName = [this](int index) -> std::string
  {
    vtkInformation* info = this->GetInputArrayInformation(index);
    return info->Has(vtkDataObject::FIELD_NAME()) ? info->Get(vtkDataObject::FIELD_NAME()) : "";
  };
  InkSplatInput arrays{ input->GetPoints(), this->GetInputArrayToProcess(NORMALS, input),
    this->GetInputArrayToProcess(RADIUS, input), chosenName(NORMALS), chosenName(RADIUS),
    chosenName(RADIUS) != DefaultRadius };
  if (!arrays.Normals && arrays.NormalsName == DefaultNormals)
  {
    arrays.Normals = input->GetPointData()->GetNormals();
  }
  const std::string problem = arrays.FindProblem(input->GetPointData());
  if (!problem.empty())
  {
    this->ReportOnce(problem);
    return false;
  }

  vtkPlaneCollection* planes = this->GetClippingPlanes();
  if (planes && planes->GetNumberOfItems() > InkView::MaximumClippingPlanes)
  {
    std::ostringstream message;
    message << "Only the first " << InkView::MaximumClippingPlanes << " of the " << planes->GetNumberOfItems()
            << " clipping planes are used.";
    this->ReportOnce(message.str());
  }

  if (internals.Passes && internals.Passes->GetWindow() != window)
  {
    this->ReleaseWindow();
    window->MakeCurrent();
  }
  const vtkInternals::Source source{ arrays.Points->GetMTime(), arrays.Normals->GetMTime(),
    arrays.Radii ? arrays.Radii->GetMTime() : 0, arrays.Radii ? 0.0 : this->Radius };
  if (!internals.Passes || internals.PointsSource != source)
  {
    internals.Points.Read(arrays.Points, arrays.Normals, arrays.Radii, this->Radius);
    if (!internals.Passes)
    {
      internals.Passes = std::make_unique<InkSplatPasses>(window);
      // A window that never knew this mapper's actor does not release it either.
      internals.WindowObserver =
        window->AddObserver(vtkCommand::DeleteEvent, this, &vtkInkSplattingLinesMapper::ReleaseWindow);
    }
    internals.Passes->Upload(internals.Points);
    internals.Points.ReleaseArrays();
    internals.PointsSource = source;
  }
  if (internals.Points.GetNumberOfVisiblePoints() == 0)
  {
    std::ostringstream message;
    message << "None of the " << input->GetNumberOfPoints()
            << " points has a finite position, a normal that is not zero and a positive radius.";
    this->ReportOnce(message.str());
    return false;
  }
  return true;
}

void vtkInkSplattingLinesMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->InvokeEvent(vtkCommand::StartEvent);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
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
  if (this->UpdatePoints(renderer))
  {
    if (selector)
    {
      this->DrawIds(renderer, actor, selector);
    }
    else
    {
      this->Draw(renderer, actor);
    }
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
  this->UpdateProgress(1.0);
}

void vtkInkSplattingLinesMapper::Draw(vtkRenderer* renderer, vtkActor* actor)
{
  vtkInternals& internals = *this->Internals;
  InkSplatPasses& passes = *internals.Passes;
  // Not the renderer's own: depth peeling draws into buffers of its own.
  int viewport[4];
  passes.GetWindow()->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] <= 0 || viewport[3] <= 0)
  {
    return;
  }
  const InkView view(renderer, actor, this, internals.Points.GetFrame(), viewport + 2);

  vtkInternals::Drawing& drawing = internals.Find(renderer, actor);
  if (!drawing.Targets || (drawing.View && drawing.View->Size != view.Size))
  {
    drawing.Targets = std::make_unique<InkSplatTargets>(passes.GetWindow(), viewport + 2);
    drawing.View.reset();
  }
  if (!drawing.Targets->IsComplete())
  {
    this->ReportOnce("This OpenGL cannot draw into 32-bit float images, which splatting lines need.");
    return;
  }
  const InkSplatPasses::Splatting splatting{ this->Lambda, this->Sigma, this->AsPublished };
  if (drawing.View != view || drawing.Splatting != splatting || drawing.UploadTime != passes.GetUploadTime())
  {
    passes.DrawSplats(view, *drawing.Targets, splatting);
    drawing.View = view;
    drawing.Splatting = splatting;
    drawing.UploadTime = passes.GetUploadTime();
  }
  passes.DrawComposite(view, *drawing.Targets,
    { this->Tau, this->Phi, this->InkColor, this->PaperColor, this->PaperVisibility,
      actor->GetProperty()->GetOpacity() },
    this, actor);
}

void vtkInkSplattingLinesMapper::DrawIds(
  vtkRenderer* renderer, vtkActor* actor, vtkHardwareSelector* selector)
{
  vtkInternals& internals = *this->Internals;
  InkSplatPasses& passes = *internals.Passes;
  int viewport[4];
  passes.GetWindow()->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const InkView view(renderer, actor, this, internals.Points.GetFrame(), viewport + 2);

  selector->UpdateMaximumPointId(this->GetInput()->GetNumberOfPoints() - 1);
  int idShift = -1;
  const float noCell[3] = { 0.0f, 0.0f, 0.0f };
  const float* color = selector->GetPropColorValue();
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
      idShift = 0;
      break;
    case vtkHardwareSelector::POINT_ID_HIGH24:
      idShift = 24;
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
    case vtkHardwareSelector::CELL_ID_HIGH24:
      color = noCell;
      break;
    default:
      break;
  }
  passes.DrawIds(view, viewport, idShift, color);
}

void vtkInkSplattingLinesMapper::ReleaseWindow()
{
  vtkInternals& internals = *this->Internals;
  if (internals.Passes)
  {
    vtkOpenGLRenderWindow* window = internals.Passes->GetWindow();
    window->RemoveObserver(internals.WindowObserver);
    window->PushContext();
    internals.Drawings.clear();
    internals.Passes.reset();
    window->PopContext();
  }
}

void vtkInkSplattingLinesMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ReleaseWindow();
  this->Superclass::ReleaseGraphicsResources(window);
}

vtkMTimeType vtkInkSplattingLinesMapper::GetUploadTime()
{
  return this->Internals->Passes ? this->Internals->Passes->GetUploadTime() : 0;
}

bool vtkInkSplattingLinesMapper::HasOpaqueGeometry()
{
  return this->PaperVisibility;
}

bool vtkInkSplattingLinesMapper::HasTranslucentPolygonalGeometry()
{
  return !this->PaperVisibility;
}

void vtkInkSplattingLinesMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lambda: " << this->Lambda << "\n";
  os << indent << "Tau: " << this->Tau << "\n";
  os << indent << "Phi: " << this->Phi << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "AsPublished: " << (this->AsPublished ? "On" : "Off") << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "InkColor: " << this->InkColor[0] << ' ' << this->InkColor[1] << ' ' << this->InkColor[2]
     << "\n";
  os << indent << "PaperColor: " << this->PaperColor[0] << ' ' << this->PaperColor[1] << ' '
     << this->PaperColor[2] << "\n";
  os << indent << "PaperVisibility: " << (this->PaperVisibility ? "On" : "Off") << "\n";
}
