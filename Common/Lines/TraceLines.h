#pragma once

#include "Lines/InkImage.h"

#include <glm/vec2.hpp>

#include <vector>

namespace ink
{

/// Pixels from one to the next, as columns and rows; neighbors touch by sides or corners. A closed line
/// begins and ends with the same pixel; a lone pixel is a line of one.
using TracedLine = std::vector<glm::ivec2>;

/// The lines of a thinned drawing (thinLines()): every pixel with ink belongs to at least one. Lines end
/// where ink ends and where more than two meet, there with the pixel in common; each way from a pixel to the
/// next is in one line only, once. Pixels that touch by a corner are next to each other unless a third one
/// touches both by sides.
///
/// In the order of their first pixels, row by row, closed lines without junctions last; a line from one end
/// to another begins with the first of both. No thinned drawing is an error, too, but areas of ink are
/// covered by many short lines.
/// \throws std::invalid_argument as InkImage::check
std::vector<TracedLine> traceLines(const InkImage& thinned);

/// The way along a line in pixels, from its beginning to each of its points.
std::vector<float> lengthsAlong(const TracedLine& line);

} // namespace ink
