// SPDX-License-Identifier: BSD-3-Clause
// Grids that were enlarged by repeating samples (nearest neighbor), as segmentations are that were made on a
// coarse grid and brought to that of the scan: they show its blocks, however they are smoothed.
#pragma once

#include "Statistics/OriginalSamples.h"

#include <array>
#include <cstddef>

namespace ink
{

/// Finds the samples of the coarse grid, which stand in the middle of each block, where nothing changes but
/// from one block to the next, all over the grid, along two axes or more: the borders between blocks are
/// those of a regular grid, of 2 samples or more, as near as samples can be. Nearly all of those between the
/// first and the last have to show, 16 or more, and they have to differ in how much changes there, as those
/// of a segmentation do; those of fins, lattices and stairs are alike, whose shapes are what was meant.
///
/// @param samples x fastest, of 1, 2, 4 or 8 bytes each
/// @throws std::invalid_argument for other sizes
std::array<OriginalSamples, 3> findRepeatedSamples(
  const void* samples, std::size_t bytesPerSample, const std::array<int, 3>& dimensions);

} // namespace ink
