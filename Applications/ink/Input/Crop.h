// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace ink::cli
{

struct Input;

/// Keeps of a volume, a mesh or points only what lies in a box: whole voxels, polygons cut at its sides,
/// points.
/// @param box x, y and z from and to, in world coordinates
/// @throws Failure if nothing is left, or for a volume that is not in memory as a whole
void crop(Input& input, const std::array<double, 6>& box);

} // namespace ink::cli
