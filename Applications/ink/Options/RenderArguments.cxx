// SPDX-License-Identifier: BSD-3-Clause
#include "RenderArguments.h"

#include "Errors.h"
#include "FrameChoice.h"
#include "Pattern.h"
#include "Series.h"
#include "Video.h"

#include "vtkInkStyle.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace ink::cli
{
void RenderArguments::add(CLI::App* command, const std::string& styleName, bool all)
{
  this->app = command;
  this->input.addFile(command, "mesh or points");
  command
    ->add_option("-o,--output", this->output,
      "the picture to write; of several frames out_%04d.png, or a video: .mp4, .webm or .gif")
    ->required()
    ->type_name("OUT.png");
  command
    ->add_option("--style", this->style,
      "way of drawing: splatting-lines or stipple (splatting-lines); 'ink render --style NAME --help' shows "
      "its options")
    ->type_name("NAME")
    ->check(CLI::IsMember(StyleArguments::names()));
  std::vector<std::string> views;
  for (const auto& [name, view] : namedViews())
  {
    views.push_back(name);
  }
  command
    ->add_option("--view", this->options.view,
      "side to look at: front, back, left, right, top, bottom, or iso, from the front, left and top at "
      "once (front).\n"
      "World axes are read as DICOM's: +x is the subject's left, +y its back, +z its top and up in the "
      "picture;\n"
      "from the top and the bottom, +y and -y are up. Orientations in NIfTI and NRRD files are turned to "
      "these")
    ->type_name("NAME")
    ->check(CLI::IsMember(views));
  command->add_option("--size", this->size, "size of the picture in pixels (1024x1024)")->type_name("WxH");
  command->add_flag("-q,--quiet", this->options.quiet, "print nothing but errors");

  const auto angle = within(-360, 360);
  command->add_option("--azimuth", this->options.azimuth, "go to the right around the subject, degrees (0)")
    ->check(angle)
    ->group("Camera");
  command->add_option("--elevation", this->options.elevation, "then go up, degrees (0)")
    ->check(angle)
    ->group("Camera");
  command->add_option("--zoom", this->options.zoom, "enlarge; at 1 all of the subject fits (1)")
    ->check(within(0.01, 1000))
    ->group("Camera");
  command->add_flag("--parallel", this->options.parallel, "parallel instead of perspective projection")
    ->group("Camera");

  command->add_flag(
    "--transparent", this->options.transparent, "nothing around the subject: a PNG with alpha");

  this->addAnimation(command);
  this->input.addReading(command);
  this->parameters.add(command, styleName, all);
}

void RenderArguments::addAnimation(CLI::App* command)
{
  constexpr const char* group =
    "Animation: FILE can be a .pvd, a .series, or a pattern as 'step_*.ply' or step_%d.vti";
  command
    ->add_option("--frames", this->frames,
      "N: so many pictures, evenly from the first to the last step of a series, or once around what stands\n"
      "still; A:B or A:B:S: from step A of a series to step B, from 0 on, every S-th (all steps)")
    ->type_name("N|A:B:S")
    ->group(group);
  command->add_option("--fps", this->framesPerSecond, "pictures a second in a video (25)")
    ->check(within(0.1, 1000))
    ->group(group);
}

std::optional<Animation> RenderArguments::animation() const
{
  const std::filesystem::path file = this->input.file;
  const bool series = isSeries(file);
  if (!series && this->app->count("--frames") == 0)
  {
    return std::nullopt;
  }
  Animation animation;
  animation.framesPerSecond = this->framesPerSecond;
  const std::string name = this->options.style->GetName();
  if (series && name != "splatting-lines")
  {
    throw UsageError("--style " + name + ": expected one file, found a series; lines are drawn of series");
  }
  if (series)
  {
    animation.files = filesOfSeries(file);
    animation.frames = chooseSteps(this->frames, animation.files.size());
  }
  else
  {
    animation.frames.resize(turntableFrames(this->frames));
  }
  return animation;
}

void RenderArguments::checkOutput() const
{
  const std::filesystem::path& file = this->options.output;
  const bool video = Video::isVideo(file);
  if (!this->options.animation)
  {
    if (video)
    {
      throw UsageError("-o '" + this->output + "': expected --frames or a series of files for a video");
    }
    if (file.extension() != ".png")
    {
      throw UsageError("-o '" + this->output + "': expected a name that ends in .png");
    }
    return;
  }
  static const io::Pattern numbered(R"([^%]*%(0?[1-9])?d[^%]*\.png)");
  if (!video && numbered.match(file.filename().string()).empty())
  {
    throw UsageError("-o '" + this->output +
      "': expected a name with a number for several frames, as out_%04d.png, or .mp4, .webm or .gif for a "
      "video");
  }
  if (video && this->options.transparent)
  {
    throw UsageError("--transparent: expected pictures, as out_%04d.png, found a video");
  }
}

void RenderArguments::run()
{
  this->options.input = this->input.options();
  this->options.output = this->output;
  this->options.size = PictureSize::parse(this->size);
  this->options.style = this->parameters.make(PictureSize::supersampling);
  this->options.parameters = &this->parameters;
  this->options.style->SetPictureSize(
    this->options.zoom * std::max(this->options.size.width, this->options.size.height));
  this->options.animation = this->animation();
  this->checkOutput();
  render(this->options);
}

} // namespace ink::cli
