// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include "Errors.h"
#include "Picture.h"
#include "RenderCommand.h"
#include "VtkMessages.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkInkCameraFit.h"
#include "vtkInkStyle.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace ink::cli
{
namespace
{

// What is near a tile's border depends on what lies beyond it, in rendered pixels.
constexpr int tileOverlap = 64;

using Color = std::array<double, 3>;

Tiles tilesOf(const RenderOptions& options)
{
  const int factor = options.size.supersampling();
  return { options.size.width * factor, options.size.height * factor, factor * options.size.longestTile(),
    tileOverlap, factor };
}

/// Tells how far a picture is that is drawn in parts.
class PartsProgress
{
public:
  PartsProgress(vtkMapper* mapper, std::size_t parts, const std::function<void(double)>& progress)
    : Mapper(mapper)
    , Parts(static_cast<double>(parts))
    , Told(progress)
  {
    if (progress)
    {
      progress(0.0);
      this->Observer = mapper->AddObserver(vtkCommand::ProgressEvent, this, &PartsProgress::tell);
    }
  }
  ~PartsProgress()
  {
    if (this->Told)
    {
      this->Mapper->RemoveObserver(this->Observer);
    }
  }
  PartsProgress(const PartsProgress&) = delete;
  PartsProgress& operator=(const PartsProgress&) = delete;

  void endPart() { this->Done += 1.0; }

private:
  void tell()
  {
    // A mapper may draw what is opaque first, and then what is translucent.
    this->Most = std::max(this->Most, (this->Done + this->Mapper->GetProgress()) / this->Parts);
    this->Told(this->Most);
  }

  vtkMapper* const Mapper;
  const double Parts;
  const std::function<void(double)>& Told;
  unsigned long Observer = 0;
  double Done = 0.0;
  double Most = 0.0;
};

} // namespace

Drawing::Drawing(const RenderOptions& options)
  : Options(options)
  , Grid(tilesOf(options))
{
  this->Renderer->AddActor(this->Actor);
  this->Window->OffScreenRenderingOn();
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(this->Grid.windowWidth(), this->Grid.windowHeight());
  this->Window->AddRenderer(this->Renderer);
  if (!this->Grid.isWhole())
  {
    // The renderer fills the window, whichever tile that is; mappers see how high the picture is.
    const double part = 1.0 / this->Grid.scale();
    this->Window->SetTileScale(this->Grid.scale());
    this->Window->SetTileViewport(0.0, 0.0, part, part);
    this->Renderer->SetViewport(
      0.0, 0.0, 1.0, static_cast<double>(this->Grid.height()) / this->Window->GetSize()[1]);
  }
  // Mappers enlarge what is in pixels by the tiles' scale.
  options.style->SetPixelScale(static_cast<double>(options.size.supersampling()) / this->Grid.scale());
}

Drawing::~Drawing() = default;

std::vector<std::string> Drawing::look(const Input& input, const std::filesystem::path& file)
{
  vtkInkView* view = this->View;
  if (this->Options.up)
  {
    view->SetUp(*this->Options.up);
  }
  if (this->Options.view)
  {
    view->SetName(*this->Options.view);
  }
  if (this->Options.azimuth || this->Options.position)
  {
    view->SetAzimuth(this->Options.azimuth.value_or(0.0));
  }
  if (this->Options.elevation || this->Options.position)
  {
    view->SetElevation(this->Options.elevation.value_or(0.0));
  }
  // Of what is read in parts, how it lies.
  const auto data = input.data ? input.data : vtkSmartPointer<vtkDataObject>(frameOf(input));
  view->Choose(data, file.c_str());
  vtkNew<vtkInkView> usual;
  std::vector<std::string> notes;
  if (!this->Options.up && view->GetUp() != usual->GetUp())
  {
    notes.push_back("the mesh seems to stand with " + view->GetUp() + " up; --up says otherwise");
  }
  if (!this->Options.view && view->GetName() != usual->GetName())
  {
    notes.push_back("the " + view->GetName() + " of the mesh shows most and is drawn; --view says otherwise");
  }
  if (!this->Options.azimuth && view->GetAzimuth() > 0.0)
  {
    notes.emplace_back(
      "from straight ahead only one flat face of the mesh is seen, so it is seen at an angle; "
      "--azimuth and --elevation say otherwise");
  }
  else if (!this->Options.elevation && view->GetElevation() > 0.0)
  {
    notes.emplace_back("the mesh lies flat, so it is seen from above; --elevation says otherwise");
  }
  return notes;
}

std::vector<std::string> Drawing::lookAtFrame(vtkPoints* frame)
{
  const std::string before = this->View->GetName();
  const std::pair angles(this->View->GetAzimuth(), this->View->GetElevation());
  if (!this->HasFrame && !this->Options.position)
  {
    this->View->ChooseForFrame(frame, this->Options.style->IsSeenThrough());
  }
  this->HasFrame = true;
  if (angles != std::pair(this->View->GetAzimuth(), this->View->GetElevation()))
  {
    return {
      "what is drawn is cut to a slab, so it is seen at an angle; --view says otherwise, and stipples of "
      "voxels (--style stipple --stipple-source volume) show what lies within it"
    };
  }
  const std::string& name = this->View->GetName();
  if (name != before && name == "iso")
  {
    return { "what is drawn is a block, so it is seen from a corner; --view says otherwise" };
  }
  return name == before ? std::vector<std::string>()
                        : std::vector{ "what is drawn shows more from its " + name +
                            " than from its front, so that is seen; --view says otherwise" };
}

vtkSmartPointer<vtkCamera> Drawing::camera(double turned) const
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  this->View->Apply(camera, turned);
  camera->SetParallelProjection(this->Options.parallel);
  return camera;
}

vtkSmartPointer<vtkInkCameraFit> Drawing::makeFit() const
{
  auto fit = vtkSmartPointer<vtkInkCameraFit>::New();
  fit->SetAspect(static_cast<double>(this->Options.size.width) / this->Options.size.height);
  return fit;
}

vtkSmartPointer<vtkCamera> Drawing::stillCamera(vtkPoints* frame) const
{
  const auto fit = this->makeFit();
  fit->AddPoints(frame, this->camera());
  auto camera = this->placedCamera(fit, 0.0);
  camera->SetExplicitAspectRatio(fit->GetAspect());
  return camera;
}

io::PictureLayout Drawing::layout() const
{
  const PictureSize& size = this->Options.size;
  return { size.width, size.height, this->Options.transparent ? 4 : 3, this->Options.dotsPerInch };
}

vtkSmartPointer<vtkCamera> Drawing::placedCamera(vtkInkCameraFit* fit, double turned) const
{
  const auto camera = this->camera(turned);
  double along[3];
  camera->GetDirectionOfProjection(along);
  fit->Apply(camera);
  camera->Zoom(this->Options.zoom);
  const auto& [position, focalPoint] = std::tie(this->Options.position, this->Options.focalPoint);
  double from[3];
  double to[3];
  camera->GetPosition(from);
  camera->GetFocalPoint(to);
  for (std::size_t i = 0; i < 3; ++i)
  {
    // The viewer goes along with the focal point.
    const double moved = focalPoint && !position ? (*focalPoint)[i] - to[i] : 0.0;
    from[i] = position ? (*position)[i] : from[i] + moved;
    to[i] = focalPoint ? (*focalPoint)[i] : to[i];
  }
  camera->SetPosition(from);
  camera->SetFocalPoint(to);
  double direction[3];
  vtkMath::Subtract(to, from, direction);
  if (vtkMath::Normalize(direction) == 0.0)
  {
    throw UsageError("--position: expected another point than the focal point");
  }
  double right[3];
  double up[3];
  camera->GetViewUp(up);
  vtkMath::Cross(direction, up, right);
  if (vtkMath::Norm(right) < 1e-6)
  {
    // Seen from straight above or below.
    camera->SetViewUp(along);
  }
  camera->Roll(this->Options.roll);
  return camera;
}

void Drawing::aim(vtkCamera* camera, const Tiles::Strip& column, const Tiles::Strip& row) const
{
  const int width = this->Options.size.width * this->Options.size.supersampling();
  const int height = this->Options.size.height * this->Options.size.supersampling();
  const int tileWidth = this->Grid.windowWidth();
  const int tileHeight = this->Grid.windowHeight();
  const double part = static_cast<double>(tileHeight) / height;
  const double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(part * std::tan(angle / 2.0))));
  camera->SetParallelScale(part * camera->GetParallelScale());
  const double left = column.first - column.before;
  const double bottom = height - (row.first - row.before) - tileHeight;
  camera->SetWindowCenter(
    (2.0 * left + tileWidth - width) / tileWidth, (2.0 * bottom + tileHeight - height) / tileHeight);
}

void Drawing::draw(const StyledScene& subject, vtkInkCameraFit* fit, const RowSink& sink,
  const std::function<void(double)>& progress, double turned)
{
  const VtkMessages messages;
  vtkInkStyle* style = subject.style;
  this->Actor->SetMapper(style->GetMapper());
  this->Actor->SetProperty(style->GetActor()->GetProperty());
  if (style->GetLight() != this->Light)
  {
    this->Renderer->RemoveAllLights();
    this->Renderer->AddLight(style->GetLight());
    this->Light = style->GetLight();
  }
  Color background;
  style->GetBackgroundColor(background.data());
  const bool transparent = this->Options.transparent;
  const std::vector<Color> backgrounds =
    transparent ? std::vector<Color>{ { 0, 0, 0 }, { 1, 1, 1 } } : std::vector<Color>{ background };
  std::vector<PictureRows> pictures(backgrounds.size());
  const int factor = this->Options.size.supersampling();
  const auto& columns = this->Grid.columns();
  const auto& rows = this->Grid.rows();
  PartsProgress parts(style->GetMapper(), columns.size() * rows.size() * backgrounds.size(), progress);
  for (const Tiles::Strip& row : rows)
  {
    for (PictureRows& picture : pictures)
    {
      picture.resize(this->Options.size.width, row.length / factor);
    }
    for (const Tiles::Strip& column : columns)
    {
      const auto camera = this->placedCamera(fit, turned);
      this->Renderer->SetActiveCamera(camera);
      this->Renderer->ResetCameraClippingRange();
      this->aim(camera, column, row);
      const WindowPart used{ column.before, this->Grid.windowHeight() - row.before - row.length,
        column.length, row.length };
      for (std::size_t i = 0; i < backgrounds.size(); ++i)
      {
        Color color = backgrounds[i];
        this->Renderer->SetBackground(color.data());
        this->Window->Render();
        takePicture(this->Window, used, factor, pictures[i], column.first / factor);
        parts.endPart();
      }
    }
    if (const std::string problem = messages.error(); !problem.empty())
    {
      throw Failure("drawing failed: " + problem);
    }
    if (transparent)
    {
      sink(findAlpha(pictures[0].pixels, pictures[1].pixels));
    }
    else
    {
      sink(pictures[0].pixels);
    }
  }
}

} // namespace ink::cli
