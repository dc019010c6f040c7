// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef INK_WITH_OPENVDB
#  include "ConvertArguments.h"
#endif
#include "InfoArguments.h"
#include "RenderArguments.h"
#include "SampleArguments.h"
#include "StyleCommand.h"

#include <CLI/CLI.hpp>

#include <string>

namespace ink::cli
{

/// All commands of ink with their options.
class CommandLine
{
public:
  /// @param style whose options are explained; those of others are known, too
  /// @param all whether advanced options are explained
  CommandLine(const std::string& style, bool all);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  CLI::App& app() { return this->App; }
  const CLI::App& app() const { return this->App; }

  /// Takes options that are not explained out of the help. Only where it is printed: CLI11's messages do not
  /// name them then.
  void hideUnlisted();

  /// Does what the parsed arguments ask for. @throws UsageError, Failure
  void run();

private:
  CLI::App App{ "pen-and-ink pictures of volumes and meshes", "ink" };
  bool ShowVersion = false;
  RenderArguments Render;
  StyleCommand Style;
  SampleArguments Sample;
#ifdef INK_WITH_OPENVDB
  ConvertArguments Convert;
#endif
  InfoArguments Info;
  std::string Generated;
};

} // namespace ink::cli
