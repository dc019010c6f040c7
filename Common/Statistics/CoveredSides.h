// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <array>

namespace ink
{

/// The share of each side of a volume that lies above a value, 0 to 1.
/// @tparam T any of the scalar types of VTK; NaN lies not above
/// @param read called once for each slice, from the first on
/// @param slicesAtOnce the maximum number of slices per call of read, at least 1
/// @return the lower side along x, the upper one, those along y, and those along z
template <typename T>
std::array<double, 6> coveredSides(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce, double value);

/// Whether a volume surrounds what lies in it, as where distances are negative inside, and masks are
/// inverted: four of its sides are covered nearly wholly. Of blocks of rock with pores each side is covered
/// by up to .9.
bool surroundsObject(const std::array<double, 6>& sides);

} // namespace ink
