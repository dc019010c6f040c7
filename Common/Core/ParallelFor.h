// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Progress.h"

#include <cstddef>
#include <functional>

namespace ink
{

/// Calls body(0) ... body(count - 1) once each, in any order, on up to ink::threadCount() threads.
/// @return false when `progress` asked to stop; then some calls were skipped.
bool parallelFor(
  std::size_t count, const std::function<void(std::size_t)>& body, const Progress& progress = {});

} // namespace ink
