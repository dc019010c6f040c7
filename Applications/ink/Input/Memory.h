// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InkMemoryBudget.h"

#include <string>

namespace ink::cli
{

/// Half of the machine's memory, or of what this process is allowed if that is less.
InkMemoryBudget usualMemory();

/// As --memory has it. @throws UsageError
InkMemoryBudget parseMemory(const std::string& size);

} // namespace ink::cli
