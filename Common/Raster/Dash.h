// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Raster/Trace.h"

#include <span>

namespace ink::raster
{

/// Dashes lines: keeps only ink whose nearest point on a line lies within a dash. Along each line, dashes of
/// `dash` pixels alternate with gaps of `gap` pixels, both scaled slightly by the same factor so that every
/// line begins and ends with a whole dash (a closed one with a whole dash and gap). So a line too short for
/// two dashes stays solid, and lines meet in dashes, not gaps. Dashes are antialiased over a pixel; dashes
/// and gaps shorter than that average to gray.
///
/// @param lines those of the thinned drawing (thin(), trace()), with pixels inside the image. Each
///   pixel of ink belongs to the nearest line that is connected to it through ink; without one, it stays.
/// @param dash more than 0; otherwise, or if `gap` is not more than 0, nothing changes
/// @throws std::invalid_argument as CoverageImage::check, or when a line leaves the image
void dash(const CoverageImage& image, std::span<const TracedLine> lines, float dash, float gap);

} // namespace ink::raster
