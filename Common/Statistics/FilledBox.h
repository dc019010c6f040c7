// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <array>
#include <optional>

namespace ink
{

/// The box around the voxels above a value, where they fill it (.97 or more) and it is not all of the volume:
/// what is left of a scan that was padded with the same value on some sides.
/// @tparam T any of the scalar types of VTK; NaN lies not above
/// @param read called once for each slice, from the first on
/// @param slicesAtOnce the maximum number of slices per call of read, at least 1
/// @param value in the volume's unit
/// @return first and last voxel along x, y and z
/// @throws std::invalid_argument if read returns the wrong number of voxels
template <typename T>
std::optional<std::array<int, 6>> findFilledBox(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce, double value);

} // namespace ink
