// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleMapper.h"

#include "InkLocalFrame.h"
#include "InkRenderPasses.h"
#include "InkReportedMessages.h"
#include "InkScalarColors.h"
#include "InkStipplePoints.h"
#include "InkStippleView.h"
#include "InkStippleWindow.h"
#include "InkView.h"
#include "InkWindowResources.h"

#include "InkOpenGLCompat.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkInkStippleMapper);

namespace
{

/// How far behind a surface its own stipples may lie, in elements' sizes: on a mesh for rounding only, around
/// an iso-surface of a volume as far as the stipples of the voxels that it crosses.
constexpr double SurfaceOffset = 0.1;
constexpr double VolumeOffset = 1.5;

ink::HlsColor ToHls(const double rgb[3])
{
  return ink::hlsFromRgb(glm::vec3(rgb[0], rgb[1], rgb[2]));
}

ink::StippleTone MakeTone(vtkInkStippleMapper* mapper, bool surface)
{
  const auto number = [](double value) { return static_cast<float>(value); };
  ink::StippleTone tone;
  tone.surface = surface;
  tone.boundary = { mapper->GetBoundary(), number(mapper->GetKgc()), number(mapper->GetKgs()),
    number(mapper->GetKge()) };
  tone.silhouette = { mapper->GetSilhouette(), number(mapper->GetKsc()), number(mapper->GetKss()),
    number(mapper->GetKse()) };
  tone.resolution = { mapper->GetResolution(), number(mapper->GetKrc()), number(mapper->GetKnz()) };
  tone.lighting = { mapper->GetLighting(), number(mapper->GetKle()),
    number(std::cos(vtkMath::RadiansFromDegrees(mapper->GetFacingAngle()))), mapper->GetLightInk() };
  tone.distance = { mapper->GetDistance(), number(mapper->GetKde()), number(mapper->GetDistanceSize()) };
  tone.interior = { mapper->GetInterior(), number(mapper->GetKie()), number(mapper->GetInteriorSize()) };
  tone.smallElements = { mapper->GetSmallElements() == vtkInkStippleMapper::PROBABILITY
      ? ink::SmallElements::Way::probability
      : ink::SmallElements::Way::intensity,
    number(mapper->GetMinimumCoverage()), number(mapper->GetFade()) };
  tone.warmCool = { ToHls(mapper->GetWarmColor()), ToHls(mapper->GetCoolColor()),
    number(mapper->GetToneWeight()), number(mapper->GetDistanceWeight()), number(mapper->GetWarmCool()) };
  tone.valueEffect = number(mapper->GetValueEffect());
  tone.pixelsPerStipple = number(mapper->GetPixelsPerStipple());
  tone.diameter = number(mapper->GetStippleSize());
  tone.growing = mapper->GetGrowing();
  tone.appearBySize = mapper->GetAppearBySize();
  return tone;
}

} // namespace

class vtkInkStippleMapper::vtkInternals
{
public:
  InkStipplePoints Points;
  std::optional<InkStippleInput::Key> PointsKey; ///< of the input that Points was read from
  InkReportedMessages Reported;
  InkWindowResources<InkStippleWindow> Windows;
  vtkIdType Processed = 0; ///< stipples that the last picture had to look at
};

/// All that one picture of an actor depends on, put together.
class vtkInkStippleMapper::vtkPicture
{
public:
  vtkPicture(vtkInkStippleMapper* mapper, InkStippleWindow& window, vtkRenderer* renderer, vtkActor* actor,
    const int size[2])
    : View(renderer, actor, mapper, mapper->Internals->Points.GetFrame(), size)
    , Tone(MakeTone(mapper, mapper->Internals->Points.IsSurface()))
    , ToneView(renderer, this->View, mapper->Internals->Points, this->Tone, mapper->Headlight)
    , Occluder(this->FindOccluder(mapper, window, renderer, actor))
    , Scene{ this->View, mapper->Internals->Points, this->Tone, this->ToneView, this->Occluder,
      FindOffset(mapper) * this->View.Unit, mapper->InkColor }
  {
    this->Tone.twoSided = this->Occluder && !actor->GetProperty()->GetBackfaceCulling();
  }
  vtkPicture(const vtkPicture&) = delete;
  void operator=(const vtkPicture&) = delete;

private:
  InkStippleDepth* FindOccluder(
    vtkInkStippleMapper* mapper, InkStippleWindow& window, vtkRenderer* renderer, vtkActor* actor) const
  {
    vtkPolyData* surface = mapper->FindSurface();
    if (!surface)
    {
      return nullptr;
    }
    window.Occluder.Update(surface, mapper->Internals->Points.GetFrame());
    if (window.Occluder.IsEmpty())
    {
      return nullptr;
    }
    std::unique_ptr<InkStippleDepth>& depth = window.FindDepth(renderer, actor);
    window.Occluder.Draw(this->View, window.Passes.FindReach(this->View, this->Tone, this->ToneView), depth);
    if (!depth->Complete)
    {
      mapper->ReportOnce("This OpenGL cannot draw into 32-bit depth images, which hidden stipples need.");
      return nullptr;
    }
    return depth.get();
  }

  static float FindOffset(vtkInkStippleMapper* mapper)
  {
    const InkStipplePoints& points = mapper->Internals->Points;
    const double automatic = points.IsSurface() ? SurfaceOffset : VolumeOffset;
    return static_cast<float>(mapper->OccluderOffset < 0.0 ? automatic : mapper->OccluderOffset) *
      points.GetElementSize();
  }

  const InkView View;
  ink::StippleTone Tone;
  const InkStippleView ToneView;
  InkStippleDepth* const Occluder;

public:
  const InkStipplePasses::Scene Scene;
};

vtkInkStippleMapper::vtkInkStippleMapper()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(2);
  this->ScalarVisibility = 0;
}

vtkInkStippleMapper::~vtkInkStippleMapper() = default;

int vtkInkStippleMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkInkStippleMapper::SetSurfaceData(vtkPolyData* surface)
{
  // Changes nothing where it is the same.
  this->SetInputDataObject(1, surface);
}

void vtkInkStippleMapper::SetSurfaceConnection(vtkAlgorithmOutput* surface)
{
  this->SetInputConnection(1, surface);
}

vtkPolyData* vtkInkStippleMapper::FindSurface()
{
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    return vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0));
  }
  vtkAlgorithm* generator =
    this->SurfaceFromInput && this->Internals->Points.IsSurface() && this->GetNumberOfInputConnections(0) > 0
    ? this->GetInputAlgorithm(0, 0)
    : nullptr;
  if (generator && generator->GetNumberOfInputPorts() > 0 && generator->GetNumberOfInputConnections(0) > 0)
  {
    return vtkPolyData::SafeDownCast(generator->GetInputDataObject(0, 0));
  }
  return nullptr;
}

void vtkInkStippleMapper::ReportOnce(const std::string& error)
{
  if (this->Internals->Reported.Add(this->GetInput()->GetMTime(), error))
  {
    vtkErrorMacro(<< error);
  }
}

void vtkInkStippleMapper::ComputeBounds()
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
}

InkStippleWindow* vtkInkStippleMapper::UpdateStipples(vtkRenderer* renderer)
{
  vtkInternals& internals = *this->Internals;
  vtkPolyData* input = this->GetInput();
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  auto* renderWindow = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!renderWindow)
  {
    this->ReportOnce("Stipples need a vtkOpenGLRenderWindow.");
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

  InkStippleWindow& window = internals.Windows.Get(renderWindow);
  const InkStippleInput found(input);
  const InkStippleWindow::Source source{ found.GetKey(), this->PositionPrecision };
  if ((window.Stipples != source || internals.PointsKey != source.Input) &&
    !this->UploadStipples(found, window))
  {
    return nullptr;
  }
  const InkScalarColors colors(this, input, InkScalarColors::Of::Cells);
  if (!colors.GetProblem().empty())
  {
    this->ReportOnce(colors.GetProblem());
  }
  std::string description = colors.Describe();
  if (window.Colors != description)
  {
    window.Passes.UploadColors(
      colors.Exist() ? internals.Points.OrderColors(colors.Map()) : std::vector<std::uint32_t>());
    window.Colors = std::move(description);
  }
  if (internals.Points.GetNumberOfStipples() == 0)
  {
    std::ostringstream message;
    message << "None of the " << input->GetNumberOfPoints()
            << " stipples has a finite position and an element with a normal that is not zero.";
    this->ReportOnce(message.str());
    return nullptr;
  }
  return &window;
}

bool vtkInkStippleMapper::UploadStipples(const InkStippleInput& input, InkStippleWindow& window)
{
  window.Stipples.reset();
  window.Colors.reset();
  const std::string problem = input.FindProblem();
  if (!problem.empty())
  {
    this->ReportOnce(problem);
    return false;
  }
  InkStipplePoints& points = this->Internals->Points;
  const std::string left = points.Read(input);
  this->Internals->PointsKey = input.GetKey();
  const std::string refused = window.Passes.Upload(points, this->PositionPrecision == QUANTIZED);
  points.ReleaseArrays();
  for (const std::string& message : { left, refused })
  {
    if (!message.empty())
    {
      this->ReportOnce(message);
    }
  }
  if (!refused.empty())
  {
    return false;
  }
  window.Stipples = { input.GetKey(), this->PositionPrecision };
  return true;
}

void vtkInkStippleMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->InvokeEvent(vtkCommand::StartEvent);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
    if (this->GetNumberOfInputConnections(1) > 0)
    {
      this->GetInputAlgorithm(1, 0)->Update();
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
  if (InkStippleWindow* window = this->UpdateStipples(renderer))
  {
    this->Draw(*window, renderer, actor, selector);
    this->Internals->Processed = window->Passes.GetNumberOfProcessedStipples();
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
  this->UpdateProgress(1.0);
}

void vtkInkStippleMapper::Draw(
  InkStippleWindow& window, vtkRenderer* renderer, vtkActor* actor, vtkHardwareSelector* selector)
{
  InkStipplePasses& passes = window.Passes;
  // Not the renderer's own: depth peeling draws into buffers of its own.
  int viewport[4];
  passes.GetWindow()->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] <= 0 || viewport[3] <= 0)
  {
    return;
  }
  const vtkPicture picture(this, window, renderer, actor, viewport + 2);
  if (!selector)
  {
    passes.Draw(picture.Scene, viewport, actor->GetProperty()->GetOpacity(), InkRenderPasses(this, actor));
    return;
  }

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
  passes.DrawIds(picture.Scene, viewport, idShift, color);
}

bool vtkInkStippleMapper::FindMarks(vtkRenderer* renderer, vtkActor* actor, vtkFloatArray* marks)
{
  marks->Initialize();
  marks->SetNumberOfComponents(6);
  if (!renderer->GetRenderWindow() || !this->GetInput())
  {
    return false;
  }
  renderer->GetRenderWindow()->MakeCurrent();
  const int* size = renderer->GetSize();
  InkStippleWindow* window = size[0] > 0 && size[1] > 0 ? this->UpdateStipples(renderer) : nullptr;
  if (!window)
  {
    return false;
  }
  const vtkPicture picture(this, *window, renderer, actor, size);
  const vtkIdType count = this->GetInput()->GetNumberOfPoints();
  const std::vector<float> results = window->Passes.FindResults(picture.Scene, count);
  if (results.empty())
  {
    return false;
  }
  marks->SetNumberOfTuples(count);
  std::copy(results.begin(), results.end(), marks->GetPointer(0));
  return true;
}

void vtkInkStippleMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Windows.Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

vtkMTimeType vtkInkStippleMapper::GetUploadTime()
{
  vtkMTimeType latest = 0;
  this->Internals->Windows.ForEach(
    [&](const InkStippleWindow& window) { latest = std::max(latest, window.Passes.GetUploadTime()); });
  return latest;
}

vtkMTimeType vtkInkStippleMapper::GetColorUploadTime()
{
  vtkMTimeType latest = 0;
  this->Internals->Windows.ForEach(
    [&](const InkStippleWindow& window) { latest = std::max(latest, window.Passes.GetColorUploadTime()); });
  return latest;
}

vtkIdType vtkInkStippleMapper::GetNumberOfProcessedStipples()
{
  return this->Internals->Processed;
}
