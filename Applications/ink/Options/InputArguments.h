// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"
#include "Validators.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Validator;
} // namespace CLI

namespace ink::cli
{

/// Options of the input file that all commands have.
struct InputArguments
{
  std::string file;
  std::optional<std::string> raw;
  std::vector<double> spacing;
  bool bigEndian = false;
  std::vector<double> crop;
  std::string grid;
  std::string memory;

  /// Which files are read.
  /// @param mesh what is done with a mesh
  static std::string fileHelp(const std::string& mesh);
  /// @param mesh what is done with a mesh, for the help
  void addFile(CLI::App* command, const std::string& mesh = "mesh");
  /// Further options, in groups of their own.
  void addReading(CLI::App* command);

  /// @throws UsageError
  InputOptions options() const;
};

} // namespace ink::cli
