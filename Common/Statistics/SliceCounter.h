// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ink
{

/// Sums of edges by thresholds, see IsoStatistics: for speed the number of edges and their steps in one word,
/// in arithmetic modulo 2^64.
class EdgeSums
{
public:
  /// So many edges have room, between bins that are less than SliceCounter::mostBins apart.
  static constexpr std::size_t room = std::size_t(1) << 22;

  explicit EdgeSums(int bins);

  /// An edge between two bins, at a mask or not. Nothing for equal ones.
  void add(std::uint16_t low, std::uint16_t high, bool mask)
  {
    const std::uint64_t edge = oneEdge + static_cast<std::uint64_t>(high - low);
    this->All[low] += edge;
    this->All[high] -= edge;
    this->Changes += low < high;
    if (mask)
    {
      this->Mask[low] += edge;
      this->Mask[high] -= edge;
      this->MaskChanges += low < high;
    }
  }

  /// Adds them to a profile, and starts anew.
  void moveTo(IsoStatistics& profile);

private:
  static constexpr int stepBits = 36;
  static constexpr std::uint64_t oneEdge = std::uint64_t(1) << stepBits;

  static void move(
    std::vector<std::uint64_t>& sums, std::vector<std::int64_t>& edges, std::vector<std::int64_t>& steps);

  std::vector<std::uint64_t> All;
  std::vector<std::uint64_t> Mask;
  std::int64_t Changes = 0;
  std::int64_t MaskChanges = 0;
};

/// Counts what IsoStatistics holds, slice by slice, of the bins of a volume's voxels.
class SliceCounter
{
public:
  static constexpr int mostBins = 4096;
  /// Of a voxel that does not count.
  static constexpr std::uint16_t noBin = std::numeric_limits<std::uint16_t>::max();

  /// @param bins at most mostBins
  explicit SliceCounter(const ValueBins& bins);

  /// Each span holds width x height bins.
  /// @param previous the slice before; empty beyond the volume, as is the next one
  void add(std::span<const std::uint16_t> previous, std::span<const std::uint16_t> slice,
    std::span<const std::uint16_t> next, int width, int height);

  /// What was counted, differences between neighboring thresholds: see IsoStatistics::accumulate.
  const IsoStatistics& finish();

private:
  using Row = std::span<const std::uint16_t>;

  /// @tparam gaps whether there are voxels that do not count
  template <bool gaps>
  void addSlice(Row previous, Row slice, Row next, int height);
  template <bool gaps>
  void addEdge(std::uint16_t a, std::uint16_t b, std::uint16_t behindA, std::uint16_t behindB);
  template <bool gaps>
  void addAlong(Row row);
  template <bool gaps>
  void addBetween(Row beforeA, Row a, Row b, Row behindB);
  template <bool gaps>
  void addHigher(Row row, Row other, Row behind);
  template <bool gaps>
  void addSpecks(Row row, const std::array<Row, 4>& around);
  bool isNone(Row row) const { return row.data() == this->None.data(); }
  void makeRoom(std::size_t edges);

  IsoStatistics Profile;
  EdgeSums Sums;
  std::size_t Pending = 0;           ///< edges in the sums
  std::vector<std::uint16_t> None;   ///< a row that is not there
  std::vector<std::uint16_t> Padded; ///< a row between two voxels that are not there
  std::vector<std::uint16_t> Second; ///< the second highest neighbors
};

} // namespace ink
