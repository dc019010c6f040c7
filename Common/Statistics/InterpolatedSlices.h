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
/// differences, and more at every slice of the scan than between two. How often that is, every 2.2 to 10
/// samples, is where the periodogram of second differences, averaged over parts of the slices, has a peak. So
/// slices may be oblique to the grid by some degrees, as where a scan was moved onto another one; those found
/// then are blends of two. What repeats along another axis, too, is a lattice.
///
/// Of 150 volumes eight are found, seven of them brains that were moved onto another scan: values bend along
/// the axis .19 to .46 times as much as along any other, the peak is 24 to 300 times as high as what is
/// around it, and bends are .28 times as large as the mean or more where it is. A peak of 60 times is enough
/// where values bend up to .55 times as much, one of 12 times up to .4, of bends of .17. Slices that were
/// interpolated by cubic or longer kernels and have no noise are not found.
///
/// Reads every line of small grids, 96 x 96 along each axis of larger ones.
///
/// @return steps of more than 1 along one axis at most, of slices that are thick then, see thickSlices, in a
///   grid whose slices are not. The first and the last one may stand a quarter of a step outside of the grid
/// @tparam T any of INK_FOR_EACH_SCALAR
template <class T>
std::array<OriginalSamples, 3> findInterpolatedSlices(const GridField<T>& field);

} // namespace ink
