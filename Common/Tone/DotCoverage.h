#pragma once

#include <cstdint>

namespace ink
{

/// A round dot with a soft rim of one pixel, and its area right also where it is smaller than a pixel.
struct DotShape
{
  float radius;    ///< where the rim is half covered, in pixels
  float intensity; ///< of a pixel that is covered all over
};

/// The soft dot whose pixels add up to the area of a sharp one, on the average over its places within a
/// pixel.
/// @param diameter in pixels, not negative
DotShape dotShape(float diameter);

/// How much of a pixel the dot covers.
/// @param distance between the pixel's and the dot's centers in pixels
float dotCoverage(const DotShape& dot, float distance);

/// For targets of few bits, which cannot add up very pale dots: of dots paler than `least`, as many as have
/// the same ink together get that intensity, and the others none. Other dots stay as they are.
/// @param index of the dot's element, of whose stipples at most one is pale; of any row of elements that
///   follow each other, evenly spread ones are kept
float thinnedIntensity(float intensity, float least, std::uint32_t index);

} // namespace ink
