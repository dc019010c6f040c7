// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace ink
{

/// The two axes of three beside one, in order.
constexpr std::array<int, 2> otherAxes(int axis)
{
  return { axis == 0 ? 1 : 0, axis == 2 ? 1 : 2 };
}

} // namespace ink
