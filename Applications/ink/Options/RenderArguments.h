// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InputArguments.h"
#include "RenderCommand.h"
#include "StyleArguments.h"

namespace ink::cli
{

/// `ink render`: what CLI11 fills in as text, checked and turned into RenderOptions when the command runs.
struct RenderArguments
{
  InputArguments input;
  RenderOptions options;
  std::string output;
  std::string style; ///< as it is given; which one is drawn, StyleArguments knows
  std::string size = "1024";
  int tile = 0;
  std::vector<double> position;
  std::vector<double> focalPoint;
  std::string frames;
  double framesPerSecond = 25;
  StyleArguments parameters;
  CLI::App* app = nullptr; ///< knows which options were given

  /// @param styleName whose options there are
  /// @param all whether the help has advanced ones, too
  void add(CLI::App* command, const std::string& styleName, bool all);
  void run();

private:
  void addAnimation(CLI::App* command);
  std::optional<Animation> animation() const;
  /// @throws UsageError for a name that does not go with the frames
  void checkOutput() const;
  /// @throws UsageError for a picture that its file's format has no room for
  void checkFormat() const;
};

} // namespace ink::cli
