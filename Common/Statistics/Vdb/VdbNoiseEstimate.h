// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/NoiseEstimate.h"

namespace ink
{

class VdbGrid;

/// Estimates the noise around an iso-surface of a sparse grid, as estimateNoise does of a dense one, from its
/// leaves. Where the grid is about a surface, as level sets and narrow bands are, inactive voxels are
/// missing: they only tell which side they are on. Otherwise they have their values.
///
/// @param negate the values are multiplied by -1 first
NoiseEstimate estimateNoise(const VdbGrid& grid, double isoValue, bool negate);

} // namespace ink
