// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "Completion.h"
#include "Errors.h"
#include "HelpFormatter.h"
#include "ManPage.h"
#include "VersionCommand.h"

#include <iostream>
#include <map>
#include <memory>
#include <vector>

namespace ink::cli
{
namespace
{

constexpr const char* footer = R"(
Exit codes: 0 done; 1 a file could not be read or written, or nothing could be drawn; 2 the command line is wrong.
Errors are one line on the standard error stream, and an existing output file stays as it was.)";

using Generator = std::string (*)(const CommandLine&);

const std::map<std::string, Generator>& generators()
{
  static const std::map<std::string, Generator> all{ { "bash", bashCompletion }, { "zsh", zshCompletion },
    { "man", manPage } };
  return all;
}

std::vector<std::string> generated()
{
  std::vector<std::string> names;
  for (const auto& [name, generator] : generators())
  {
    names.push_back(name);
  }
  return names;
}

} // namespace

CommandLine::CommandLine(const std::string& style, bool all)
{
  this->App.footer(footer);
  this->App.add_flag("--version", this->ShowVersion, "print the versions of vtkInk, VTK and OpenGL");
  this->App.require_subcommand(0, 1);
  const auto formatter = std::make_shared<HelpFormatter>();
  formatter->column_width(26);
  this->App.formatter(formatter);
  constexpr const char* help = "-h,--help,--help-all";
  constexpr const char* helpText = "print this; --help-all: advanced options, too";

  CLI::App* render = this->App.add_subcommand("render", "draw a picture: ink render FILE OUT.png");
  this->Render.add(render, style, all);
  render->set_help_flag(help, helpText);
  CLI::App* parameters = this->App.add_subcommand(
    "style", "print a style's parameters, for --style-file: ink style NAME > FILE.json");
  this->Style.add(parameters, style, all);
  parameters->set_help_flag(help, helpText);
  this->Sample.add(
    this->App.add_subcommand("sample", "write points on the surface: ink sample FILE OUT.vtp"));
#ifdef INK_WITH_OPENVDB
  this->Convert.add(this->App.add_subcommand(
    "convert", "write a volume as an OpenVDB file: ink convert FILE OUT.vdb [--around ISO]"));
#endif
  this->Info.add(
    this->App.add_subcommand("info", "print what files hold, with an iso-value that suits each volume"));
  this->App.add_subcommand("generate", "print a shell's completion of ink's options, or the manual page")
    ->add_option("KIND", this->Generated, "bash, zsh or man")
    ->required()
    ->check(oneOf(generated()));
  for (CLI::App* command : this->App.get_subcommands([](CLI::App*) { return true; }))
  {
    command->footer(footer);
  }
}

void CommandLine::hideUnlisted()
{
  for (CLI::App* command : this->App.get_subcommands([](CLI::App*) { return true; }))
  {
    for (CLI::Option* option : command->get_options())
    {
      option->group(option->get_group() == unlisted ? "" : option->get_group());
    }
  }
}

void CommandLine::run()
{
  const auto given = this->App.get_subcommands();
  const std::string command = given.empty() ? "" : given.front()->get_name();
  if (this->ShowVersion)
  {
    version();
  }
  else if (command == "render")
  {
    this->Render.run();
  }
  else if (command == "style")
  {
    this->Style.run();
  }
  else if (command == "sample")
  {
    this->Sample.run();
  }
#ifdef INK_WITH_OPENVDB
  else if (command == "convert")
  {
    this->Convert.run();
  }
#endif
  else if (command == "info")
  {
    this->Info.run();
  }
  else if (command == "generate")
  {
    std::cout << generators().at(this->Generated)(*this);
  }
  else
  {
    std::string commands;
    const auto all = this->App.get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* one : all)
    {
      commands += (commands.empty() ? "" : one == all.back() ? " or " : ", ") + one->get_name();
    }
    throw UsageError("expected a command: " + commands + " (see ink --help)");
  }
}

} // namespace ink::cli
