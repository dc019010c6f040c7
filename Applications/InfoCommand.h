#pragma once

#include "Input.h"

namespace ink::cli
{

/// Prints what a file holds to the standard output stream.
/// \throw Failure
void info(const InputOptions& options, bool quiet);

} // namespace ink::cli
