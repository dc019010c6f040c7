#pragma once

#include <string>

class vtkAlgorithm;

namespace ink::cli
{

/// One line on the standard error stream that says how far the work is. It is there only while work goes on
/// and only if somebody can watch it: nothing is printed if the stream is not a terminal.
class Progress
{
public:
  /// \param quiet print nothing, terminal or not.
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows a step by name.
  void step(const std::string& name);

  /// Shows a step by name and follows the progress that algorithm reports until the next step.
  void step(const std::string& name, vtkAlgorithm* algorithm);

  /// Takes the line away.
  void finish();

private:
  void show(int percent);

  bool Visible;
  std::string Name;
  int Percent = -1;
};

} // namespace ink::cli
