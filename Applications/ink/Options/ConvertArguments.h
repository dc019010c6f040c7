// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ConvertCommand.h"
#include "InputArguments.h"

namespace ink::cli
{

/// `ink convert`: what CLI11 fills in as text, checked and turned into ConvertOptions when the command runs.
struct ConvertArguments
{
  InputArguments input;
  ConvertOptions options;
  std::string output;

  void add(CLI::App* command);
  void run();
};

} // namespace ink::cli
