// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"
#include "SampleMesh.h"
#include "SampleVolume.h"

namespace ink::cli
{

/// What `ink sample` is asked for.
struct SampleOptions
{
  InputOptions input;
  std::filesystem::path output; ///< whose suffix says the format
  VolumeSampling volume;
  MeshSampling mesh;
  std::optional<std::string> meshOption; ///< one of a mesh's that was given, as it is called
  bool quiet = false;
};

/// Writes points on the surface of a volume or a mesh; for a volume without iso-values prints the one chosen.
/// @throws UsageError, Failure; then no file is written or changed.
void sample(const SampleOptions& options);

} // namespace ink::cli
