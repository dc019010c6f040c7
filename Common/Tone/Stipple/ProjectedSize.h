// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink::stipple
{

/// No more stipples are made for a picture of a surface unless their number is asked for: memory.
inline constexpr int mostForPicture = 2'000'000;

/// N_max (Lu et al. 2003, section 4.3): the number of stipples that an element of average size has room for
/// at a distance, one per `pixelsPerStipple` pixels of its largest projection there.
/// @param elementSize edge of a voxel, or square root of a polygon's area, in view units; positive
/// @param pixelSize view units that a pixel covers at that distance; positive
/// @param pixelsPerStipple 1: as in the paper; about the number of pixels that a stipple covers, divided by
///   the darkest gray wanted
///   Elements wider than a million pixels count as that wide, far beyond any window.
float maximumStipples(float elementSize, float pixelSize, float pixelsPerStipple);

/// The same as the length of a list: one stipple per pixel, rounded, from 1 to `longest`.
int projectedListLength(float elementSize, float pixelSize, int longest);

} // namespace ink::stipple
