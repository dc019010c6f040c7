// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Contours/Contours.h"

namespace ink
{

/// Points that follow each other at one position become one, the last of them; a chain that is left with one
/// point is left out. All arrays but `arcLength` follow; an open chain's last element repeats the one before.
/// @param contours without arc length
void joinCoincidentPoints(Contours& contours);

/// Fills `arcLength`.
void measureArcLength(Contours& contours);

} // namespace ink
