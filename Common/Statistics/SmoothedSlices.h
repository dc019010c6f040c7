// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <array>

namespace ink
{

/// Reads slices of a volume smoothed by the binomial kernel 1 2 1 along each axis, which leaves a quarter of
/// white noise and blurs as a Gaussian of 0.7 voxels. Voxels that are NaN or infinite, and those beyond the
/// border, weigh nothing; where only such ones are, the value is NaN.
///
/// @tparam T any of the scalar types of VTK
/// @param read called for the slices asked for and one more on both sides, at most slicesAtOnce (1 or more)
///   per call; it must outlive the result. Beside what it holds, those take 16 bytes a voxel, and the
///   smoothed ones 8
/// @return values depend on the volume alone, bitwise; read's exceptions, and std::invalid_argument if it
///   returns the wrong number of voxels
template <typename T>
SliceReader<double> smoothedSlices(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce);

} // namespace ink
