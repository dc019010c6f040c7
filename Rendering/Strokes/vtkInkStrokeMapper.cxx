// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStrokeMapper.h"

#include "InkDrawingProgress.h"
#include "InkFrame.h"
#include "InkLights.h"
#include "InkRenderPasses.h"
#include "InkScalarColors.h"
#include "InkStrokeMarks.h"
#include "InkStrokeRuns.h"
#include "InkStrokeStyle.h"
#include "InkStrokeSurface.h"
#include "InkWindowResources.h"

#include "Tone/Hatching/StrokeWidth.h"
#include "Visibility/CurveVisibility.h"

#include "InkOpenGLCompat.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkInkStrokeMapper);

namespace
{

/// The height in pixels that the image of a whole picture has at least in which the surface's depth decides
/// what is hidden: in a smaller one too much of a stroke lies within a pixel of an edge of the surface.
constexpr int LeastDepthHeight = 1024;

/// Further than that from the picture, and than ink::outlineMargin, nothing matters to what is hidden in it:
/// pixels, and shortest parts.
constexpr float DepthMargin = 16.0f;
constexpr float DepthMarginParts = 2.0f;

/// Parts of a picture's time, about: when the depth is there of what hides strokes, and which of them it
/// hides.
constexpr double DepthEnds = 0.6;
constexpr double RunsEnd = 0.8;

std::vector<float> ReadDepth(const InkOccluderDepth& depth)
{
  std::vector<float> depths(
    static_cast<std::size_t>(depth.Image.GetWidth()) * static_cast<std::size_t>(depth.Image.GetHeight()));
  const InkRenderTarget::Reading reading(*depth.Image.GetTexture());
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  return depths;
}

} // namespace

vtkInkStrokeMapper::vtkInkStrokeMapper()
  : Surfaces(std::make_shared<InkWindowResources<InkStrokeSurface>>())
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Width");
  this->ScalarVisibility = 0;
}

vtkInkStrokeMapper::~vtkInkStrokeMapper() = default;

int vtkInkStrokeMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkInkStrokeMapper::SetTexture(vtkImageData* texture)
{
  if (this->Texture != texture)
  {
    this->Texture = texture;
    this->Modified();
  }
}

vtkImageData* vtkInkStrokeMapper::GetTexture()
{
  return this->Texture;
}

void vtkInkStrokeMapper::SetSurfaceData(vtkPolyData* surface)
{
  this->SetInputDataObject(1, surface);
}

void vtkInkStrokeMapper::SetSurfaceConnection(vtkAlgorithmOutput* surface)
{
  this->SetInputConnection(1, surface);
}

void vtkInkStrokeMapper::ShareSurface(vtkInkStrokeMapper* other)
{
  if (this->Surfaces != other->Surfaces)
  {
    this->Surfaces = other->Surfaces;
    this->Modified();
  }
}

void vtkInkStrokeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Surfaces->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

std::unique_ptr<InkMarks> vtkInkStrokeMapper::MakeMarks(vtkOpenGLRenderWindow* window)
{
  return std::make_unique<InkStrokeMarks>(window);
}

vtkPolyData* vtkInkStrokeMapper::FindSurface()
{
  return this->GetNumberOfInputConnections(1) > 0 ? vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0))
                                                  : nullptr;
}

bool vtkInkStrokeMapper::UpdateMarks(InkMarks& own)
{
  return this->UpdateStrokes(own, this->GetInput());
}

template <class Arrays>
bool vtkInkStrokeMapper::UploadStrokes(InkStrokeMarks& marks, const Arrays& arrays)
{
  if (marks.Source == arrays.GetKey())
  {
    return true;
  }
  marks.Source.reset();
  marks.Colors.reset();
  std::string problem = arrays.FindProblem();
  if (problem.empty())
  {
    marks.Strokes.Read(arrays);
    problem = marks.Passes.Upload(marks.Strokes);
  }
  if (!problem.empty())
  {
    this->ReportOnce(problem);
    return false;
  }
  marks.Source = arrays.GetKey();
  return true;
}

void vtkInkStrokeMapper::UpdateColors(InkStrokeMarks& marks, vtkPolyData* data, bool strokesAreOfCells)
{
  const InkScalarColors ofPoints(this, data, InkScalarColors::Of::Points);
  const InkScalarColors ofCells(this, data, InkScalarColors::Of::Cells);
  const bool byCells = strokesAreOfCells && ofCells.Exist();
  const InkScalarColors& colors = byCells ? ofCells : ofPoints;
  if (!colors.GetProblem().empty())
  {
    this->ReportOnce(colors.GetProblem());
  }
  std::string description = colors.Describe();
  if (marks.Colors != description)
  {
    marks.Passes.UploadColors(
      colors.Exist() ? marks.Strokes.OrderColors(colors.Map(), byCells) : std::vector<std::uint32_t>());
    marks.Colors = std::move(description);
  }
}

bool vtkInkStrokeMapper::UpdateStrokes(InkMarks& own, vtkPolyData* strokes)
{
  auto& marks = static_cast<InkStrokeMarks&>(own);
  if (!this->UploadStrokes(
        marks, InkStrokeArrays(strokes, this->GetInputArrayToProcess(0, strokes), this->Hatching)))
  {
    return false;
  }
  if (marks.Strokes.GetStrokes().empty())
  {
    this->ReportOnce("None of the lines has two different points that are finite.");
    return false;
  }
  this->UpdateColors(marks, strokes, true);
  return true;
}

bool vtkInkStrokeMapper::UpdateVoxels(InkMarks& own, vtkPolyData* voxels)
{
  auto& marks = static_cast<InkStrokeMarks&>(own);
  if (!this->UploadStrokes(marks, InkVoxelArrays(voxels)))
  {
    return false;
  }
  this->UpdateColors(marks, voxels, voxels->GetNumberOfCells() == voxels->GetNumberOfPoints());
  return !marks.Strokes.GetStrokes().empty();
}

bool vtkInkStrokeMapper::UpdateEdges(InkMarks& own, vtkPolyData* surface)
{
  auto& marks = static_cast<InkStrokeMarks&>(own);
  if (!this->UploadStrokes(marks, InkEdgeArrays{ surface }))
  {
    return false;
  }
  this->UpdateColors(marks, surface, true);
  return !marks.Strokes.GetStrokes().empty();
}

bool vtkInkStrokeMapper::EvaluateWidths(vtkRenderer* renderer, vtkActor* actor, vtkFloatArray* widths)
{
  widths->Initialize();
  if (!renderer->GetRenderWindow() || !this->GetInput())
  {
    return false;
  }
  renderer->GetRenderWindow()->MakeCurrent();
  renderer->UpdateLightsGeometryToFollowCamera();
  const int* size = renderer->GetSize();
  InkMarks* own = size[0] > 0 && size[1] > 0 ? this->FindMarksToDraw(renderer) : nullptr;
  if (!own)
  {
    return false;
  }
  auto& marks = static_cast<InkStrokeMarks&>(*own);
  const InkViewUniforms view(renderer, actor, this, marks.Strokes.GetFrame(), size);
  InkStrokeStyle style = this->MakeStyle(marks, view);
  if (this->Hatching)
  {
    style.Hatching = this->MakeHatching(view, renderer);
  }
  InkStrokeRunBuffers runs(marks.Window);
  runs.Upload(InkStrokeRuns::FindWhole(marks.Strokes));
  const int points = this->CountPoints(marks, view, style, runs.NumberOfPoints);
  std::vector<float> found;
  if (points > 0)
  {
    found = marks.Passes.FindWidths({ view, style, runs, nullptr, points });
    if (found.empty())
    {
      return false;
    }
  }
  found.resize(static_cast<std::size_t>(runs.NumberOfPoints));
  const vtkIdType count = this->GetInput()->GetNumberOfPoints();
  widths->SetNumberOfTuples(count);
  std::fill_n(widths->GetPointer(0), count, 0.0f);
  for (const InkStrokePoints::Stroke& stroke : marks.Strokes.GetStrokes())
  {
    for (int point = stroke.First; stroke.Priority < style.Density && point <= stroke.Last; ++point)
    {
      float& widest = *widths->GetPointer(marks.Strokes.GetSource(point));
      widest = std::max(widest, found[static_cast<std::size_t>(point)]);
    }
  }
  return true;
}

InkOccluderDepth* vtkInkStrokeMapper::UpdateDepth(const InkStrokeMarks& marks, const InkFrame& frame)
{
  InkStrokeSurface& shared = this->Surfaces->Get(
    marks.Window, [](vtkOpenGLRenderWindow* window) { return std::make_unique<InkStrokeSurface>(window); });
  std::unique_ptr<InkOccluderDepth>& depth = shared.Depths.Get(frame.Renderer, frame.Actor);
  vtkPolyData* surface = this->FindSurface();
  const bool any = surface && surface->GetNumberOfPoints() > 0;
  if (any)
  {
    if (shared.Time != surface->GetMTime())
    {
      double bounds[6];
      InkShiftScale::FindFiniteBounds(surface->GetPoints(), bounds);
      shared.Frame = InkShiftScale::FromBounds(bounds);
      shared.Time = surface->GetMTime();
    }
    if (const std::string problem = shared.Occluder.Update(surface, shared.Frame); !problem.empty())
    {
      this->ReportOnce(problem);
    }
  }
  if (!any || shared.Occluder.IsEmpty())
  {
    depth.reset();
    return nullptr;
  }
  const InkViewUniforms ofSurface(frame.Renderer, frame.Actor, this, shared.Frame, frame.GetSize());
  const float shortest = static_cast<float>(ofSurface.TileScale * this->ShortestPart);
  const auto outlines = static_cast<float>(ink::outlineMargin(InkStrokeRuns::FindWithinOutline(ofSurface)));
  shared.Occluder.Draw(ofSurface, std::max({ DepthMargin, DepthMarginParts * shortest, outlines }), depth,
    (LeastDepthHeight - 1) / std::max(ofSurface.PictureHeight, 1) + 1);
  if (!depth->Image.IsComplete())
  {
    this->ReportOnce("This OpenGL cannot draw into 32-bit depth images, which hidden parts need.");
    depth.reset();
  }
  return depth.get();
}

void vtkInkStrokeMapper::UpdateRuns(InkStrokeMarks& marks, const InkViewUniforms& view, const InkFrame& frame,
  const InkOccluderDepth* depth, bool byPixel)
{
  InkStrokeMarks::View& shown = marks.Views.Get(frame.Renderer, frame.Actor);
  InkStrokeMarks::View::Source source{ marks.GetUploadTime(), 0, {}, this->HiddenParts != OMITTED,
    view.Unit * this->FindDepthTolerance() / marks.Strokes.GetFrame().Unit,
    view.TileScale * this->ShortestPart };
  if (depth && !byPixel)
  {
    source.Surface = depth->UploadTime;
    source.Shown = depth->View;
  }
  if (shown.RunsSource == source)
  {
    return;
  }
  InkStrokeRuns runs;
  if (source.Shown)
  {
    InkViewUniforms finer = view;
    finer.VCDC = depth->View->VCDC;
    finer.Size = depth->View->Size;
    finer.Pixel = depth->View->Pixel;
    finer.PictureHeight = depth->View->PictureHeight;
    const double factor = view.Pixel / finer.Pixel;
    runs = InkStrokeRuns::FindVisible(
      marks.Strokes, finer, ReadDepth(*depth), source.Tolerance, factor * source.LeastRun, source.WithHidden);
  }
  else
  {
    runs = InkStrokeRuns::FindWhole(marks.Strokes);
  }
  if (!shown.Runs)
  {
    shown.Runs = std::make_unique<InkStrokeRunBuffers>(marks.Window);
  }
  shown.Runs->Upload(runs);
  shown.RunsSource = source;
}

void vtkInkStrokeMapper::DrawMarks(InkMarks& own, const InkFrame& frame)
{
  this->DrawStrokes(static_cast<InkStrokeMarks&>(own), frame, {});
}

void vtkInkStrokeMapper::DrawStrokes(InkStrokeMarks& marks, const InkFrame& frame,
  const std::function<void(InkStrokeStyle&, const InkViewUniforms&)>& choose)
{
  const InkViewUniforms view(frame.Renderer, frame.Actor, this, marks.Strokes.GetFrame(), frame.GetSize());
  InkOccluderDepth* const depth = this->UpdateDepth(marks, frame);
  frame.Progress.Until(DepthEnds);
  frame.Progress.Report();
  this->UpdateRuns(marks, view, frame, depth, this->Hatching || choose);
  const InkStrokeMarks::View& shown = *marks.Views.Find(frame.Renderer, frame.Actor);
  InkStrokeStyle style = this->MakeStyle(marks, view);
  if (choose)
  {
    choose(style, view);
  }
  else if (this->Hatching)
  {
    style.Hatching = this->MakeHatching(view, frame.Renderer);
  }
  frame.Progress.Until(RunsEnd);
  frame.Progress.Report();
  const int points = this->CountPoints(marks, view, style, shown.Runs->NumberOfPoints);
  vtkImageData* const texture = style.BackEdges ? nullptr : this->Texture.Get();
  if (const std::string problem = marks.Passes.UploadTexture(texture); !problem.empty())
  {
    this->ReportOnce(problem);
  }
  const InkStrokePasses::Scene scene{ view, style, *shown.Runs, depth, points };
  if (!marks.Passes.Draw(
        scene, frame, frame.Actor->GetProperty()->GetOpacity(), InkRenderPasses(this, frame.Actor)))
  {
    this->ReportOnce("This OpenGL cannot draw into 32-bit float images, which strokes need.");
  }
}
