#pragma once

#include "StippleStyle.h"

#include <CLI/CLI.hpp>

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkInkStippleControls;

namespace ink::cli
{

/// The options of `ink render --style stipple`, and the style that they come to.
struct StippleArguments
{
  std::vector<CLI::Option*> all; ///< other styles have none of these

  void add(CLI::App* command);

  /// \param ink, paper none: the preset's
  /// \throw UsageError
  StippleStyle style(const std::optional<Color>& ink, const std::optional<Color>& paper) const;

private:
  /// A number that is handed to the controls or the mapper if it was given.
  template <class Target>
  struct Number
  {
    std::optional<double> value;
    void (Target::*set)(double);
    double factor; ///< the target's unit in the option's
  };
  /// The k's of an enhancement as text, or "on" or "off".
  struct Enhancement
  {
    const struct EnhancementKs* ks;
    std::optional<std::string> text;
  };

  CLI::Option* keep(CLI::Option* option, const char* group);
  void addSliders(CLI::App* command);
  void addPlaces(CLI::App* command);
  void addEnhancements(CLI::App* command);
  void addMarks(CLI::App* command);
  void addColors(CLI::App* command);
  void setUpGenerator(StippleStyle& style) const;
  void setUpColors(StippleStyle& style) const;

  std::string preset = "anatomy";
  // Deques: CLI11 keeps pointers to the values.
  std::deque<Number<vtkInkStippleControls>> sliders;
  std::deque<Number<vtkInkStippleMapper>> numbers;
  std::deque<Enhancement> enhancements;
  std::vector<double> light{ -30.0, 30.0 };
  std::optional<int> listLength;
  std::optional<double> percentile;
  std::optional<double> threshold;
  std::vector<double> window;
  int seed = 0;
  std::string parts;
  bool noGrowing = false;
  CLI::Option* room = nullptr; ///< --pixels-per-stipple
  std::string colorMap;
  std::string colorBy;
  std::vector<double> colorRange;
  std::string warmColor;
  std::string coolColor;
};

} // namespace ink::cli
