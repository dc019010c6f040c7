// SPDX-License-Identifier: BSD-3-Clause
// Grids whose slices were interpolated between those of a scan, as where thick ones were brought to cubic
// voxels: surfaces of them are terraces, see sliceDistances, which finds better ones between the slices of
// the scan themselves.
#pragma once

#include "Statistics/OriginalSamples.h"

#include <array>

namespace ink
{

template <class T>
class GridField;

/// Finds the slices of the scan: along the axis in which values bend much less than within slices, by second
/// differences, and more at every slice of the scan than between two. How often that is, 2.2 to 10 samples,
/// is where the periodogram of second differences, averaged over parts of the slices, has a peak. So slices
/// may be a little oblique to the grid, as where the scan was moved onto another one; those found are then
/// blends of two.
///
/// Of 150 volumes, nine were so, and all of them are found but for one of which it does not show: values bend
/// along the axis .16 to .35 times as much as along any other, and the peak is 25 to 100 times as high as
/// what is around it; of what is not so, it is up to 6 times where values bend as little.
///
/// Reads every line of small grids, 96 x 96 along each axis of larger ones.
///
/// @return steps of more than 1 along one axis at most; slices further apart than half of the finest ones of
///   the others only, which alone are thick, see thickSlices
/// @tparam T any of INK_FOR_EACH_SCALAR
template <class T>
std::array<OriginalSamples, 3> findInterpolatedSlices(const GridField<T>& field);

} // namespace ink
