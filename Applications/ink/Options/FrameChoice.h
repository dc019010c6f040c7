// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ink::cli
{

/// Which steps of a series are drawn, from what --frames says: nothing: all; "N": so many, evenly from the
/// first to the last; "A:B" or "A:B:S": from step A to step B, both counted from 0, every S-th. @throws
/// UsageError
std::vector<std::size_t> chooseSteps(const std::string& frames, std::size_t steps);

/// How many pictures once around what stands still, from "N". @throws UsageError
std::size_t turntableFrames(const std::string& frames);

} // namespace ink::cli
