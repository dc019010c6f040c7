// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ActiveCellExtent.h"

#include "Core/ParallelFor.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/IsoThreshold.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace ink
{
namespace
{

/// Of the edges that are crossed, at either end of an axis.
constexpr double outlyingShare = 0.005;

/// The edges that are crossed from the samples of a slice on, by x and by y.
struct SliceCounts
{
  std::vector<std::int64_t> x;
  std::vector<std::int64_t> y;
};

/// @param next the slice behind it; none behind the last one
template <class T>
SliceCounts countSlice(
  std::span<const T> slice, std::span<const T> next, std::size_t nx, std::size_t ny, T lowest)
{
  SliceCounts counts = { std::vector<std::int64_t>(nx), std::vector<std::int64_t>(ny) };
  std::vector<std::uint8_t> crossed(nx);
  for (std::size_t y = 0; y < ny; ++y)
  {
    const T* const row = slice.data() + y * nx;
    const T* const above = y + 1 < ny ? row + nx : row;
    const T* const behind = next.empty() ? row : next.data() + y * nx;
    for (std::size_t x = 0; x + 1 < nx; ++x)
    {
      const bool inside = row[x] >= lowest;
      crossed[x] = static_cast<std::uint8_t>((inside != (row[x + 1] >= lowest)) +
        (inside != (above[x] >= lowest)) + (inside != (behind[x] >= lowest)));
    }
    const bool last = row[nx - 1] >= lowest;
    crossed[nx - 1] =
      static_cast<std::uint8_t>((last != (above[nx - 1] >= lowest)) + (last != (behind[nx - 1] >= lowest)));
    std::transform(crossed.begin(), crossed.end(), counts.x.begin(), counts.x.begin(), std::plus());
    counts.y[y] = std::accumulate(crossed.begin(), crossed.end(), std::int64_t{ 0 });
  }
  return counts;
}

int extentOf(const std::vector<std::int64_t>& counts)
{
  const auto total = std::accumulate(counts.begin(), counts.end(), std::int64_t{ 0 });
  const auto outlying = static_cast<std::int64_t>(outlyingShare * static_cast<double>(total));
  // The samples at an end that have no more than these.
  const auto countOutlying = [&](auto begin, auto end)
  {
    std::int64_t sum = 0;
    return std::find_if(begin, end, [&](std::int64_t count) { return (sum += count) > outlying; }) - begin;
  };
  return total == 0
    ? 0
    : static_cast<int>(static_cast<std::ptrdiff_t>(counts.size()) -
        countOutlying(counts.begin(), counts.end()) - countOutlying(counts.rbegin(), counts.rend()));
}

} // namespace

template <typename T>
std::array<int, 3> activeCellExtent(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, int slicesAtOnce, double isoValue)
{
  const IsoThreshold<T> threshold = IsoThreshold<T>::atLeast(isoValue);
  if (!threshold.reachable)
  {
    return {};
  }
  const auto nx = static_cast<std::size_t>(dimensions[0]);
  const auto ny = static_cast<std::size_t>(dimensions[1]);
  const std::size_t slice = nx * ny;
  std::vector<std::int64_t> x(nx);
  std::vector<std::int64_t> y(ny);
  std::vector<std::int64_t> z(static_cast<std::size_t>(dimensions[2]));
  for (int first = 0; first < dimensions[2];)
  {
    const int end = std::min(first + slicesAtOnce, dimensions[2]);
    const std::span<const T> values = read(first, end);
    // The last one is counted with the next, if there is any.
    const int counted = end < dimensions[2] ? end - 1 : end;
    std::vector<SliceCounts> counts(static_cast<std::size_t>(counted - first));
    parallelFor(counts.size(),
      [&](std::size_t n)
      {
        const bool hasNext = first + static_cast<int>(n) + 1 < end;
        counts[n] = countSlice<T>(values.subspan(n * slice, slice),
          hasNext ? values.subspan((n + 1) * slice, slice) : std::span<const T>(), nx, ny, threshold.lowest);
      });
    for (const SliceCounts& one : counts)
    {
      std::transform(one.x.begin(), one.x.end(), x.begin(), x.begin(), std::plus());
      std::transform(one.y.begin(), one.y.end(), y.begin(), y.begin(), std::plus());
      z[static_cast<std::size_t>(first)] = std::accumulate(one.y.begin(), one.y.end(), std::int64_t{ 0 });
      ++first;
    }
  }
  return { extentOf(x), extentOf(y), extentOf(z) };
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::array<int, 3> activeCellExtent(const SliceReader<T>&, const std::array<int, 3>&, int, double);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
