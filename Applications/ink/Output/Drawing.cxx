// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include "Errors.h"
#include "Picture.h"
#include "RenderCommand.h"
#include "VtkMessages.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInkCameraFit.h"
#include "vtkInkStyle.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>

namespace ink::cli
{
namespace
{

using Color = std::array<double, 3>;

} // namespace

Drawing::Drawing(const RenderOptions& options)
  : Options(options)
{
  this->Renderer->AddActor(this->Actor);
  this->Window->OffScreenRenderingOn();
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(
    options.size.width * PictureSize::supersampling, options.size.height * PictureSize::supersampling);
  this->Window->AddRenderer(this->Renderer);
}

Drawing::~Drawing() = default;

View Drawing::view(double turned) const
{
  View view = namedViews().at(this->Options.view);
  const View named = view;
  view.rotate(this->Options.azimuth, this->Options.elevation);
  view.turnAround(named.up, turned);
  return view;
}

vtkSmartPointer<vtkCamera> Drawing::camera(double turned) const
{
  const View view = this->view(turned);
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(-view.direction[0], -view.direction[1], -view.direction[2]);
  camera->SetViewUp(view.up);
  camera->SetParallelProjection(this->Options.parallel);
  return camera;
}

vtkSmartPointer<vtkInkCameraFit> Drawing::makeFit() const
{
  auto fit = vtkSmartPointer<vtkInkCameraFit>::New();
  fit->SetAspect(static_cast<double>(this->Options.size.width) / this->Options.size.height);
  return fit;
}

vtkSmartPointer<vtkImageData> Drawing::draw(const StyledScene& subject, vtkInkCameraFit* fit, double turned)
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
  const auto camera = this->camera(turned);
  fit->Apply(camera);
  camera->Zoom(this->Options.zoom);
  this->Renderer->SetActiveCamera(camera);
  this->Renderer->ResetCameraClippingRange();

  const auto drawOn = [&](Color background)
  {
    this->Renderer->SetBackground(background.data());
    this->Window->Render();
    return takePicture(this->Window, PictureSize::supersampling);
  };
  Color background;
  style->GetBackgroundColor(background.data());
  auto picture =
    this->Options.transparent ? findAlpha(drawOn({ 0, 0, 0 }), drawOn({ 1, 1, 1 })) : drawOn(background);
  if (const std::string problem = messages.error(); !problem.empty())
  {
    throw Failure("drawing failed: " + problem);
  }
  return picture;
}

} // namespace ink::cli
