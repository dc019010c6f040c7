#pragma once

#include "Color.h"

#include "vtkSmartPointer.h"

#include <CLI/CLI.hpp>

#include <deque>
#include <optional>
#include <string>
#include <vector>

class vtkInkSplattingLinesMapper;

namespace ink::cli
{

/// The options of `ink render --style splatting-lines`, and the mapper that they come to.
struct LinesArguments
{
  std::vector<CLI::Option*> all; ///< other styles have none of these

  void add(CLI::App* command);

  /// \param ink none: the mapper's
  /// \throw UsageError
  vtkSmartPointer<vtkInkSplattingLinesMapper> mapper(const std::optional<Color>& ink) const;

private:
  using Mapper = vtkInkSplattingLinesMapper;
  /// A number that is handed to the mapper if it was given.
  struct Number
  {
    std::optional<double> value;
    void (Mapper::*set)(double);
    double factor; ///< the mapper's unit in the option's
  };

  CLI::Option* keep(CLI::Option* option, const char* group);
  void addNumber(CLI::App* command, const char* group, const char* name, double (Mapper::*get)(),
    void (Mapper::*set)(double), const char* effect, double factor = 1.0);
  void addHidden(CLI::App* command);

  std::deque<Number> numbers; // a deque: CLI11 keeps pointers to the values
  bool asPublished = false;
  bool thin = false;
  std::string toneColor;
  int layers = 1;
  bool backFaces = false;
  std::optional<double> hiddenStrength;
  std::optional<double> hiddenWidth;
  std::optional<double> hiddenDashes;
  std::vector<std::string> hiddenColors;
  std::optional<int> coarsestTexel;
  bool halfFloats = false;
};

} // namespace ink::cli
