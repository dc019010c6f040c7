// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Cuts a line into strokes as a hand draws them: about as long as is wanted, none more than nine fifths of
/// that, with ends that lie at random and not beside those of the next line.
/// @param arcLengths of the line's points, ascending
/// @param length of a stroke, in the same unit; 0: the line is one stroke
/// @param key lines of other keys are cut elsewhere
/// @return the points where strokes begin and end, ascending, the first and the last included; empty without
///   points
std::vector<std::size_t> cutStroke(std::span<const double> arcLengths, double length, std::uint64_t key);

} // namespace ink
