// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ink
{

/// Whether values are labels, or a mask, rather than measured: between them they change from one voxel to the
/// next, without a gradual transition. Of segmentations .76 to .95 of the changes are so, of scans whose
/// background was set to one value up to .33. Of the edges that an iso-surface crosses .8 to 1 of
/// segmentations and of scans that were cut out by a mask, as brains are, but up to .09 of others.
/// @param maskChanges, changes all of them, as IsoStatistics counts them, or those at a surface
inline bool areLabels(std::int64_t maskChanges, std::int64_t changes)
{
  constexpr double labelShare = 0.6;
  return static_cast<double>(maskChanges) > labelShare * static_cast<double>(changes);
}

/// Whether values are measured, though most lie beside others of the same value, as where a scan was reduced
/// to few gray levels: there are many, and mostly they change by one. By 1.3 levels as a mean in a scan of 33
/// levels, by 9 and more in labels of 16 or more. Labels that lie in layers, in their order, look the same.
inline bool areGrayLevels(double levels, double meanChange)
{
  constexpr double leastLevels = 16.0;
  constexpr double largestChange = 3.0;
  return levels >= leastLevels && meanChange < largestChange;
}

} // namespace ink
