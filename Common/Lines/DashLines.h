#pragma once

#include "Lines/TraceLines.h"

#include <span>

namespace ink
{

/// Interrupts lines: leaves the ink the nearest point of whose line lies within a dash. Dashes of `dash`
/// pixels and gaps of `gap` pixels follow each other along each of the lines, both made a little longer or
/// shorter, by the same factor, so that every line begins and ends with a whole dash (a closed one with a
/// whole dash and gap). So a line too short for two dashes stays whole, and lines that meet do so in ink.
/// Where a dash ends, ink fades over a pixel; dashes and gaps that are shorter make a gray.
///
/// @param lines those of the thinned drawing (thinLines(), traceLines()), with pixels within the picture.
///   Each pixel of ink belongs to the nearest that is to be reached through ink; where none is, it stays.
/// @param dash more than 0; otherwise, or if `gap` is not more than 0, nothing changes
/// \throws std::invalid_argument as InkImage::check, or when a line leaves the picture
void dashLines(const InkImage& image, std::span<const TracedLine> lines, float dash, float gap);

} // namespace ink
