// SPDX-License-Identifier: BSD-3-Clause
#include "ManPage.h"

#include "CommandLine.h"
#include "OptionTexts.h"

#include <set>
#include <sstream>

namespace ink::cli
{
namespace
{

/// Text that roff prints as it is.
std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    const bool first = result.empty() || result.back() == '\n';
    result += c == '\\'                  ? "\\e"
      : c == '-'                         ? "\\-"
      : first && (c == '.' || c == '\'') ? "\\&" + std::string(1, c)
                                         : std::string(1, c);
  }
  return result;
}

void writeOption(std::ostream& page, const OptionText& option)
{
  page << ".TP\n";
  std::string names;
  for (const std::string& name : option.names)
  {
    names += (names.empty() ? "" : ", ") + ("\\fB" + escaped(name) + "\\fR");
  }
  page << names << (option.value.empty() || option.positional ? "" : " \\fI" + escaped(option.value) + "\\fR")
       << '\n'
       << escaped(option.text) << '\n';
}

/// The options of a command by their groups, but for groups that were written before.
void writeGroups(std::ostream& page, const CLI::App& command, std::set<std::string>& written)
{
  const auto options = optionTexts(command);
  std::set<std::string> now;
  for (const OptionText& first : options)
  {
    if (first.group == unlisted || written.count(first.group) || !now.insert(first.group).second)
    {
      continue;
    }
    if (first.group != "Options")
    {
      page << ".PP\n" << escaped(first.group) << ":\n";
    }
    for (const OptionText& option : options)
    {
      if (option.group == first.group)
      {
        writeOption(page, option);
      }
    }
  }
  written.insert(now.begin(), now.end());
}

} // namespace

std::string manPage(const CommandLine& commandLine)
{
  std::ostringstream page;
  page << ".TH INK 1 \"\" \"vtkInk " << VTKINK_VERSION << "\" \"User Commands\"\n"
       << ".SH NAME\nink \\- " << escaped(commandLine.app().get_description()) << '\n'
       << ".SH SYNOPSIS\n";
  const auto commands = commandLine.app().get_subcommands([](const CLI::App*) { return true; });
  for (const CLI::App* command : commands)
  {
    page << ".B ink " << command->get_name() << "\n.RI [ options ] ...\n.br\n";
  }
  for (const CLI::App* command : commands)
  {
    page << ".SH \"INK " << CLI::detail::to_lower(command->get_name()) << "\"\n"
         << escaped(command->get_description()) << '\n';
    std::set<std::string> written;
    writeGroups(page, *command, written);
    if (command->get_name() != "render")
    {
      continue;
    }
    for (const std::string& style : StyleArguments::names())
    {
      const CommandLine ofStyle(style, true);
      writeGroups(page, *ofStyle.app().get_subcommand("render"), written);
    }
  }
  page << ".SH \"EXIT STATUS\"\n" << escaped(CLI::detail::trim_copy(commandLine.app().get_footer())) << '\n';
  return page.str();
}

} // namespace ink::cli
