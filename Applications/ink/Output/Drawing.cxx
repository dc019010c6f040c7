// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing.h"

#include "Errors.h"
#include "Picture.h"
#include "RenderCommand.h"
#include "VtkMessages.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
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

// Part of the picture's half width and height that stays free around the drawing.
constexpr double margin = 0.05;

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

CameraFit Drawing::makeFit(const std::array<double, 3>& pivot) const
{
  const double aspect = static_cast<double>(this->Options.size.width) / this->Options.size.height;
  return { aspect, margin, this->Options.parallel, pivot };
}

vtkSmartPointer<vtkImageData> Drawing::draw(const StyledScene& subject, const CameraFit& fit, double turned)
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
  vtkNew<vtkCamera> camera;
  fit.apply(camera, this->view(turned));
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
