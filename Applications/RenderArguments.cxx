#include "RenderArguments.h"

#include "Errors.h"
#include "FrameChoice.h"
#include "Series.h"
#include "Video.h"

#include "vtkInkSplattingLinesMapper.h"

#include <regex>

namespace ink::cli
{
namespace
{

constexpr const char* linesStyle = "splatting-lines";
constexpr const char* stippleStyle = "stipple";

} // namespace

void RenderArguments::add(CLI::App* command)
{
  this->app = command;
  this->input.addFile(command, "mesh or points");
  command
    ->add_option("-o,--output", this->output,
      "the picture to write; of several frames out_%04d.png, or a video: .mp4, .webm or .gif")
    ->required()
    ->type_name("OUT.png");
  command->add_option("--style", this->style, "way of drawing: splatting-lines or stipple (splatting-lines)")
    ->type_name("NAME")
    ->check(CLI::IsMember({ linesStyle, stippleStyle }));
  command
    ->add_option("--iso", this->options.isoValues,
      "value of the surface to draw in a volume; may be given several times. Without it, lines choose one "
      "and\n"
      "name it, and stipples show all boundaries through each other; with it, they are those of what is "
      "denser\n"
      "than the least value, and its surface hides what lies behind it")
    ->type_name("V")
    ->expected(1)
    ->take_all();
  command
    ->add_option("--samples", this->options.samples,
      "points to make on a mesh; 0: lines are drawn from its vertices (lines: twice as many, but 200000 to\n"
      "1000000; stipples: as many as the picture has room for)")
    ->type_name("N")
    ->check(within(0, 1e12));
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

  this->addAnimation(command);
  this->addColors(command);
  this->lines.add(command);
  this->stipple.add(command);
  this->cloud.add(command);
  this->input.addReading(command);
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
  if (series && this->style == stippleStyle)
  {
    throw UsageError("--style stipple: expected one file, found a series; lines are drawn of series");
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

void RenderArguments::addColors(CLI::App* command)
{
  constexpr const char* group = "Colors: names as in HTML, #rrggbb or #rgb";
  command->add_option("--ink-color", this->inkColor, "color of the lines (black) or stipples (the preset's)")
    ->type_name("COLOR")
    ->group(group);
  command
    ->add_option("--paper-color", this->paperColor,
      "lines: color of the surface between them (white); none: the lines alone are drawn.\n"
      "Stipples: color of the page (the preset's); on a page darker than the ink, they show light")
    ->type_name("COLOR")
    ->group(group);
  this->lines.all.push_back(
    command->add_option("--background", this->background, "lines: color around the subject (white)")
      ->type_name("COLOR")
      ->group(group));
  command
    ->add_flag("--transparent", this->options.transparent, "nothing around the subject: a PNG with alpha")
    ->group(group);
}

void RenderArguments::refuse(const std::vector<CLI::Option*>& others, const std::string& itsStyle) const
{
  for (const CLI::Option* option : others)
  {
    if (option->count() > 0)
    {
      throw UsageError(
        option->get_name() + ": expected with --style " + itsStyle + ", found --style " + this->style);
    }
  }
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
  static const std::regex numbered(R"([^%]*%(0?[1-9])?d[^%]*\.png)");
  if (!video && !std::regex_match(file.filename().string(), numbered))
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
  this->options.animation = this->animation();
  this->checkOutput();
  this->options.cloud = this->cloud.options();
  this->options.size = PictureSize::parse(this->size);
  const auto colorOf = [this](const char* option, const std::string& text)
  { return this->app->count(option) > 0 ? std::optional(parseColor(option, text)) : std::nullopt; };
  const bool noPaper = this->paperColor == "none";
  const std::optional<Color> ink = colorOf("--ink-color", this->inkColor);
  const std::optional<Color> paper = noPaper ? std::nullopt : colorOf("--paper-color", this->paperColor);
  if (this->style == stippleStyle)
  {
    this->refuse(this->lines.all, linesStyle);
    if (noPaper)
    {
      throw UsageError(
        "--paper-color none: expected the page's color with --style stipple; --transparent leaves it out");
    }
    if (!this->options.cloud.given.empty())
    {
      throw UsageError(
        this->options.cloud.given + ": expected with --style splatting-lines, found --style stipple");
    }
    this->options.stipple = this->stipple.style(ink, paper);
  }
  else
  {
    this->refuse(this->stipple.all, stippleStyle);
    this->options.lines = this->lines.mapper(ink);
    this->options.paperColor = paper ? paper : this->options.paperColor;
    if (noPaper)
    {
      this->options.paperColor.reset();
    }
    this->options.background = colorOf("--background", this->background).value_or(this->options.background);
  }
  render(this->options);
}

} // namespace ink::cli
