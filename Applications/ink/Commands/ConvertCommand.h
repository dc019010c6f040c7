// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

#include <optional>
#include <string>

namespace ink::cli
{

/// What `ink convert` is asked for.
struct ConvertOptions
{
  InputOptions input;
  std::filesystem::path output;
  std::optional<double> around; ///< keep a narrow band around the surfaces of this value
  int halfWidth = 3;            ///< of the band, in voxels
  std::string name = "density"; ///< of the grid
  bool quiet = false;
};

/// Writes a volume as an OpenVDB file.
/// @throws UsageError, Failure; then no file is written or changed.
void convert(const ConvertOptions& options);

} // namespace ink::cli
