#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ink
{

/// Hands over the voxels of the slices first to last - 1 along z; they have to stay until the next call.
template <typename T>
using SliceReader = std::function<std::span<const T>(int first, int last)>;

/// Which values fall into which bin; the threshold i lies between the bins i and i + 1.
struct ValueBins
{
  double low = 0.0; ///< where the first begins
  double width = 1.0;
  int count = 0;
};

/// What is known about a volume at each threshold. Sums of integers, so that the order of summation does not
/// matter.
struct ValueProfile
{
  explicit ValueProfile(const ValueBins& b);
  void add(const ValueProfile& other);
  /// From differences between neighboring thresholds to the thresholds' own sums.
  void accumulate();

  ValueBins bins;
  std::vector<std::int64_t> voxels; ///< in each bin
  std::vector<std::int64_t> edges;  ///< that cross the threshold
  std::vector<std::int64_t> steps;  ///< of those edges, in bins, summed
  /// Of those edges, at voxels with at most one neighbor above the threshold.
  std::vector<std::int64_t> speckEdges;
};

/// Chooses bins for the values of a volume, without outliers, and counts. Integers get a bin each if those
/// are not too many. NaN and infinite values are skipped. The same for any number of threads and slices at a
/// time.
///
/// \tparam T any of the scalar types of VTK
/// \param read called for neighboring slices, each at least twice, from the first on
/// \param slicesAtOnce the most that may be asked of read in a call, at least 3
/// \return nothing if there are fewer than two different finite values
/// \throw std::invalid_argument if slicesAtOnce is too small or read gives fewer or more voxels than asked
/// for
template <typename T>
std::optional<ValueProfile> makeValueProfile(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce);

} // namespace ink
