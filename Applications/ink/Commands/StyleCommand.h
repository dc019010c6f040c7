// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StyleArguments.h"

namespace ink::cli
{

/// `ink style NAME`: prints a style file.
struct StyleCommand
{
  std::string name;
  StyleArguments parameters;

  /// As StyleArguments::add.
  void add(CLI::App* command, const std::string& styleName, bool all);
  void run();
};

} // namespace ink::cli
