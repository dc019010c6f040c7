// SPDX-License-Identifier: BSD-3-Clause
// ink: pen-and-ink pictures of volumes and meshes from the command line.

#ifdef INK_WITH_OPENVDB
#  include "ConvertArguments.h"
#endif
#include "Errors.h"
#include "InfoCommand.h"
#include "InputArguments.h"
#include "RenderArguments.h"
#include "SampleArguments.h"
#include "StyleCommand.h"
#include "VersionCommand.h"

#include "vtkLogger.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
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

int report(ExitCode code, std::string message)
{
  for (char& c : message)
  {
    c = c == '\n' ? ' ' : c;
  }
  std::cerr << "ink: error: " << message << '\n';
  return code;
}

/// Takes options out of the help. Only where it is printed: CLI11's messages do not name them then.
void hideUnlisted(CLI::App& app)
{
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
  {
    for (CLI::Option* option : command->get_options())
    {
      option->group(option->get_group() == unlisted ? "" : option->get_group());
    }
  }
}

int run(int argc, char* argv[])
{
  CLI::App app("ink: pen-and-ink pictures of volumes and meshes", "ink");
  app.footer(help);
  bool showVersion = false;
  app.add_flag("--version", showVersion, "print the versions of vtkInk, VTK and OpenGL");
  app.require_subcommand(0, 1);
  app.get_formatter()->column_width(26);

  const std::string style = StyleArguments::findStyle(argc, argv);
  const bool all = std::find(argv, argv + argc, std::string("--help-all")) != argv + argc;
  RenderArguments renderArguments;
  CLI::App* renderCommand = app.add_subcommand("render", "draw a picture: ink render FILE -o OUT.png");
  renderArguments.add(renderCommand, style, all);
  renderCommand->set_help_flag("-h,--help,--help-all", "print this; --help-all: advanced options, too");
  renderCommand->footer(help);

  StyleCommand styleArguments;
  CLI::App* styleCommand =
    app.add_subcommand("style", "print a style's parameters, for --style-file: ink style NAME > FILE.json");
  styleArguments.add(styleCommand, style, all);
  styleCommand->set_help_flag("-h,--help,--help-all", "print this; --help-all: advanced options, too");
  styleCommand->footer(help);

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
  constexpr const char* commands = "render, sample, style, convert or info";
#else
  constexpr const char* commands = "render, sample, style or info";
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
    if (error.get_exit_code() != 0)
    {
      return report(WrongUsage, error.what());
    }
    // Asking for help is one of these as well.
    hideUnlisted(app);
    return app.exit(error);
  }

  if (showVersion)
  {
    version();
  }
  else if (renderCommand->parsed())
  {
    renderArguments.run();
  }
  else if (styleCommand->parsed())
  {
    styleArguments.run();
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
