// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ink
{

/// The bins of a histogram that lie between two boundaries, or beyond the outermost ones.
struct BinRange
{
  std::size_t begin;
  std::size_t end; ///< exclusive
};

/// The value of the material that a boundary has on one side: the mean of the highest peak there. Bins are
/// averaged over an eighth of the range, so that their own noise does not matter.
///
/// @param histogram the number of voxels in each bin
/// @param range the bins on that side, up to the next boundary
/// @param boundaryAtEnd whether the boundary is at the range's end rather than at its begin
/// @return a position in bins; nothing without a peak that stands clear of the boundary, as of thin parts,
///   which never reach their material's value, or of one that varies, as bone does
std::optional<double> findMaterialValue(
  std::span<const std::int64_t> histogram, const BinRange& range, bool boundaryAtEnd);

} // namespace ink
