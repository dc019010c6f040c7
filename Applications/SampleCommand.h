#pragma once

#include "Input.h"
#include "SampleVolume.h"

namespace ink::cli
{

/// What `ink sample` is asked for.
struct SampleOptions
{
  InputOptions input;
  std::filesystem::path output; ///< whose suffix says the format
  VolumeSampling volume;
  bool quiet = false;
};

/// Writes points on the surface of a volume or a mesh; for a volume without iso-values prints the one chosen.
/// \throw UsageError, Failure; then no file is written or changed.
void sample(const SampleOptions& options);

} // namespace ink::cli
