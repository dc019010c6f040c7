// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSplattingLinesMapperInternals.h"

#include "InkFrame.h"
#include "InkGhostPoint.h"
#include "InkLinePostProcess.h"
#include "InkScalarColors.h"
#include "InkShiftScale.h"
#include "InkSourcePoints.h"
#include "InkSplatInput.h"
#include "InkSplatOrder.h"
#include "InkViewUniforms.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

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
constexpr const char* EdgeOffsets = "EdgeOffsets";

/// Where discs end, see ink::edgeOffsets. Null if there is no such array.
vtkDataArray* FindEdges(vtkPolyData* points)
{
  vtkDataArray* edges = points->GetPointData()->GetArray(EdgeOffsets);
  return edges && edges->GetNumberOfComponents() == 6 &&
      edges->GetNumberOfTuples() == points->GetNumberOfPoints()
    ? edges
    : nullptr;
}

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

void vtkInkSplattingLinesMapper::ComputeBounds()
{
  vtkPolyData* input = this->GetInput();
  vtkUnsignedCharArray* ghosts = input ? input->GetPointGhostArray() : nullptr;
  this->ComputePointBounds(ghosts);
  if (!vtkMath::AreBoundsInitialized(this->Bounds))
  {
    return;
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
  if (radius > 0.0)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[2 * axis] -= radius;
      this->Bounds[2 * axis + 1] += radius;
    }
  }
}

std::unique_ptr<InkMarks> vtkInkSplattingLinesMapper::MakeMarks(vtkOpenGLRenderWindow* window)
{
  return std::make_unique<vtkMarks>(window);
}

bool vtkInkSplattingLinesMapper::UpdateMarks(InkMarks& own)
{
  auto& marks = static_cast<vtkMarks&>(own);
  vtkInternals& internals = *this->Internals;
  vtkPolyData* input = this->GetInput();
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

  if (input->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    std::ostringstream message;
    message << "OpenGL draws up to " << std::numeric_limits<int>::max() << " points; found "
            << input->GetNumberOfPoints() << '.';
    this->ReportOnce(message.str());
    return false;
  }

  const InkScalarColors colors(this, input, InkScalarColors::Of::Points);
  const bool colored = this->InkColorMode == SCALARS;
  if (colored && !colors.GetProblem().empty())
  {
    this->ReportOnce(colors.GetProblem());
  }
  vtkUnsignedCharArray* ghosts = input->GetPointGhostArray();
  vtkIdTypeArray* sources = InkGetSourcePoints(input);
  vtkDataArray* edges = this->AsPublished ? nullptr : FindEdges(input);
  const vtkMarks::Source source{ arrays.Points->GetMTime(), arrays.Normals->GetMTime(),
    arrays.Radii ? arrays.Radii->GetMTime() : 0, edges ? edges->GetMTime() : 0,
    ghosts ? ghosts->GetMTime() : 0, sources ? sources->GetMTime() : 0, colored ? colors.Describe() : "",
    arrays.Radii ? 0.0 : this->Radius };
  if (internals.PointsSource != source || marks.PointsSource != source)
  {
    internals.Points.Read(arrays.Points, arrays.Normals, arrays.Radii, edges, this->Radius, ghosts);
    internals.PointsSource = source;
    marks.Passes.Upload(internals.Points, colored ? colors.Map() : nullptr, sources);
    internals.Points.ReleaseArrays();
    marks.PointsSource = source;
  }
  if (internals.Points.GetNumberOfVisiblePoints() == 0)
  {
    std::ostringstream message;
    message << "None of the " << input->GetNumberOfPoints()
            << " points has a finite position, a normal that is not zero and a positive radius"
            << (ghosts ? " and is neither hidden nor a duplicate by vtkGhostType." : ".");
    this->ReportOnce(message.str());
    return false;
  }
  return true;
}

void vtkInkSplattingLinesMapper::UpdateOrder(vtkMarks& marks)
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
  if (!marks.Passes.HasOrder() || marks.OrderTime != time)
  {
    marks.Passes.SetOrder(
      InkFindSplatOrder(static_cast<std::uint32_t>(input->GetNumberOfPoints()), priorities));
    marks.OrderTime = time;
  }
}

void vtkInkSplattingLinesMapper::DrawMarks(InkMarks& own, const InkFrame& frame)
{
  auto& marks = static_cast<vtkMarks&>(own);
  const InkViewUniforms view(
    frame.Renderer, frame.Actor, this, this->Internals->Points.GetFrame(), frame.GetSize());
  if (frame.Ids)
  {
    marks.Passes.DrawIds(view, frame);
  }
  else
  {
    this->DrawLines(marks, view, frame);
  }
}

void vtkInkSplattingLinesMapper::DrawLines(vtkMarks& marks, InkViewUniforms view, const InkFrame& frame)
{
  this->UpdateOrder(marks);
  const bool exact = this->AsPublished || view.TileScale > 1;
  InkSplatSettings splatting{ .Lambda = this->Lambda,
    .Sigma = this->Sigma,
    .AsPublished = this->AsPublished,
    .MinimumRadius = this->MinimumRadius,
    .Layers = this->HiddenLayers ? this->NumberOfLayers : 1,
    .PeelBackFaces = this->PeelBackFaces,
    .MaximumDownsampling = 1,
    .HalfFloats = this->HalfFloats,
    .PointFraction = this->PointFraction,
    .OrderTime = this->PointFraction < 1.0 ? marks.OrderTime : 0,
    .Colors = !marks.PointsSource->Colors.empty() };
  if (!exact)
  {
    splatting.MaximumDownsampling = marks.Passes.FindTexel(view, splatting, this->MaximumDownsampling);
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
    const int* tile = frame.Renderer->GetRenderWindow()->GetActualSize();
    style.SpeckleLength = std::min(style.SpeckleLength, 0.5 * std::min(tile[0], tile[1]) / view.TileScale);
    // Lines go on in the next tile.
    int margin = 0;
    for (int layer = 0; layer < splatting.Layers; ++layer)
    {
      margin = std::max(margin, InkLinePostProcess(style, layer, view).GetMargin());
    }
    // Ink of a pixel depends on those around it, and theirs on splats that a tile's border would hide.
    constexpr int around = 16;
    view.Widen(this->AsPublished ? margin : margin + around);
  }
  if (!marks.Drawings.Get(frame.Renderer, frame.Actor)
         .Draw(marks.Passes, marks.Quads, view, splatting, style, this->PaperColor, this, frame))
  {
    this->ReportOnce("This OpenGL cannot draw into 32-bit float images, which splatting lines need.");
  }
}

int vtkInkSplattingLinesMapper::GetNumberOfDrawnLayers(vtkRenderer* renderer, vtkActor* actor)
{
  auto* marks = static_cast<vtkMarks*>(this->GetMarks(renderer->GetRenderWindow()));
  const InkSplatDrawing* drawing = marks ? marks->Drawings.Find(renderer, actor) : nullptr;
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
