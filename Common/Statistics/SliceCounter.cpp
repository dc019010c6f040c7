// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/SliceCounter.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace ink
{
namespace
{

/// Whether all bins of a row are the given one.
bool isAll(std::span<const std::uint16_t> row, std::uint16_t bin)
{
  return row[0] == bin && std::memcmp(row.data(), row.data() + 1, (row.size() - 1) * sizeof(bin)) == 0;
}

bool hasGaps(std::span<const std::uint16_t> bins)
{
  std::uint16_t highest = 0;
  for (const std::uint16_t bin : bins)
  {
    highest = std::max(highest, bin);
  }
  return highest == SliceCounter::noBin;
}

} // namespace

EdgeSums::EdgeSums(int bins)
  : All(static_cast<std::size_t>(bins))
  , Mask(All.size())
{
}

void EdgeSums::moveTo(IsoStatistics& profile)
{
  move(this->All, profile.edges, profile.steps);
  move(this->Mask, profile.maskEdges, profile.maskSteps);
  profile.changes += std::exchange(this->Changes, 0);
  profile.maskChanges += std::exchange(this->MaskChanges, 0);
}

void EdgeSums::move(
  std::vector<std::uint64_t>& sums, std::vector<std::int64_t>& edges, std::vector<std::int64_t>& steps)
{
  for (std::size_t bin = 0; bin < sums.size(); ++bin)
  {
    // The lower bits with their sign.
    const std::int64_t step = static_cast<std::int64_t>(sums[bin] << (64 - stepBits)) >> (64 - stepBits);
    edges[bin] += static_cast<std::int64_t>(sums[bin] - static_cast<std::uint64_t>(step)) >> stepBits;
    steps[bin] += step;
    sums[bin] = 0;
  }
}

SliceCounter::SliceCounter(const ValueBins& bins)
  : Profile(bins)
  , Sums(bins.count)
{
}

void SliceCounter::add(std::span<const std::uint16_t> previous, std::span<const std::uint16_t> slice,
  std::span<const std::uint16_t> next, int width, int height)
{
  const auto size = static_cast<std::size_t>(width);
  this->None.assign(size, noBin);
  this->Padded.assign(size + 2, noBin);
  this->Second.resize(size);
  if (hasGaps(previous) || hasGaps(slice) || hasGaps(next))
  {
    this->addSlice<true>(previous, slice, next, height);
  }
  else
  {
    this->addSlice<false>(previous, slice, next, height);
  }
}

const IsoStatistics& SliceCounter::finish()
{
  this->Sums.moveTo(this->Profile);
  return this->Profile;
}

template <bool gaps>
void SliceCounter::addSlice(Row previous, Row slice, Row next, int height)
{
  const std::size_t width = this->None.size();
  const auto rowOf = [&](Row bins, int y) -> Row
  {
    const bool there = !bins.empty() && y >= 0 && y < height;
    return there ? bins.subspan(static_cast<std::size_t>(y) * width, width) : Row(this->None);
  };
  for (int y = 0; y < height; ++y)
  {
    const Row row = rowOf(slice, y);
    const std::array<Row, 4> around{ rowOf(slice, y - 1), rowOf(slice, y + 1), rowOf(previous, y),
      rowOf(next, y) };
    for (const std::uint16_t bin : row)
    {
      if (!gaps || bin != noBin)
      {
        ++this->Profile.voxels[bin];
      }
    }
    // Usually air: no edges and no speckles.
    if (isAll(row, row[0]) &&
      std::all_of(
        around.begin(), around.end(), [&](Row other) { return this->isNone(other) || isAll(other, row[0]); }))
    {
      continue;
    }
    this->makeRoom(4 * width);
    this->addAlong<gaps>(row);
    if (!this->isNone(around[1]))
    {
      this->addBetween<gaps>(around[0], row, around[1], rowOf(slice, y + 2));
    }
    // Of edges to other slices those whose lower ends are here.
    this->addHigher<gaps>(row, around[2], around[3]);
    this->addHigher<gaps>(row, around[3], around[2]);
    // Voxels at the border have fewer neighbors and would count as speckles.
    if (std::none_of(around.begin(), around.end(), [&](Row other) { return this->isNone(other); }))
    {
      this->addSpecks<gaps>(row, around);
    }
  }
}

void SliceCounter::makeRoom(std::size_t edges)
{
  if (this->Pending + edges > EdgeSums::room)
  {
    this->Sums.moveTo(this->Profile);
    this->Pending = 0;
  }
  this->Pending += edges;
}

/// The edge from a to b, with the voxels beyond both ends.
template <bool gaps>
void SliceCounter::addEdge(std::uint16_t a, std::uint16_t b, std::uint16_t behindA, std::uint16_t behindB)
{
  if (gaps && (a == noBin || b == noBin))
  {
    return;
  }
  const std::uint16_t low = std::min(a, b);
  const std::uint16_t high = std::max(a, b);
  this->Sums.add(low, high, (a < b ? behindA : behindB) == low);
}

/// The edges of a row.
template <bool gaps>
void SliceCounter::addAlong(Row row)
{
  std::copy(row.begin(), row.end(), this->Padded.begin() + 1);
  const std::uint16_t* const behind = this->Padded.data();
  for (std::size_t x = 0; x + 1 < row.size(); ++x)
  {
    this->addEdge<gaps>(row[x], row[x + 1], behind[x], behind[x + 3]);
  }
}

/// The edges between rows a and b.
template <bool gaps>
void SliceCounter::addBetween(Row beforeA, Row a, Row b, Row behindB)
{
  for (std::size_t x = 0; x < a.size(); ++x)
  {
    this->addEdge<gaps>(a[x], b[x], beforeA[x], behindB[x]);
  }
}

/// The edges from a row to higher values in another one.
template <bool gaps>
void SliceCounter::addHigher(Row row, Row other, Row behind)
{
  for (std::size_t x = 0; x < row.size() && !this->isNone(other); ++x)
  {
    if (!gaps || (row[x] != noBin && other[x] != noBin))
    {
      this->Sums.add(row[x], std::max(row[x], other[x]), behind[x] == row[x]);
    }
  }
}

/// Voxels are speckles at thresholds from their second highest neighbor on.
template <bool gaps>
void SliceCounter::addSpecks(Row row, const std::array<Row, 4>& around)
{
  const auto& [above, below, previous, next] = around;
  for (std::size_t x = 1; x + 1 < row.size(); ++x)
  {
    const std::uint16_t high1 = std::max(row[x - 1], row[x + 1]);
    const std::uint16_t high2 = std::max(above[x], below[x]);
    const std::uint16_t high3 = std::max(previous[x], next[x]);
    const std::uint16_t low1 = std::min(row[x - 1], row[x + 1]);
    const std::uint16_t low2 = std::min(above[x], below[x]);
    const std::uint16_t low3 = std::min(previous[x], next[x]);
    // The second of the pairs' higher ones, or the other one of a pair.
    const std::uint16_t second = std::max(std::min(high1, high2), std::min(std::max(high1, high2), high3));
    const std::uint16_t other = std::max(low1, std::max(low2, low3));
    const bool gap = gaps && std::max(high1, std::max(high2, high3)) == noBin;
    this->Second[x] = gap ? noBin : std::max(second, other);
  }
  for (std::size_t x = 1; x + 1 < row.size(); ++x)
  {
    if (this->Second[x] < row[x] && (!gaps || row[x] != noBin))
    {
      this->Profile.speckEdges[this->Second[x]] += 5;
      this->Profile.speckEdges[row[x]] -= 5;
    }
  }
}

} // namespace ink
