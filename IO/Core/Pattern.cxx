// SPDX-License-Identifier: BSD-3-Clause
#include "Pattern.h"

#include <regex>

namespace ink::io
{
namespace
{

std::vector<std::string> groupsOf(const std::smatch& match)
{
  return { match.begin(), match.end() };
}

} // namespace

struct Pattern::Expression
{
  std::regex Regex;
};

Pattern::Pattern(const std::string& expression, bool ignoreCase)
  : Compiled(new Expression{ std::regex(
      expression, ignoreCase ? std::regex::ECMAScript | std::regex::icase : std::regex::ECMAScript) })
{
}

Pattern::~Pattern() = default;

std::vector<std::string> Pattern::match(const std::string& text) const
{
  std::smatch found;
  std::regex_match(text, found, this->Compiled->Regex);
  return groupsOf(found);
}

std::vector<std::string> Pattern::search(const std::string& text) const
{
  std::smatch found;
  std::regex_search(text, found, this->Compiled->Regex);
  return groupsOf(found);
}

std::string Pattern::replace(const std::string& text, const std::string& replacement) const
{
  return std::regex_replace(text, this->Compiled->Regex, replacement);
}

} // namespace ink::io
