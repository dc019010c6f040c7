// SPDX-License-Identifier: BSD-3-Clause
#include "RenderCommand.h"

#include "Drawing.h"
#include "Errors.h"
#include "Graphics.h"
#include "OutputFile.h"
#include "Pattern.h"
#include "PictureFile.h"
#include "Progress.h"
#include "RenderFrames.h"
#include "Timings.h"

#include "vtkCamera.h"
#include "vtkInkCameraFit.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iostream>
#include <utility>
#include <vector>

namespace ink::cli
{

int PictureSize::longestTile() const
{
  const bool atOnce = std::max(this->width, this->height) <= longestWindow &&
    static_cast<long long>(this->width) * this->height <= mostPixelsAtOnce;
  return this->tile > 0 ? this->tile : atOnce ? longestWindow : usualTile;
}

PictureSize PictureSize::parse(const std::string& text)
{
  static const io::Pattern pattern(R"((\d{1,9})(?:x(\d{1,9}))?)");
  const std::string problem = "--size '" + text + "': ";
  const std::vector<std::string> match = pattern.match(text);
  if (match.empty())
  {
    throw UsageError(problem + "expected WxH or, of a square, one number in pixels, as 1600x1200 or 1024");
  }
  const PictureSize size{ std::stoi(match[1]), std::stoi(match[match[2].empty() ? 1 : 2]) };
  if (size.width < 1 || size.height < 1 || size.width > longestSide || size.height > longestSide ||
    static_cast<long long>(size.width) * size.height > mostPixels)
  {
    throw UsageError(problem + "expected 1 to " + std::to_string(longestSide) +
      " pixels a side and at most " + std::to_string(mostPixels / 1'000'000) + " million in all");
  }
  return size;
}

Wanted wantedOf(const RenderOptions& options)
{
  vtkInkStyle* style = options.style;
  return !linesOf(style)                               ? Wanted::Values
    : style->GetParameterAsString("IsoValues").empty() ? Wanted::Surface
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
  Timings timings;
  const Input input = readInput(options.input, progress, wantedOf(options));
  timings.end("reading");
  Drawing drawing(options);
  std::vector<std::string> looked = drawing.look(input, options.input.file);
  const auto lookAtFrame = [&](vtkPoints* frame)
  {
    const std::vector<std::string> notes = drawing.lookAtFrame(frame);
    looked.insert(looked.end(), notes.begin(), notes.end());
  };
  options.style->SetStillCamera(
    [&](vtkPoints* frame)
    {
      lookAtFrame(frame);
      return drawing.stillCamera(frame);
    });
  const StyledScene subject = SceneMaker(options).make(input, progress);
  options.style->SetStillCamera(nullptr);
  timings.end("generating");
  progress.step("drawing");
  lookAtFrame(subject.frame);
  const auto fit = drawing.makeFit();
  fit->AddPoints(subject.frame, drawing.camera());
  writePicture(output, options.output, drawing.layout(),
    [&](const RowSink& sink) { drawing.draw(subject, fit, sink, progress.watcher()); });
  progress.finish();
  timings.endDrawing();

  if (!options.quiet)
  {
    for (const auto* notes : { &input.notes, &subject.notes, &std::as_const(looked) })
    {
      for (const std::string& note : *notes)
      {
        std::cerr << "ink: " << note << '\n';
      }
    }
    if (options.timings)
    {
      std::cerr << "ink: " << timings.text() << '\n';
    }
    std::cerr << "ink: wrote " << describe(options.output, drawing.layout()) << '\n';
  }
}

} // namespace ink::cli
