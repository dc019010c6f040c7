// ink: pen-and-ink pictures of volumes and meshes from the command line.

#ifdef INK_WITH_OPENVDB
#  include "ConvertArguments.h"
#endif
#include "Errors.h"
#include "InfoCommand.h"
#include "InputArguments.h"
#include "RenderCommand.h"
#include "SampleArguments.h"
#include "VersionCommand.h"

#include "vtkInkSplattingLinesMapper.h"
#include "vtkLogger.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <string>

namespace
{

using namespace ink::cli;

enum ExitCode
{
  Success = 0,
  Failed = 1,
  WrongUsage = 2
};

constexpr const char* help = R"(
Exit codes: 0 done; 1 a file could not be read or written, or nothing could be drawn; 2 the command line is wrong.
Errors are one line on the standard error stream, and an existing output file stays as it was.)";

/// `ink render`: what CLI11 fills in as text, checked and turned into RenderOptions when the command runs.
struct RenderArguments
{
  InputArguments input;
  RenderOptions options;
  std::string output;
  std::string style = "splatting-lines";
  std::string size = "1024x1024";
  std::string inkColor = "black";
  std::string paperColor = "white";
  std::string background = "white";

  void add(CLI::App* command)
  {
    this->input.addFile(command, "mesh or points");
    command->add_option("-o,--output", this->output, "the picture to write")
      ->required()
      ->type_name("OUT.png");
    command
      ->add_option("--iso", this->options.isoValues,
        "value of the surface to draw in a volume; may be given several times. Without it one is chosen and "
        "named")
      ->type_name("V")
      ->expected(1)
      ->take_all();
    command
      ->add_option("--samples", this->options.samples,
        "points to make on a mesh; 0: its vertices are drawn (twice as many, but 200000 to 1000000)")
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
    command->add_option("--style", this->style, "way of drawing: splatting-lines")
      ->type_name("NAME")
      ->check(CLI::IsMember({ "splatting-lines" }));
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

    // Ranges and defaults are the mapper's own.
    vtkNew<vtkInkSplattingLinesMapper> mapper;
    const auto addLineOption = [&](const char* name, std::optional<double>& value, const char* effect,
                                 double least, double greatest, double preset)
    {
      std::ostringstream description;
      description << effect << " (" << preset << ")";
      command->add_option(name, value, description.str())->check(within(least, greatest))->group("Lines");
    };
    addLineOption("--tau", this->options.tau, "threshold: more lines with a larger one",
      mapper->GetTauMinValue(), mapper->GetTauMaxValue(), mapper->GetTau());
    addLineOption("--phi", this->options.phi, "strength: darker lines with a larger one",
      mapper->GetPhiMinValue(), mapper->GetPhiMaxValue(), mapper->GetPhi());
    addLineOption("--lambda", this->options.lambda, "detail: fewer, broader lines with a larger one",
      mapper->GetLambdaMinValue(), mapper->GetLambdaMaxValue(), mapper->GetLambda());
    addLineOption("--sigma", this->options.sigma, "width of the narrower Gaussian as part of a splat",
      mapper->GetSigmaMinValue(), mapper->GetSigmaMaxValue(), mapper->GetSigma());

    command
      ->add_flag("--as-published", this->options.asPublished,
        "splat exactly as in the paper: without what makes contours solid and lines smooth")
      ->group("Lines");

    command->add_option("--ink-color", this->inkColor, "colour of the lines (black)")
      ->type_name("COLOR")
      ->group("Colours: names as in HTML, #rrggbb or #rgb");
    command
      ->add_option("--paper-color", this->paperColor,
        "colour of the surface between the lines (white); none: the lines alone are drawn")
      ->type_name("COLOR")
      ->group("Colours: names as in HTML, #rrggbb or #rgb");
    command->add_option("--background", this->background, "colour around the subject (white)")
      ->type_name("COLOR")
      ->group("Colours: names as in HTML, #rrggbb or #rgb");
    command
      ->add_flag("--transparent", this->options.transparent, "nothing around the subject: a PNG with alpha")
      ->group("Colours: names as in HTML, #rrggbb or #rgb");

    this->input.addReading(command);
  }

  void run()
  {
    this->options.input = this->input.options();
    this->options.output = this->output;
    if (this->options.output.extension() != ".png")
    {
      throw UsageError("-o '" + this->output + "': expected a name that ends in .png");
    }
    this->options.size = PictureSize::parse(this->size);
    this->options.inkColor = parseColor("--ink-color", this->inkColor);
    this->options.background = parseColor("--background", this->background);
    this->options.paperColor.reset();
    if (this->paperColor != "none")
    {
      this->options.paperColor = parseColor("--paper-color", this->paperColor);
    }
    render(this->options);
  }
};

int report(ExitCode code, std::string message)
{
  for (char& c : message)
  {
    c = c == '\n' ? ' ' : c;
  }
  std::cerr << "ink: error: " << message << '\n';
  return code;
}

int run(int argc, char* argv[])
{
  CLI::App app("ink: pen-and-ink pictures of volumes and meshes", "ink");
  app.footer(help);
  bool showVersion = false;
  app.add_flag("--version", showVersion, "print the versions of vtkInk, VTK and OpenGL");
  app.require_subcommand(0, 1);
  app.get_formatter()->column_width(26);

  RenderArguments renderArguments;
  CLI::App* renderCommand = app.add_subcommand("render", "draw a picture: ink render FILE -o OUT.png");
  renderArguments.add(renderCommand);
  renderCommand->footer(help);

  SampleArguments sampleArguments;
  CLI::App* sampleCommand =
    app.add_subcommand("sample", "write points on the surface: ink sample FILE OUT.vtp");
  sampleArguments.add(sampleCommand);
  sampleCommand->footer(help);

#ifdef INK_WITH_OPENVDB
  ConvertArguments convertArguments;
  CLI::App* convertCommand = app.add_subcommand(
    "convert", "write a volume as an OpenVDB file: ink convert FILE OUT.vdb [--around ISO]");
  convertArguments.add(convertCommand);
  convertCommand->footer(help);
  constexpr const char* commands = "render, sample, convert or info";
#else
  constexpr const char* commands = "render, sample or info";
#endif

  InputArguments infoArguments;
  bool infoQuiet = false;
  CLI::App* infoCommand =
    app.add_subcommand("info", "print what a file holds, with an iso-value that suits it");
  infoArguments.addFile(infoCommand);
  infoArguments.addReading(infoCommand);
  infoCommand->add_flag("-q,--quiet", infoQuiet, "show no progress");
  infoCommand->footer(help);

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ExtrasError&)
  {
    const std::vector<std::string> unknown = app.remaining(true);
    return report(WrongUsage,
      "'" + unknown.front() + "': expected no such argument (see ink" +
        (app.get_subcommands().empty() ? "" : " " + app.get_subcommands().front()->get_name()) + " --help)");
  }
  catch (const CLI::ParseError& error)
  {
    // Asking for help is one of these as well.
    return error.get_exit_code() == 0 ? app.exit(error) : report(WrongUsage, error.what());
  }

  if (showVersion)
  {
    version();
  }
  else if (renderCommand->parsed())
  {
    renderArguments.run();
  }
  else if (sampleCommand->parsed())
  {
    sampleArguments.run();
  }
#ifdef INK_WITH_OPENVDB
  else if (convertCommand->parsed())
  {
    convertArguments.run();
  }
#endif
  else if (infoCommand->parsed())
  {
    info(infoArguments.options(), infoQuiet);
  }
  else
  {
    return report(WrongUsage, std::string("expected a command: ") + commands + " (see ink --help)");
  }
  return std::cout.flush() ? Success : report(Failed, "cannot write to the standard output stream");
}

} // namespace

int main(int argc, char* argv[])
{
  // What VTK logs about its choice of a window, say, is not for the users of ink.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  try
  {
    return run(argc, argv);
  }
  catch (const UsageError& error)
  {
    return report(WrongUsage, error.what());
  }
  catch (const std::bad_alloc&)
  {
    return report(Failed, "there is not enough memory");
  }
  catch (const std::exception& error)
  {
    return report(Failed, error.what());
  }
}
