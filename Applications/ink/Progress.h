// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

class vtkAlgorithm;

namespace ink::cli
{

/// One line on the standard error stream that says how far the work is. It is there only while work goes on
/// and only if somebody can watch it: nothing is printed if the stream is not a terminal.
class Progress
{
public:
  /// @param quiet print nothing, terminal or not.
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows a step by name.
  void step(const std::string& name);

  /// Shows a step by name and follows the progress that algorithm reports until the next step.
  void step(const std::string& name, vtkAlgorithm* algorithm);

  /// Makes what the algorithm does next count from `begin` to `end`, both from 0 to 1, of the step.
  void part(double begin, double end);

  /// Shows how far the step is, from 0 to 1.
  void at(double done);

  /// The same, for work that takes longer when it is watched; empty if nobody can watch.
  std::function<void(double)> watcher();

  /// Takes the line away.
  void finish();

private:
  void show(double done);

  bool Visible;
  std::string Name;
  int Percent = -1;
  double Begin = 0.0;
  double End = 1.0;
};

} // namespace ink::cli
