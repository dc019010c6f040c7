// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Internal to Common/Statistics: what each threshold between bins of a volume's values would be as an
/// iso-value.
namespace ink
{

/// The edges that cross each threshold and the sums of their steps.
struct ThresholdEdges
{
  std::vector<std::int64_t> edges;
  std::vector<std::int64_t> steps;
};

/// Those that do not begin in a mask.
ThresholdEdges withoutMasks(const IsoStatistics& statistics);

/// The share of the voxels above each threshold.
std::vector<double> keptShares(const std::vector<std::int64_t>& voxels);

/// Whether each threshold is noise, or the border of the field of view.
/// @param edges that cross it
std::vector<bool> findNoisyThresholds(const std::vector<std::int64_t>& edges,
  const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept);

/// The mean step along the edges that cross each threshold. Infinite for noise and the border of the field of
/// view, so that nothing beside them is a maximum; zero for thresholds that hardly any edge crosses.
std::vector<double> thresholdSharpness(
  const ThresholdEdges& sums, const std::vector<std::int64_t>& speckEdges, const std::vector<double>& kept);

/// The mean step along the edges that cross a threshold, in bins.
double meanStep(const IsoStatistics& statistics, std::size_t threshold);

/// The share of these edges that lie at voxels with at most one neighbor above. NaN if there are none.
double speckShare(const IsoStatistics& statistics, std::size_t threshold);

/// The threshold between bins that is nearest to a value.
std::size_t thresholdAt(const ValueBins& bins, double value);

/// Whether the surface of a value would be noise for the most part, or so thin that it breaks up.
bool isSpeckled(const IsoStatistics& statistics, double value);

/// Whether so many of the steps lie at thresholds that are noise that it can hide boundaries.
bool noiseHidesBoundaries(const IsoStatistics& statistics);

/// Whether steps at a threshold are much larger than where they are smallest, within a material: smoothed
/// noise has maxima of sharpness of its own, where values are rare.
bool isSharperThanNoise(const IsoStatistics& statistics, std::size_t threshold);

} // namespace ink
