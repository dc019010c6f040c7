#include "RenderCommand.h"

#include "Drawing.h"
#include "Errors.h"
#include "Graphics.h"
#include "OutputFile.h"
#include "Picture.h"
#include "Progress.h"
#include "RenderFrames.h"
#include "Surface.h"

#include "vtkImageData.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkStippleMapper.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <regex>

namespace ink::cli
{
namespace
{

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

} // namespace

SubjectMaker::SubjectMaker(const RenderOptions& options, bool follow)
  : Options(options)
  , IsoValues(options.isoValues)
  , Meshes({ .count = options.samples, .priority = false, .cloud = options.cloud }, follow)
{
}

Subject SubjectMaker::make(const Input& input, Progress& progress)
{
  return this->Options.stipple ? this->makeStippling(input, progress) : this->makeLines(input, progress);
}

void SubjectMaker::keepIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress)
{
  if (this->IsoValues.empty() && input.isVolume())
  {
    this->IsoValues = chooseIsoValue(input, notes, progress);
  }
}

Subject SubjectMaker::makeLines(const Input& input, Progress& progress)
{
  Surface surface = makeSurface(input, this->IsoValues, this->Meshes, this->Options.input.memory, progress);
  Subject subject;
  subject.points = surface.points;
  subject.notes = std::move(surface.notes);
  this->Options.lines->SetInputData(subject.points);
  this->Options.lines->SetPaperVisibility(this->Options.paperColor.has_value());
  if (this->Options.paperColor)
  {
    this->Options.lines->SetPaperColor(this->Options.paperColor->data());
  }
  subject.mapper = this->Options.lines;
  subject.background = this->Options.background;
  return subject;
}

Subject SubjectMaker::makeStippling(const Input& input, Progress& progress) const
{
  const RenderOptions& options = this->Options;
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

Wanted wantedOf(const RenderOptions& options)
{
  return options.stipple        ? Wanted::Values
    : options.isoValues.empty() ? Wanted::Surface
                                : Wanted::GivenSurfaces;
}

void requireGraphics()
{
  const Graphics graphics = probeGraphics();
  if (!graphics.works)
  {
    throw Failure(graphics.description);
  }
}

void render(const RenderOptions& options)
{
  if (options.animation)
  {
    renderFrames(options);
    return;
  }
  // What can fail soon should not fail late.
  const OutputFile output(options.output);
  requireGraphics();

  Progress progress(options.quiet);
  const Input input = readInput(options.input, progress, wantedOf(options));
  const Subject subject = SubjectMaker(options).make(input, progress);
  progress.step("drawing");
  Drawing drawing(options);
  CameraFit fit = drawing.makeFit();
  fit.add(subject.points->GetPoints(), drawing.view());
  const auto picture = drawing.draw(subject, fit);
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
