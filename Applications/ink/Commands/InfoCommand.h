// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

#include <filesystem>
#include <vector>

namespace ink::cli
{

/// What `ink info` was asked for.
struct InfoOptions
{
  InputOptions input; ///< how each of the files is read
  std::vector<std::filesystem::path> files;
  bool json = false;
  bool quiet = false;
};

/// Prints what files hold to the standard output stream: one after the other with an empty line between them,
/// or as JSON, a list of one object for each.
/// @throws Failure
void info(const InfoOptions& options);

} // namespace ink::cli
