// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ink
{

/// A round dot with an antialiased rim of one pixel, whose area is correct even below a pixel.
struct DotShape
{
  float radius;    ///< to half coverage at the rim, in pixels
  float intensity; ///< of a fully covered pixel
};

/// The antialiased dot whose pixels add up to the area of a sharp one, averaged over its positions within a
/// pixel.
/// @param diameter in pixels, not negative
DotShape dotShape(float diameter);

/// The dot's coverage of a pixel.
/// @param distance between the pixel's and the dot's centers in pixels
float dotCoverage(const DotShape& dot, float distance);

/// For render targets of few bits, where very pale dots would be rounded away: of dots paler than `least`, a
/// subset with the same total ink gets that intensity, and the others none. Other dots are unchanged.
/// @param index of the dot's element, which has at most one pale stipple; the subset is even in every range
///   of consecutive indices
float thinnedIntensity(float intensity, float least, std::uint32_t index);

} // namespace ink
