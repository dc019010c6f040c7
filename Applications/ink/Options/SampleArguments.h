// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CloudArguments.h"
#include "InputArguments.h"
#include "SampleCommand.h"

namespace ink::cli
{

/// `ink sample`: what CLI11 fills in as text, checked and turned into SampleOptions when the command runs.
struct SampleArguments
{
  InputArguments input;
  SampleOptions options;
  std::string output;
  std::vector<std::string> arrays;
  CLI::App* app = nullptr; ///< knows which options were given
  std::string rule = "half-open";
  std::string precision = "auto";
  std::string noise;
  CloudArguments cloud;

  void add(CLI::App* command);
  void run();
};

} // namespace ink::cli
