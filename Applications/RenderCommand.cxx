#include "RenderCommand.h"

#include "Errors.h"
#include "FitCamera.h"
#include "Graphics.h"
#include "OutputFile.h"
#include "Picture.h"
#include "Progress.h"
#include "Surface.h"
#include "VtkMessages.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkStippleMapper.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <regex>

namespace ink::cli
{
namespace
{

// Part of the picture's half width and height that stays free around the drawing.
constexpr double margin = 0.05;

/// Light that stays with the viewer.
/// \param azimuth, elevation where it comes from: degrees to the right of the viewer and above
vtkSmartPointer<vtkLight> makeLight(double azimuth, double elevation)
{
  const double right = vtkMath::RadiansFromDegrees(azimuth);
  const double up = vtkMath::RadiansFromDegrees(elevation);
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToCameraLight();
  light->SetFocalPoint(0, 0, 0);
  light->SetPosition(std::sin(right) * std::cos(up), std::sin(up), std::cos(right) * std::cos(up));
  return light;
}

/// What is drawn, before it has a camera.
struct Subject
{
  vtkSmartPointer<vtkPolyData> points;
  vtkSmartPointer<vtkMapper> mapper;
  vtkSmartPointer<vtkLight> light; ///< null: the mapper needs none
  Color background;
  std::vector<std::string> notes;
};

Subject makeLines(const Input& input, const RenderOptions& options, Progress& progress)
{
  Surface surface =
    makeSurface(input, options.isoValues, options.samples, options.cloud, options.input.memory, progress);
  Subject subject;
  subject.points = surface.points;
  subject.notes = std::move(surface.notes);
  options.lines->SetInputData(subject.points);
  options.lines->SetPaperVisibility(options.paperColor.has_value());
  if (options.paperColor)
  {
    options.lines->SetPaperColor(options.paperColor->data());
  }
  subject.mapper = options.lines;
  subject.background = options.background;
  return subject;
}

Subject makeStippling(const Input& input, const RenderOptions& options, Progress& progress)
{
  const StippleStyle& style = *options.stipple;
  const double pixels =
    options.zoom * std::max(options.size.width, options.size.height) * PictureSize::supersampling;
  Subject subject;
  subject.points =
    makeStipples(input, style, options.isoValues, options.samples, pixels, subject.notes, progress);
  subject.mapper = style.mapper;
  subject.light = makeLight(style.lightAzimuth, style.lightElevation);
  subject.background = style.paper;
  return subject;
}

vtkSmartPointer<vtkImageData> draw(const Subject& subject, const RenderOptions& options)
{
  const VtkMessages messages;
  vtkNew<vtkActor> actor;
  actor->SetMapper(subject.mapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  if (subject.light)
  {
    renderer->AddLight(subject.light);
  }
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(
    options.size.width * PictureSize::supersampling, options.size.height * PictureSize::supersampling);
  window->AddRenderer(renderer);

  View view = namedViews().at(options.view);
  view.rotate(options.azimuth, options.elevation);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double aspect = static_cast<double>(options.size.width) / options.size.height;
  fitCamera(camera, view, subject.points->GetPoints(), aspect, margin, options.parallel);
  camera->Zoom(options.zoom);
  renderer->ResetCameraClippingRange();

  const auto drawOn = [&](Color background)
  {
    renderer->SetBackground(background.data());
    window->Render();
    return takePicture(window, PictureSize::supersampling);
  };
  const auto picture =
    options.transparent ? findAlpha(drawOn({ 0, 0, 0 }), drawOn({ 1, 1, 1 })) : drawOn(subject.background);
  if (const std::string problem = messages.error(); !problem.empty())
  {
    throw Failure("drawing failed: " + problem);
  }
  return picture;
}

} // namespace

PictureSize PictureSize::parse(const std::string& text)
{
  static const std::regex pattern(R"((\d{1,9})x(\d{1,9}))");
  const std::string problem = "--size '" + text + "': ";
  std::smatch match;
  if (!std::regex_match(text, match, pattern))
  {
    throw UsageError(problem + "expected WxH in pixels, as 1600x1200");
  }
  const PictureSize size{ std::stoi(match[1]), std::stoi(match[2]) };
  if (size.width < 1 || size.height < 1 || size.width > largestSide || size.height > largestSide ||
    static_cast<long long>(size.width) * size.height > mostPixels)
  {
    throw UsageError(problem + "expected 1 to " + std::to_string(largestSide) +
      " pixels a side and at most " + std::to_string(mostPixels / 1'000'000) + " million in all");
  }
  return size;
}

void render(const RenderOptions& options)
{
  // What can fail soon should not fail late.
  const OutputFile output(options.output);
  const Graphics graphics = probeGraphics();
  if (!graphics.works)
  {
    throw Failure(graphics.description);
  }

  Progress progress(options.quiet);
  const Wanted wanted = options.stipple ? Wanted::Values
    : options.isoValues.empty()         ? Wanted::Surface
                                        : Wanted::GivenSurfaces;
  const Input input = readInput(options.input, progress, wanted);
  const Subject subject =
    options.stipple ? makeStippling(input, options, progress) : makeLines(input, options, progress);
  progress.step("drawing");
  const auto picture = draw(subject, options);
  progress.step("writing " + options.output.filename().string());
  const auto png = encodePng(picture);
  output.write({ png->GetPointer(0), static_cast<std::size_t>(png->GetNumberOfValues()) });
  progress.finish();

  if (!options.quiet)
  {
    for (const auto* notes : { &input.notes, &subject.notes })
    {
      for (const std::string& note : *notes)
      {
        std::cerr << "ink: " << note << '\n';
      }
    }
  }
}

} // namespace ink::cli
