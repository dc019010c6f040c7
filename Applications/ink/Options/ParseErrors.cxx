// SPDX-License-Identifier: BSD-3-Clause
#include "ParseErrors.h"

#include "Pattern.h"

#include "Core/DidYouMean.h"

#include <algorithm>
#include <string>
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

/// The arguments that a command has, as "FILE OUT".
std::string argumentsOf(const CLI::App& command)
{
  std::string names;
  for (const CLI::Option* option : command.get_options())
  {
    if (option->get_positional())
    {
      names += (names.empty() ? "" : " ") + option->get_name(true);
    }
  }
  return names;
}

/// CLI11's sentence; where it begins with the name of an option that is an argument, too, with both.
std::string withBothNames(const std::string& text, const CLI::App& app)
{
  const std::string name = text.substr(0, text.find_first_of(": "));
  const CLI::Option* option = commandOf(app).get_option_no_throw(name);
  return (option && option->get_positional() && option->nonpositional() ? option->get_name(true) + " or "
                                                                        : "") +
    text;
}

std::string describeExtra(const std::string& found, const CLI::App& app)
{
  const bool option = found.size() > 1 && found.front() == '-';
  const std::string name = found.substr(0, found.find('='));
  const bool command = !option && &commandOf(app) == &app;
  const std::string meant = option || command ? didYouMean(name, knownNames(app, option)) : "";
  if (!option && !command)
  {
    return "'" + found + "': one argument too many, expected " + argumentsOf(commandOf(app)) + helpFor(app);
  }
  return "'" + found + "': no such " + (option ? "option" : "command") +
    (meant.empty() ? helpFor(app) : meant);
}

} // namespace

std::string describe(const CLI::ParseError& error, const CLI::App& app)
{
  const std::string text = withBothNames(error.what(), app);
  // The value after an option that does not exist is taken for an argument too many.
  const std::vector<std::string> left = app.remaining(true);
  const auto unknown =
    std::find_if(left.begin(), left.end(), [](const std::string& one) { return one.starts_with("--"); });
  if (unknown != left.end())
  {
    return describeExtra(*unknown, app);
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error))
  {
    return describeExtra(left.front(), app);
  }
  struct Sentence
  {
    io::Pattern found;
    std::string ours;
  };
  static const Sentence sentences[] = {
    { io::Pattern("(.+) is required"), "$1: required, found nothing" },
    { io::Pattern("Could not convert: (\\S+) = (.*)"), "$1 '$2': expected another kind of value" },
    { io::Pattern("The value (.*) is not an allowed value for (\\S+)"), "$2 '$1': expected another value" },
    { io::Pattern("(\\S+): Should be true/false or a number"), "$1: expected without a value" },
    { io::Pattern("(\\S+): too many inputs for a flag"), "$1: expected once" },
    { io::Pattern("(\\S+) was given a disallowed flag override"), "$1: expected without a value" },
    { io::Pattern("(.+): At [Mm]ost (\\d+) required but received (\\d+)"),
      "$1: expected once, found $3 times" },
    { io::Pattern("(\\S+): At [Ll]east (\\d+) required but received (\\d+)"),
      "$1: expected $2 values, found $3" },
    { io::Pattern("(\\S+): (\\d+) required ([^:]*).* missing"), "$1: expected $3, found nothing" },
    { io::Pattern("Expected exactly (\\d+) arguments to (\\S+), got (\\d+)"),
      "$2: expected $1 values, found $3" },
    { io::Pattern("Expected at least (\\d+) arguments to (\\S+), got (\\d+)"),
      "$2: expected $1 values or more, found $3" },
    { io::Pattern("(\\S+) requires (\\S+)"), "$1: expected with $2" },
    { io::Pattern("(\\S+) excludes (\\S+)"), "$1: expected without $2" },
    { io::Pattern("(--?\\S+): ('[^]*)"), "$1 $2" },
  };
  for (const Sentence& sentence : sentences)
  {
    if (!sentence.found.match(text).empty())
    {
      return sentence.found.replace(text, sentence.ours) +
        (dynamic_cast<const CLI::RequiredError*>(&error) ? helpFor(app) : "");
    }
  }
  return text;
}

} // namespace ink::cli
