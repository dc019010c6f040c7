// SPDX-License-Identifier: BSD-3-Clause
#include "RenderArguments.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "FileSeries.h"
#include "FrameChoice.h"
#include "Pattern.h"
#include "PictureFile.h"
#include "StyledScene.h"
#include "Video.h"

#include "vtkInkStyle.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace ink::cli
{
namespace
{

/// All words of a list, sorted.
std::vector<std::string> wordsOf(int count, const char* (*word)(int))
{
  std::vector<std::string> words;
  for (int i = 0; i < count; ++i)
  {
    words.emplace_back(word(i));
  }
  std::sort(words.begin(), words.end());
  return words;
}

} // namespace

void RenderArguments::add(CLI::App* command, const std::string& styleName, bool all)
{
  this->app = command;
  this->input.addFile(command, "mesh or points");
  command
    ->add_option("OUT,-o,--output", this->output,
      "the picture to write, " + io::PictureEncoder::suffixes() +
        ", or - for a PNG to the standard output; of several\n"
        "frames out_%04d.png, or a video: .mp4, .webm or .gif")
    ->required()
    ->type_name("OUT.png");
  command
    ->add_option("--style", this->style,
      "way of drawing: illustration, contours, line-art, splatting-lines or stipple (illustration);\n"
      "'ink render --style NAME --help' shows its options")
    ->type_name("NAME")
    ->check(oneOf(StyleArguments::names()));
  command
    ->add_option("--view", this->options.view,
      "side to look at: front, back, left, right, top, bottom, or iso, from the front, left and top at "
      "once\n(front, or top or left of a volume that is flat from there, or iso of a block; of a mesh the "
      "side that shows most).\n"
      "World axes are read as DICOM's: +x is the subject's left, +y its back, +z its top and up in the "
      "picture;\n"
      "from the top and the bottom, +y and -y are up. Orientations in NIfTI and NRRD files are turned to "
      "these")
    ->type_name("NAME")
    ->check(oneOf(wordsOf(vtkInkView::GetNumberOfNames(), vtkInkView::GetNameOfView)));
  command->add_option("--size", this->size, "size of the picture in pixels, or the side of a square (1024)")
    ->type_name("WxH");
  command
    ->add_option("--dpi", this->options.dotsPerInch,
      "pixels an inch, which says how large the picture is printed (300); lengths in the drawing are parts "
      "of\n"
      "its height")
    ->check(within(1, 30000));
  command->add_flag("-q,--quiet", this->options.quiet, "print nothing but errors");
  command->add_flag("--timings", this->options.timings,
    "say of a single picture how long reading, generating, uploading and drawing took");

  const auto angle = within(-360, 360);
  command
    ->add_option(
      "--up", this->options.up, "axis that is up in the picture (z; of a mesh as it seems to stand)")
    ->type_name("AXIS")
    ->check(oneOf(wordsOf(vtkInkView::GetNumberOfAxes(), vtkInkView::GetAxis)))
    ->group("Camera");
  command
    ->add_option("--azimuth", this->options.azimuth,
      "go to the right around the subject, degrees (0; of a flat face 30)")
    ->check(angle)
    ->group("Camera");
  command
    ->add_option("--elevation", this->options.elevation,
      "then go up, degrees (0; of what lies flat 30, of a flat face 20)")
    ->check(angle)
    ->group("Camera");
  const auto addPoint = [command](const char* name, std::vector<double>& point, const char* text)
  {
    command->add_option(name, point, text)
      ->delimiter(',')
      ->expected(3)
      ->allow_extra_args(false)
      ->type_name("x,y,z")
      ->group("Camera")
      ->check(anyNumber());
  };
  addPoint("--position", this->position,
    "where the viewer stands, in the file's coordinates (where all of the subject is seen)");
  addPoint("--focal-point", this->focalPoint, "what is in the middle of the picture (the subject's)");
  command->add_option("--roll", this->options.roll, "turn the picture counterclockwise, degrees (0)")
    ->check(angle)
    ->group("Camera");
  command->add_option("--zoom", this->options.zoom, "enlarge; at 1 all of the subject fits (1)")
    ->check(within(0.01, 1000))
    ->group("Camera");
  command->add_flag("--parallel", this->options.parallel, "parallel instead of perspective projection")
    ->group("Camera");

  command->add_flag(
    "--transparent", this->options.transparent, "nothing around the subject: a PNG or TIFF with alpha");
  command
    ->add_option("--tile", this->tile,
      "draw in tiles of so many pixels a side, which takes less memory and more time (" +
        std::to_string(PictureSize::usualTile) + "\nabove " +
        formatNumber(PictureSize::mostPixelsAtOnce / 1e6) + " million pixels or " +
        std::to_string(PictureSize::longestWindow) + " a side)")
    ->type_name("N")
    ->check(wholeNumber(PictureSize::shortestTile, PictureSize::longestWindow));

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
  const bool series = io::isSeries(file);
  if (!series && this->app->count("--frames") == 0)
  {
    return std::nullopt;
  }
  Animation animation;
  animation.framesPerSecond = this->framesPerSecond;
  const std::string name = this->options.style->GetName();
  if (series && !linesOf(this->options.style))
  {
    throw UsageError("--style " + name + ": expected one file, found a series; lines are drawn of series");
  }
  if (series)
  {
    animation.files = io::filesOfSeries(file);
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
    if (!io::PictureEncoder::isPicture(formatName(file)))
    {
      throw UsageError("-o '" + this->output + "': expected a name that ends in " +
        io::PictureEncoder::suffixes() + ", or -");
    }
    this->checkFormat();
    return;
  }
  static const io::Pattern numbered(R"([^%]*%(0?[1-9])?d[^%]*)");
  if (!video &&
    !(io::PictureEncoder::isPicture(formatName(file)) && !numbered.match(file.filename().string()).empty()))
  {
    throw UsageError("-o '" + this->output +
      "': expected a name with a number for several frames, as out_%04d.png, or .mp4, .webm or .gif for a "
      "video");
  }
  if (video && this->options.transparent)
  {
    throw UsageError("--transparent: expected pictures, as out_%04d.png, found a video");
  }
  if (!video)
  {
    this->checkFormat();
  }
}

void RenderArguments::checkFormat() const
{
  const std::filesystem::path& file = this->options.output;
  if (this->options.transparent && !io::PictureEncoder::hasAlpha(formatName(file)))
  {
    throw UsageError(
      "--transparent: expected a PNG or TIFF file, found '" + this->output + "', which has no alpha");
  }
  const int longest = io::PictureEncoder::longestSide(formatName(file));
  if (std::max(this->options.size.width, this->options.size.height) > longest)
  {
    throw UsageError("--size '" + this->size + "': expected up to " + std::to_string(longest) +
      " pixels a side in '" + this->output + "'");
  }
}

void RenderArguments::run()
{
  this->options.input = this->input.options();
  this->options.output = this->output;
  this->options.size = PictureSize::parse(this->size);
  this->options.size.tile = this->tile;
  this->options.style = this->parameters.make(this->options.size.supersampling());
  this->options.parameters = &this->parameters;
  this->options.style->SetPictureSize(
    this->options.zoom * std::max(this->options.size.width, this->options.size.height));
  this->options.style->SetPictureHeight(this->options.size.height);
  const auto pointOf = [](const std::vector<double>& given)
  {
    return given.empty() ? std::optional<std::array<double, 3>>()
                         : std::array<double, 3>{ given[0], given[1], given[2] };
  };
  this->options.position = pointOf(this->position);
  this->options.focalPoint = pointOf(this->focalPoint);
  this->options.animation = this->animation();
  if (this->options.position && this->options.animation && this->options.animation->files.empty())
  {
    throw UsageError("--position: expected without --frames, which goes around the subject");
  }
  this->checkOutput();
  render(this->options);
}

} // namespace ink::cli
