#pragma once

#include <cstddef>
#include <functional>

namespace ink
{

/// Takes the share of work done, in [0, 1], and returns whether to go on. Empty: go on, tell no one. It is
/// only called from the thread that called the function which takes it.
using Progress = std::function<bool(double)>;

/// Calls body(0) ... body(count - 1) once each, in any order, on up to ink::threadCount() threads.
/// \returns false when `progress` asked to stop; then some calls were left out.
bool parallelFor(
  std::size_t count, const std::function<void(std::size_t)>& body, const Progress& progress = {});

} // namespace ink
