// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InfoCommand.h"
#include "InputArguments.h"

#include <string>
#include <vector>

namespace ink::cli
{

/// `ink info`: what CLI11 fills in as text, checked and turned into InfoOptions when the command runs.
struct InfoArguments
{
  InputArguments input;
  InfoOptions options;
  std::vector<std::string> files;

  void add(CLI::App* command);
  void run();
};

} // namespace ink::cli
