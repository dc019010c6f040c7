// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace ink
{

/// A callback that takes the fraction of work done, in [0, 1], and returns whether to continue. Empty: always
/// continue. It is only called from the thread that called the function it was passed to.
using Progress = std::function<bool(double)>;

} // namespace ink
