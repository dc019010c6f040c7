// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleMapper.h"

#include "InkFrame.h"
#include "InkRenderPasses.h"
#include "InkScalarColors.h"
#include "InkStippleMarks.h"
#include "InkStipplePoints.h"
#include "InkStippleView.h"
#include "InkViewUniforms.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkInkStippleMapper);

namespace
{

/// How far behind a surface its own stipples may lie, in elements' sizes: on a mesh for rounding only, and so
/// no more than a pixel, around an iso-surface of a volume as far as the stipples of the voxels that it
/// crosses.
constexpr double SurfaceOffset = 0.1;
constexpr float MostSurfacePixels = 1.0f;
constexpr float AnyPixels = 1e9f;
constexpr double VolumeOffset = 1.5;
/// The same behind a surface of discs, which overlap, in their radii.
constexpr double DiscOffset = 0.5;

ink::HlsColor ToHls(const double rgb[3])
{
  return ink::hlsFromRgb(glm::vec3(rgb[0], rgb[1], rgb[2]));
}

ink::stipple::Tone MakeTone(vtkInkStippleMapper* mapper, bool surface, const InkViewUniforms& view)
{
  const auto number = [](double value) { return static_cast<float>(value); };
  ink::stipple::Tone tone;
  tone.surface = surface;
  tone.boundary = { mapper->GetBoundary(), number(mapper->GetBoundaryBase()),
    number(mapper->GetBoundaryGain()), number(mapper->GetBoundaryExponent()) };
  tone.silhouette = { mapper->GetSilhouette(), number(mapper->GetSilhouetteBase()),
    number(mapper->GetSilhouetteGain()), number(mapper->GetSilhouetteExponent()) };
  tone.resolution = { mapper->GetResolution(), number(mapper->GetResolutionExponent()),
    number(mapper->GetSlantExponent()) };
  tone.lighting = { mapper->GetLighting(), number(mapper->GetLightingExponent()),
    number(std::cos(vtkMath::RadiansFromDegrees(mapper->GetFacingAngle()))), mapper->GetLightInk() };
  tone.distance = { mapper->GetDistance(), number(mapper->GetDistanceExponent()),
    number(mapper->GetDistanceSize()) };
  tone.interior = { mapper->GetInterior(), number(mapper->GetInteriorExponent()),
    number(mapper->GetInteriorSize()) };
  tone.smallElements = { mapper->GetSmallElements() == vtkInkStippleMapper::PROBABILITY
      ? ink::stipple::SmallElements::Way::probability
      : ink::stipple::SmallElements::Way::intensity,
    number(mapper->GetMinimumCoverage()), number(mapper->GetFade()) };
  tone.warmCool = { ToHls(mapper->GetWarmColor()), ToHls(mapper->GetCoolColor()),
    number(mapper->GetToneWeight()), number(mapper->GetDistanceWeight()), number(mapper->GetWarmCool()) };
  tone.valueEffect = number(mapper->GetValueEffect());
  // Of the window, as sizes in pixels are.
  const double pixel = mapper->GetSizeUnit() == vtkInkStippleMapper::THOUSANDTHS
    ? 1e-3 * view.PictureHeight / view.TileScale
    : 1.0;
  tone.pixelsPerStipple = number(pixel * pixel * mapper->GetPixelsPerStipple());
  tone.diameter = number(pixel * mapper->GetStippleSize());
  tone.growWithZoom = mapper->GetGrowWithZoom();
  tone.fadeBySize = mapper->GetFadeBySize();
  return tone;
}

} // namespace

class vtkInkStippleMapper::vtkInternals
{
public:
  InkStipplePoints Points;
  std::optional<InkStippleInput::Key> PointsKey; ///< of the input that Points was read from
  vtkIdType Processed = 0;                       ///< stipples that the last picture had to look at
};

/// All that one picture of an actor depends on, put together.
class vtkInkStippleMapper::vtkPicture
{
public:
  vtkPicture(vtkInkStippleMapper* mapper, InkStippleMarks& marks, vtkRenderer* renderer, vtkActor* actor,
    const int size[2])
    : View(renderer, actor, mapper, mapper->Internals->Points.GetFrame(), size)
    , Tone(MakeTone(mapper, mapper->Internals->Points.IsSurface(), this->View))
    , ToneView(renderer, this->View, mapper->Internals->Points, this->Tone, mapper->GetHeadlight())
    , Occluder(this->FindOccluder(mapper, marks, renderer, actor))
    , Scene{ this->View, mapper->Internals->Points, this->Tone, this->ToneView, this->Occluder,
      FindOffset(mapper, marks) * this->View.Unit, FindMostPixels(mapper, marks), mapper->InkColor }
  {
    this->Tone.twoSided = this->Occluder && !actor->GetProperty()->GetBackfaceCulling();
  }
  vtkPicture(const vtkPicture&) = delete;
  void operator=(const vtkPicture&) = delete;

private:
  InkOccluderDepth* FindOccluder(
    vtkInkStippleMapper* mapper, InkStippleMarks& marks, vtkRenderer* renderer, vtkActor* actor) const
  {
    vtkPolyData* surface = mapper->FindSurface();
    if (!surface)
    {
      return nullptr;
    }
    const std::string problem = marks.Occluder.Update(surface, mapper->Internals->Points.GetFrame());
    if (!problem.empty())
    {
      mapper->ReportOnce(problem);
    }
    if (marks.Occluder.IsEmpty())
    {
      return nullptr;
    }
    std::unique_ptr<InkOccluderDepth>& depth = marks.Depths.Get(renderer, actor);
    marks.Occluder.Draw(this->View, marks.Passes.FindReach(this->View, this->Tone, this->ToneView), depth);
    if (!depth->Image.IsComplete())
    {
      mapper->ReportOnce("This OpenGL cannot draw into 32-bit depth images, which hidden stipples need.");
      return nullptr;
    }
    return depth.get();
  }

  static float FindOffset(vtkInkStippleMapper* mapper, const InkStippleMarks& marks)
  {
    const InkStipplePoints& points = mapper->Internals->Points;
    const bool automatic = mapper->OccluderOffset < 0.0;
    const double elements = !automatic ? mapper->OccluderOffset
      : points.IsSurface()             ? SurfaceOffset
                                       : VolumeOffset;
    const double discs = automatic ? DiscOffset : 0.0;
    return std::max(static_cast<float>(elements) * points.GetElementSize(),
      static_cast<float>(discs) * marks.Occluder.GetLargestRadius());
  }

  static float FindMostPixels(vtkInkStippleMapper* mapper, const InkStippleMarks& marks)
  {
    const bool onTriangles =
      mapper->Internals->Points.IsSurface() && marks.Occluder.GetLargestRadius() == 0.0f;
    return onTriangles && mapper->OccluderOffset < 0.0 ? MostSurfacePixels : AnyPixels;
  }

  const InkViewUniforms View;
  ink::stipple::Tone Tone;
  const InkStippleView ToneView;
  InkOccluderDepth* const Occluder;

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

std::unique_ptr<InkMarks> vtkInkStippleMapper::MakeMarks(vtkOpenGLRenderWindow* window)
{
  return std::make_unique<InkStippleMarks>(window);
}

bool vtkInkStippleMapper::UpdateMarks(InkMarks& own)
{
  auto& marks = static_cast<InkStippleMarks&>(own);
  vtkInternals& internals = *this->Internals;
  vtkPolyData* input = this->GetInput();
  const InkStippleInput found(input);
  const InkStippleMarks::Source source{ found.GetKey(), this->PositionPrecision };
  if ((marks.Stipples != source || internals.PointsKey != source.Input) &&
    !this->UploadStipples(found, marks))
  {
    return false;
  }
  const InkScalarColors colors(this, input, InkScalarColors::Of::Cells);
  if (!colors.GetProblem().empty())
  {
    this->ReportOnce(colors.GetProblem());
  }
  std::string description = colors.Describe();
  if (marks.Colors != description)
  {
    marks.Passes.UploadColors(
      colors.Exist() ? internals.Points.OrderColors(colors.Map()) : std::vector<std::uint32_t>());
    marks.Colors = std::move(description);
  }
  if (internals.Points.GetNumberOfStipples() == 0)
  {
    std::ostringstream message;
    message << "None of the " << input->GetNumberOfPoints()
            << " stipples has a finite position and an element with a normal that is not zero.";
    this->ReportOnce(message.str());
    return false;
  }
  return true;
}

bool vtkInkStippleMapper::UploadStipples(const InkStippleInput& input, InkStippleMarks& marks)
{
  marks.Stipples.reset();
  marks.Colors.reset();
  const std::string problem = input.FindProblem();
  if (!problem.empty())
  {
    this->ReportOnce(problem);
    return false;
  }
  InkStipplePoints& points = this->Internals->Points;
  const std::string left = points.Read(input);
  this->Internals->PointsKey = input.GetKey();
  const std::string refused = marks.Passes.Upload(points, this->PositionPrecision == QUANTIZED);
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
  marks.Stipples = { input.GetKey(), this->PositionPrecision };
  return true;
}

void vtkInkStippleMapper::DrawMarks(InkMarks& own, const InkFrame& frame)
{
  auto& marks = static_cast<InkStippleMarks&>(own);
  const vtkPicture picture(this, marks, frame.Renderer, frame.Actor, frame.GetSize());
  if (frame.Ids)
  {
    marks.Passes.DrawIds(picture.Scene, frame);
  }
  else
  {
    marks.Passes.Draw(
      picture.Scene, frame, frame.Actor->GetProperty()->GetOpacity(), InkRenderPasses(this, frame.Actor));
  }
  this->Internals->Processed = marks.Passes.GetNumberOfProcessedStipples();
}

bool vtkInkStippleMapper::EvaluateMarks(vtkRenderer* renderer, vtkActor* actor, vtkFloatArray* marks)
{
  marks->Initialize();
  marks->SetNumberOfComponents(6);
  if (!renderer->GetRenderWindow() || !this->GetInput())
  {
    return false;
  }
  renderer->GetRenderWindow()->MakeCurrent();
  const int* size = renderer->GetSize();
  InkMarks* own = size[0] > 0 && size[1] > 0 ? this->FindMarksToDraw(renderer) : nullptr;
  if (!own)
  {
    return false;
  }
  auto& stipples = static_cast<InkStippleMarks&>(*own);
  const vtkPicture picture(this, stipples, renderer, actor, size);
  const vtkIdType count = this->GetInput()->GetNumberOfPoints();
  const std::vector<float> results = stipples.Passes.FindResults(picture.Scene, count);
  if (results.empty())
  {
    return false;
  }
  marks->SetNumberOfTuples(count);
  std::copy(results.begin(), results.end(), marks->GetPointer(0));
  return true;
}

vtkMTimeType vtkInkStippleMapper::GetColorUploadTime()
{
  vtkMTimeType latest = 0;
  this->ForEachMarks([&](const InkMarks& marks)
    { latest = std::max(latest, static_cast<const InkStippleMarks&>(marks).Passes.GetColorUploadTime()); });
  return latest;
}

vtkIdType vtkInkStippleMapper::GetNumberOfProcessedStipples()
{
  return this->Internals->Processed;
}
