// SPDX-License-Identifier: BSD-3-Clause
#include "Completion.h"

#include "CommandLine.h"
#include "OptionTexts.h"

#include <sstream>
#include <string_view>

namespace ink::cli
{
namespace
{

std::vector<const CLI::App*> commandsOf(const CommandLine& commandLine)
{
  return commandLine.app().get_subcommands([](const CLI::App*) { return true; });
}

std::string joined(const std::vector<std::string>& words, const char* between)
{
  std::string all;
  for (const std::string& word : words)
  {
    all += (all.empty() ? "" : between) + word;
  }
  return all;
}

/// Text within single quotes and brackets of zsh's _arguments.
std::string escaped(std::string_view text)
{
  std::string result;
  for (const char c : text)
  {
    if (c == '\'')
    {
      result += "'\\''";
      continue;
    }
    result += std::string_view("[]:\\").find(c) != std::string_view::npos ? "\\" : "";
    result += c;
  }
  return result;
}

} // namespace

std::string bashCompletion(const CommandLine& commandLine)
{
  std::ostringstream cases;
  std::ostringstream options;
  std::vector<std::string> names;
  for (const CLI::App* command : commandsOf(commandLine))
  {
    names.push_back(command->get_name());
    std::vector<std::string> all;
    std::vector<std::string> others;
    std::vector<std::string> arguments;
    for (const OptionText& option : optionTexts(*command))
    {
      if (option.positional && option.names.front().front() != '-')
      {
        arguments.insert(arguments.end(), option.words.begin(), option.words.end());
        continue;
      }
      all.insert(all.end(), option.names.begin(), option.names.end());
      std::vector<std::string> patterns;
      for (const std::string& name : option.names)
      {
        patterns.push_back(command->get_name() + "," + name);
      }
      if (!option.words.empty())
      {
        cases << "    " << joined(patterns, "|") << ") words='" << joined(option.words, " ") << "' ;;\n";
      }
      else if (!option.value.empty())
      {
        others.insert(others.end(), patterns.begin(), patterns.end());
      }
    }
    if (!others.empty())
    {
      cases << "    " << joined(others, "|") << ") _ink_files \"$current\"; return ;;\n";
    }
    options << "      " << command->get_name() << ") options='" << joined(all, " ") << "'; arguments='"
            << joined(arguments, " ") << "' ;;\n";
  }
  return R"(# bash completion for ink; made by `ink generate bash`
_ink_files()
{
  # Names may have spaces.
  local IFS=$'\n'
  COMPREPLY=($(compgen -f -- "$1"))
}
_ink()
{
  local current="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD - 1]}"
  local command="${COMP_WORDS[1]}" words='' options='' arguments=''
  local IFS=$' \t\n'
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W ')" +
    joined(names, " ") + R"( --help --version' -- "$current"))
    return
  fi
  case "$command,$before" in
)" + cases.str() +
    R"(  esac
  if [ -z "$words" ]; then
    case "$command" in
)" + options.str() +
    R"(    esac
    words="$arguments"
    case "$current" in
      -*) words="$options" ;;
    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$current"))
  [ "${#COMPREPLY[@]}" -gt 0 ] || _ink_files "$current"
}
complete -o filenames -F _ink ink
)";
}

std::string zshCompletion(const CommandLine& commandLine)
{
  std::ostringstream commands;
  std::ostringstream cases;
  for (const CLI::App* command : commandsOf(commandLine))
  {
    commands << "    '" << command->get_name() << ":" << escaped(command->get_description()) << "'\n";
    cases << "    " << command->get_name() << ")\n      _arguments";
    for (const OptionText& option : optionTexts(*command))
    {
      const std::string action = option.words.empty() ? "_files" : "(" + joined(option.words, " ") + ")";
      if (option.positional && option.names.front().front() != '-')
      {
        cases << " \\\n        '*:" << escaped(option.names.front()) << ":" << action << "'";
        continue;
      }
      for (const std::string& name : option.names)
      {
        cases << " \\\n        '*" << name << "[" << escaped(option.text) << "]";
        if (!option.value.empty())
        {
          cases << ":" << escaped(option.value) << ":" << action;
        }
        cases << "'";
      }
    }
    cases << "\n      ;;\n";
  }
  return R"(#compdef ink
# zsh completion for ink; made by `ink generate zsh`
_ink()
{
  local -a commands=(
)" + commands.str() +
    R"(  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command="$words[2]"
  shift words
  (( CURRENT-- ))
  case "$command" in
)" + cases.str() +
    R"(  esac
}
_ink "$@"
)";
}

} // namespace ink::cli
