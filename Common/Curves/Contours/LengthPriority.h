// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Contours.h"

#include <vector>

namespace ink
{

/// An order in which chains can be left out without breaking a drawing: the longest come first.
/// @param contours with their array `arcLength`
/// @return per chain, the length of those that are longer, or as long and before it, as a share of the length
/// of all, in [0, 1): chains with a priority less than p have at least the share p of the length of all, and
/// none of them can be spared. All 0 where no chain has a length.
std::vector<float> lengthPriorities(const Contours& contours);

} // namespace ink
