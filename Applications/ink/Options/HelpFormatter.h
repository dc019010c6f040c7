// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <sstream>
#include <string>

namespace ink::cli
{

/// CLI11's help; what is an argument and an option, as OUT and -o, is described and required once.
class HelpFormatter : public CLI::Formatter
{
public:
  std::string make_option(const CLI::Option* option, bool asArgument) const override
  {
    if (asArgument || !option->get_positional())
    {
      return Formatter::make_option(option, asArgument);
    }
    std::stringstream text;
    CLI::detail::format_help(text, this->make_option_name(option, false) + " " + option->get_type_name(),
      "the same as " + this->make_option_name(option, true), this->get_column_width());
    return text.str();
  }
};

} // namespace ink::cli
