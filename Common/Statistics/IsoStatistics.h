// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ink
{

/// Returns the voxels of slices first to last - 1 along z; they must stay valid until the next call.
template <typename T>
using SliceReader = std::function<std::span<const T>(int first, int last)>;

/// Histogram bins; threshold i lies between the bins i and i + 1.
struct ValueBins
{
  double low = 0.0; ///< where the first begins
  double width = 1.0;
  int count = 0;
  /// What stands for values that are missing, as 1e20 on land in data of oceans, and is in no bin; NaN if
  /// nothing does: the least or the greatest of floating-point values, exactly, that lies further from all
  /// others than ten times their range, where these are measured, with 256 different values or more.
  double fill = std::numeric_limits<double>::quiet_NaN();
};

/// Statistics of a volume at each threshold. Integer sums, so that the order of summation does not matter.
struct IsoStatistics
{
  explicit IsoStatistics(const ValueBins& b);
  void add(const IsoStatistics& other);
  /// Turns differences between neighboring thresholds into the thresholds' own sums.
  void accumulate();

  ValueBins bins;
  std::vector<std::int64_t> voxels; ///< in each bin
  std::vector<std::int64_t> edges;  ///< that cross the threshold
  std::vector<std::int64_t> steps;  ///< of those edges, in bins, summed
  /// Of those edges, at the edge of a mask: the voxel behind the lower end has the lower end's value, so that
  /// no gradual transition, as a scanner's point spread makes one, begins there.
  std::vector<std::int64_t> maskEdges;
  std::vector<std::int64_t> maskSteps; ///< of the edges at masks, in bins, summed
  /// Of those edges, at voxels with at most one neighbor above the threshold.
  std::vector<std::int64_t> speckEdges;
  std::int64_t changes = 0;     ///< edges between different bins, at whatever thresholds
  std::int64_t maskChanges = 0; ///< those of them at the edge of a mask
};

/// Chooses bins for the values of a volume, excluding outliers, and counts. Each integer gets its own bin if
/// there are not too many. NaN and infinite values are skipped. The result is the same for any number of
/// threads and slices at a time. Of large volumes not all slices count: shares and mean steps hardly differ,
/// and counting takes longer than all else that an iso-value is chosen by.
///
/// @tparam T any of the scalar types of VTK
/// @param read called for consecutive slices, each at least twice, from the first on
/// @param slicesAtOnce the maximum number of slices per call of read, at least 3
/// @param mostVoxels every third, fifth, ... slice counts of volumes with three, five, ... times as many
/// voxels
/// @return nothing if there are fewer than two distinct finite values
/// @throws std::invalid_argument if slicesAtOnce is too small or read returns the wrong number of voxels
template <typename T>
std::optional<IsoStatistics> makeIsoStatistics(const SliceReader<T>& read, std::array<int, 3> dimensions,
  int slicesAtOnce, std::int64_t mostVoxels = 1 << 23);

} // namespace ink
