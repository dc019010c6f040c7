// SPDX-License-Identifier: BSD-3-Clause
#include "ParseErrors.h"

#include "Suggestion.h"

#include <regex>
#include <utility>
#include <vector>

namespace ink::cli
{
namespace
{

/// The command that was given, or the program itself.
const CLI::App& commandOf(const CLI::App& app)
{
  const auto given = app.get_subcommands();
  return given.empty() ? app : *given.front();
}

std::string helpFor(const CLI::App& app)
{
  const CLI::App& command = commandOf(app);
  return " (see ink" + (&command == &app ? "" : " " + command.get_name()) + " --help)";
}

std::vector<std::string> knownNames(const CLI::App& app, bool options)
{
  std::vector<std::string> names;
  if (!options)
  {
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    {
      names.push_back(command->get_name());
    }
    return names;
  }
  for (const CLI::Option* option : commandOf(app).get_options())
  {
    for (const std::string& name : option->get_lnames())
    {
      names.push_back("--" + name);
    }
  }
  return names;
}

std::string describeExtra(const std::string& found, const CLI::App& app)
{
  const bool option = found.size() > 1 && found.front() == '-';
  const std::string name = found.substr(0, found.find('='));
  const bool command = !option && &commandOf(app) == &app;
  const std::string meant = option || command ? didYouMean(name, knownNames(app, option)) : "";
  return "'" + found + "': expected no such " +
    (option       ? "option"
        : command ? "command"
                  : "argument") +
    (meant.empty() ? helpFor(app) : meant);
}

} // namespace

std::string describe(const CLI::ParseError& error, const CLI::App& app)
{
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error))
  {
    return describeExtra(app.remaining(true).front(), app);
  }
  static const std::vector<std::pair<std::regex, std::string>> sentences{
    { std::regex("(.+) is required"), "$1: expected, found nothing" },
    { std::regex("Could not convert: (\\S+) = (.*)"), "$1 '$2': expected another kind of value" },
    { std::regex("The value (.*) is not an allowed value for (\\S+)"), "$2 '$1': expected another value" },
    { std::regex("(\\S+): Should be true/false or a number"), "$1: expected without a value" },
    { std::regex("(\\S+): too many inputs for a flag"), "$1: expected once" },
    { std::regex("(\\S+) was given a disallowed flag override"), "$1: expected without a value" },
    { std::regex("(\\S+): At [Mm]ost (\\d+) required but received (\\d+)"),
      "$1: expected once, found $3 times" },
    { std::regex("(\\S+): At [Ll]east (\\d+) required but received (\\d+)"),
      "$1: expected $2 values, found $3" },
    { std::regex("(\\S+): (\\d+) required ([^:]*).* missing"), "$1: expected $3, found nothing" },
    { std::regex("Expected exactly (\\d+) arguments to (\\S+), got (\\d+)"),
      "$2: expected $1 values, found $3" },
    { std::regex("Expected at least (\\d+) arguments to (\\S+), got (\\d+)"),
      "$2: expected $1 values or more, found $3" },
    { std::regex("(\\S+) requires (\\S+)"), "$1: expected with $2" },
    { std::regex("(\\S+) excludes (\\S+)"), "$1: expected without $2" },
    { std::regex("(--?\\S+): ('[^]*)"), "$1 $2" },
  };
  for (const auto& [pattern, sentence] : sentences)
  {
    if (std::regex_match(text, pattern))
    {
      return std::regex_replace(text, pattern, sentence) +
        (dynamic_cast<const CLI::RequiredError*>(&error) ? helpFor(app) : "");
    }
  }
  return text;
}

} // namespace ink::cli
