// SPDX-License-Identifier: BSD-3-Clause
#include "RenderCommand.h"

#include "Drawing.h"
#include "Errors.h"
#include "Graphics.h"
#include "OutputFile.h"
#include "Pattern.h"
#include "Picture.h"
#include "Progress.h"
#include "RenderFrames.h"

#include "vtkImageData.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <iostream>

namespace ink::cli
{
PictureSize PictureSize::parse(const std::string& text)
{
  static const io::Pattern pattern(R"((\d{1,9})x(\d{1,9}))");
  const std::string problem = "--size '" + text + "': ";
  const std::vector<std::string> match = pattern.match(text);
  if (match.empty())
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
  auto* lines = vtkInkSplattingLinesStyle::SafeDownCast(options.style);
  return !lines ? Wanted::Values : lines->GetIsoValues().empty() ? Wanted::Surface : Wanted::GivenSurfaces;
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
  const StyledScene subject = SceneMaker(options).make(input, progress);
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
