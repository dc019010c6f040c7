#pragma once

#include "CloudArguments.h"
#include "InputArguments.h"
#include "LinesArguments.h"
#include "RenderCommand.h"
#include "StippleArguments.h"

namespace ink::cli
{

/// `ink render`: what CLI11 fills in as text, checked and turned into RenderOptions when the command runs.
struct RenderArguments
{
  InputArguments input;
  RenderOptions options;
  std::string output;
  std::string style = "splatting-lines";
  std::string size = "1024x1024";
  std::string frames;
  double framesPerSecond = 25;
  std::string inkColor;
  std::string paperColor;
  std::string background;
  CloudArguments cloud;
  StippleArguments stipple;
  LinesArguments lines;
  CLI::App* app = nullptr; ///< knows which options were given

  void add(CLI::App* command);
  void run();

private:
  void addColors(CLI::App* command);
  void addAnimation(CLI::App* command);
  std::optional<Animation> animation() const;
  /// \throw UsageError for a name that does not go with the frames
  void checkOutput() const;
  void refuse(const std::vector<CLI::Option*>& others, const std::string& itsStyle) const;
};

} // namespace ink::cli
