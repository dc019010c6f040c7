// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <array>

namespace ink
{

/// How many samples along each axis an iso-surface of a volume spans: those between which all but a hundredth
/// of the edges lie that it crosses, so that specks hardly count.
/// @tparam T any of the scalar types of VTK; NaN lies below each value
/// @param read called for consecutive slices, of which one is read again with the next ones
/// @param slicesAtOnce the maximum number of slices per call of read, at least 2, or all
/// @return 0 along each axis if there is no surface
template <typename T>
std::array<int, 3> activeCellExtent(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce, double isoValue);

} // namespace ink
