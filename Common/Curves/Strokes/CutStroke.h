// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Cuts a line into strokes as a hand draws them: about as long as is wanted, with ends that lie at random
/// and not beside those of the next line. Strokes end at the first point after where they are cut; but for
/// its last segment, none is longer than nine fifths of the wanted length, or of the mean segment where that
/// is longer.
/// @param arcLengths of the line's points, ascending
/// @param length that is wanted, in the same unit; 0: the line is one stroke
/// @param key lines of other keys are cut elsewhere
/// @return the points where strokes begin and end, ascending, the first and the last included; empty without
///   points
std::vector<std::size_t> cutStroke(std::span<const double> arcLengths, double length, std::uint64_t key);

} // namespace ink
