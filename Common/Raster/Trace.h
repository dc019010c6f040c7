// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Raster/CoverageImage.h"

#include <glm/vec2.hpp>

#include <vector>

namespace ink::raster
{

/// An 8-connected chain of pixels, as columns and rows. A closed line begins and ends with the same pixel; an
/// isolated pixel is a line of one.
using TracedLine = std::vector<glm::ivec2>;

/// The lines of a thinned drawing (thin()): every pixel with ink belongs to at least one. Lines end
/// where ink ends, and at junctions of more than two, where they share a pixel; each step from a pixel to the
/// next belongs to exactly one line. Diagonal pixels are neighbors unless a third pixel is adjacent to both.
///
/// Sorted by their first pixels, row by row, closed lines without junctions last; an open line begins at the
/// end that comes first. A drawing that is not thinned is allowed, but areas of ink are covered by many short
/// lines.
/// @throws std::invalid_argument as CoverageImage::check
std::vector<TracedLine> trace(const CoverageImage& thinned);

/// The arc length in pixels from a line's beginning to each of its points.
std::vector<float> lengthsAlong(const TracedLine& line);

} // namespace ink::raster
