// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Contours.h"

namespace ink
{

/// Points that follow each other at one position become one; a chain that is left with one point is left out.
/// @param contours with positions, kinds and elements
void joinCoincidentPoints(Contours& contours);

/// Fills `arcLength`.
void measureArcLength(Contours& contours);

} // namespace ink
