// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesMapperInternals.h"

#include "InkLocalFrame.h"
#include "InkScalarColors.h"
#include "InkSplatInput.h"
#include "InkSplatLineWork.h"
#include "InkSplatOrder.h"
#include "InkView.h"

#include "InkOpenGLCompat.h"

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
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkInkSplattingLinesMapper);

namespace
{

constexpr const char* DefaultNormals = "Normals";
constexpr const char* DefaultRadius = "Radius";
constexpr const char* Priority = "Priority";

} // namespace

vtkInkSplattingLinesMapper::vtkInkSplattingLinesMapper()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetInputArrayToProcess(NORMALS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, DefaultNormals);
  this->SetInputArrayToProcess(RADIUS, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, DefaultRadius);
  double strength = 0.35;
  for (std::size_t layer = 1; layer < this->Internals->Layers.size(); ++layer)
  {
    this->Internals->Layers[layer].Strength = strength;
    strength *= 2.0 / 3.0;
  }
}

vtkInkSplattingLinesMapper::~vtkInkSplattingLinesMapper() = default;

void vtkInkSplattingLinesMapper::ReportOnce(const std::string& error)
{
  if (this->Internals->Reported.Add(this->GetInput()->GetMTime(), error))
  {
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
  vtkUnsignedCharArray* ghosts = input->GetPointGhostArray();
  input->GetBounds(this->Bounds);
  if (ghosts || std::any_of(this->Bounds, this->Bounds + 6, [](double b) { return !std::isfinite(b); }))
  {
    InkLocalFrame::FindFiniteBounds(input->GetPoints(), this->Bounds, ghosts);
  }
  double radius = this->Radius;
  vtkDataArray* radii = this->GetInputArrayToProcess(RADIUS, input);
  if (radii && radii->GetNumberOfComponents() == 1 && radii->GetNumberOfTuples() > 0)
  {
    radius = ghosts ? 0.0 : radii->GetFiniteRange()[1];
    for (vtkIdType i = 0; ghosts && i < radii->GetNumberOfTuples(); ++i)
    {
      const double own = radii->GetComponent(i, 0);
      radius = std::isfinite(own) && !InkIsGhostPoint(ghosts, i) ? std::max(radius, own) : radius;
    }
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

vtkInkSplattingLinesMapper::vtkWindowResources* vtkInkSplattingLinesMapper::UpdatePoints(
  vtkRenderer* renderer)
{
  vtkInternals& internals = *this->Internals;
  vtkPolyData* input = this->GetInput();
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }

  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    this->ReportOnce("Splatting lines need a vtkOpenGLRenderWindow.");
    return nullptr;
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
    return nullptr;
  }

  if (input->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    std::ostringstream message;
    message << "OpenGL draws up to " << std::numeric_limits<int>::max() << " points; found "
            << input->GetNumberOfPoints() << '.';
    this->ReportOnce(message.str());
    return nullptr;
  }

  vtkPlaneCollection* planes = this->GetClippingPlanes();
  if (planes && planes->GetNumberOfItems() > InkView::MaximumClippingPlanes)
  {
    std::ostringstream message;
    message << "Only the first " << InkView::MaximumClippingPlanes << " of the " << planes->GetNumberOfItems()
            << " clipping planes are used.";
    this->ReportOnce(message.str());
  }

  const InkScalarColors colors(this, input, InkScalarColors::Of::Points);
  const bool colored = this->InkColorMode == SCALARS;
  if (colored && !colors.GetProblem().empty())
  {
    this->ReportOnce(colors.GetProblem());
  }
  vtkUnsignedCharArray* ghosts = input->GetPointGhostArray();
  const vtkWindowResources::Source source{ arrays.Points->GetMTime(), arrays.Normals->GetMTime(),
    arrays.Radii ? arrays.Radii->GetMTime() : 0, ghosts ? ghosts->GetMTime() : 0,
    colored ? colors.Describe() : "", arrays.Radii ? 0.0 : this->Radius };
  vtkWindowResources& resources = internals.Windows.Get(window);
  if (internals.PointsSource != source || resources.PointsSource != source)
  {
    internals.Points.Read(arrays.Points, arrays.Normals, arrays.Radii, this->Radius, ghosts);
    internals.PointsSource = source;
    resources.Passes.Upload(internals.Points, colored ? colors.Map() : nullptr);
    internals.Points.ReleaseArrays();
    resources.PointsSource = source;
  }
  if (internals.Points.GetNumberOfVisiblePoints() == 0)
  {
    std::ostringstream message;
    message << "None of the " << input->GetNumberOfPoints()
            << " points has a finite position, a normal that is not zero and a positive radius"
            << (ghosts ? " and is neither hidden nor a duplicate by vtkGhostType." : ".");
    this->ReportOnce(message.str());
    return nullptr;
  }
  return &resources;
}

void vtkInkSplattingLinesMapper::UpdateOrder(vtkWindowResources& resources)
{
  if (this->PointFraction == 1.0)
  {
    return;
  }
  vtkPolyData* input = this->GetInput();
  vtkDataArray* priorities = input->GetPointData()->GetArray(Priority);
  if (priorities &&
    (priorities->GetNumberOfComponents() != 1 ||
      priorities->GetNumberOfTuples() != input->GetNumberOfPoints()))
  {
    priorities = nullptr;
  }
  const vtkMTimeType time = priorities ? priorities->GetMTime() : 0;
  if (!resources.Passes.HasOrder() || resources.OrderTime != time)
  {
    resources.Passes.SetOrder(
      InkFindSplatOrder(static_cast<std::uint32_t>(input->GetNumberOfPoints()), priorities));
    resources.OrderTime = time;
  }
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
  if (vtkWindowResources* resources = this->UpdatePoints(renderer))
  {
    if (selector)
    {
      this->DrawIds(*resources, renderer, actor, selector);
    }
    else
    {
      this->Draw(*resources, renderer, actor);
    }
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
  this->UpdateProgress(1.0);
}

void vtkInkSplattingLinesMapper::Draw(vtkWindowResources& resources, vtkRenderer* renderer, vtkActor* actor)
{
  InkSplatPasses& passes = resources.Passes;
  // Not the renderer's own: depth peeling draws into buffers of its own.
  int viewport[4];
  passes.GetWindow()->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] <= 0 || viewport[3] <= 0)
  {
    return;
  }
  InkView view(renderer, actor, this, this->Internals->Points.GetFrame(), viewport + 2);

  this->UpdateOrder(resources);
  const bool exact = this->AsPublished || view.TileScale > 1;
  InkSplatting splatting{ .Lambda = this->Lambda,
    .Sigma = this->Sigma,
    .AsPublished = this->AsPublished,
    .MinimumRadius = this->MinimumRadius,
    .Layers = this->HiddenLayers ? this->NumberOfLayers : 1,
    .PeelBackFaces = this->PeelBackFaces,
    .CoarsestTexel = 1,
    .HalfFloats = this->HalfFloats,
    .PointFraction = this->PointFraction,
    .OrderTime = this->PointFraction < 1.0 ? resources.OrderTime : 0,
    .Colors = !resources.PointsSource->Colors.empty() };
  if (!exact)
  {
    splatting.CoarsestTexel = passes.FindTexel(view, splatting, this->CoarsestTexel);
  }
  InkSplatStyle style{ .Tau = this->Tau,
    .Phi = this->Phi,
    .Hardness = this->Hardness,
    .SpeckleLength = this->SpeckleLength,
    .Thinning = this->Thinning,
    .ToneColors = this->InkColorMode == TONE,
    .ToneColor = { this->ToneColor[0], this->ToneColor[1], this->ToneColor[2] },
    .Layers = {},
    .Paper = this->PaperVisibility };
  for (int layer = 0; layer < InkSplatStyle::MostLayers; ++layer)
  {
    InkSplatStyle::Layer& own = style.Layers[static_cast<std::size_t>(layer)];
    this->GetLayerColor(layer, own.Color.data());
    own.ScalarColors = splatting.Colors && !this->Internals->FindLayer(layer)->Color;
    own.Strength = this->GetLayerStrength(layer);
    own.LineWidth = this->GetLayerLineWidth(layer);
    own.DashLength = this->GetLayerDashLength(layer);
  }
  if (view.TileScale > 1)
  {
    // A spot is judged alike in all tiles that it reaches into, so none may reach beyond a tile's margin.
    const int* tile = renderer->GetRenderWindow()->GetActualSize();
    style.SpeckleLength = std::min(style.SpeckleLength, 0.5 * std::min(tile[0], tile[1]) / view.TileScale);
    // Lines go on in the next tile.
    int margin = 0;
    for (int layer = 0; layer < splatting.Layers; ++layer)
    {
      margin = std::max(margin, InkSplatLineWork(style, layer, view).GetMargin());
    }
    view.Widen(margin);
  }
  if (!resources.Get(renderer, actor)
         .Draw(passes, resources.Quads, view, splatting, style, this->PaperColor,
           actor->GetProperty()->GetOpacity(), this, actor))
  {
    this->ReportOnce("This OpenGL cannot draw into 32-bit float images, which splatting lines need.");
  }
}

void vtkInkSplattingLinesMapper::DrawIds(
  vtkWindowResources& resources, vtkRenderer* renderer, vtkActor* actor, vtkHardwareSelector* selector)
{
  InkSplatPasses& passes = resources.Passes;
  int viewport[4];
  passes.GetWindow()->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const InkView view(renderer, actor, this, this->Internals->Points.GetFrame(), viewport + 2);

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

void vtkInkSplattingLinesMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Windows.Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

vtkMTimeType vtkInkSplattingLinesMapper::GetUploadTime()
{
  vtkMTimeType time = 0;
  this->Internals->Windows.ForEach(
    [&](const vtkWindowResources& resources) { time = std::max(time, resources.Passes.GetUploadTime()); });
  return time;
}

int vtkInkSplattingLinesMapper::GetNumberOfDrawnLayers(vtkRenderer* renderer, vtkActor* actor)
{
  vtkWindowResources* resources = this->Internals->Windows.Find(renderer->GetRenderWindow());
  const InkSplatDrawing* drawing = resources ? resources->Find(renderer, actor) : nullptr;
  return drawing ? drawing->GetNumberOfLayers() : 0;
}

bool vtkInkSplattingLinesMapper::HasOpaqueGeometry()
{
  return this->PaperVisibility;
}

bool vtkInkSplattingLinesMapper::HasTranslucentPolygonalGeometry()
{
  return !this->PaperVisibility;
}
