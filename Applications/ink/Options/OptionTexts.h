// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ink::cli
{

/// What completions and the manual page say of an option.
struct OptionText
{
  std::vector<std::string> names; ///< with their dashes; the only one of an argument without, as FILE
  bool positional = false;
  std::string value;              ///< what follows it, "WxH"; empty: nothing
  std::vector<std::string> words; ///< the values it can have; empty: any
  std::string group;
  std::string text; ///< in one line
};

/// A command's options, also those that its help leaves out: of all styles.
std::vector<OptionText> optionTexts(const CLI::App& command);

} // namespace ink::cli
