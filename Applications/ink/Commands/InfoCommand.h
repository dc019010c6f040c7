// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"

namespace ink::cli
{

/// Prints what a file holds to the standard output stream.
/// @throws Failure
void info(const InputOptions& options, bool quiet);

} // namespace ink::cli
