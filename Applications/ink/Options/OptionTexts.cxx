// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTexts.h"

#include "StyleArguments.h"

#include <algorithm>
#include <map>

namespace ink::cli
{
namespace
{

/// The words that oneOf() puts into an option's type, as "NAME:{front,back}".
std::vector<std::string> wordsIn(const std::string& type)
{
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}');
  return begin == std::string::npos || end == std::string::npos
    ? std::vector<std::string>()
    : CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

std::string inOneLine(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

} // namespace

std::vector<OptionText> optionTexts(const CLI::App& command)
{
  const std::map<std::string, StyleArguments::Words> ofStyles = StyleArguments::wordsOfOptions();
  std::vector<OptionText> texts;
  for (const CLI::Option* option : command.get_options())
  {
    OptionText text;
    text.positional = option->get_positional();
    for (const std::string& name : option->get_snames())
    {
      text.names.push_back("-" + name);
    }
    for (const std::string& name : option->get_lnames())
    {
      text.names.push_back("--" + name);
    }
    if (text.names.empty())
    {
      text.names.push_back(option->get_name());
    }
    const std::string type = option->get_type_name();
    text.words = wordsIn(type);
    text.value = option->get_items_expected_max() > 0 ? type.substr(0, type.find(':')) : "";
    text.group = option->get_group();
    text.text = inOneLine(option->get_description());
    if (const auto known = ofStyles.find(text.names.back()); known != ofStyles.end())
    {
      text.words = known->second.words;
      text.text = text.text.empty() ? known->second.text : text.text;
    }
    texts.push_back(std::move(text));
  }
  return texts;
}

} // namespace ink::cli
