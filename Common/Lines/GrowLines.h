#pragma once

#include "Lines/InkImage.h"

namespace ink
{

/// The furthest that growLines() can move a line's edge.
inline constexpr float mostLineGrowth = 128.0f;

/// Widens lines by `radius` pixels on each side: each pixel gets the most ink that lies within the radius.
/// What lies up to a pixel further counts in proportion, w(d) = radius + 1 - d in [0, 1], so that edges stay
/// smooth and fractions of a pixel show. A negative radius makes lines narrower in the same way: the empty
/// paper is widened instead. Ink never falls as the radius rises; 0 changes nothing. -128 to 128, clamped;
/// what is not a number is 0. What lies beyond the picture's border does not count.
///
/// The same on any number of threads, and a mirrored picture gives the mirrored result.
/// \throws std::invalid_argument as InkImage::check
void growLines(const InkImage& image, float radius);

} // namespace ink
