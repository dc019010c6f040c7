// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoStatistics.h"

#include "Core/Threads.h"
#include "Fields/ScalarDifference.h"
#include "Statistics/FiniteRange.h"
#include "Statistics/SliceCounter.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace ink
{
namespace
{

// The fraction of voxels at either end of the range that may be outliers.
constexpr double outlierShare = 1e-4;

// So many slices are counted at least, if there are.
constexpr int fewestSlices = 32;

template <typename T>
std::uint16_t binOf(const ValueBins& bins, T value)
{
  if constexpr (std::is_integral_v<T> && sizeof(T) <= 2)
  {
    // Quicker, and the same.
    if (bins.width == 1.0)
    {
      const int first = static_cast<int>(bins.low + 0.5 * bins.width);
      return static_cast<std::uint16_t>(std::clamp(static_cast<int>(value) - first, 0, bins.count - 1));
    }
  }
  const double v = static_cast<double>(value);
  if (!std::isfinite(v) || v == bins.fill)
  {
    return SliceCounter::noBin;
  }
  return static_cast<std::uint16_t>(std::clamp((v - bins.low) / bins.width, 0.0, bins.count - 1.0));
}

/// A volume whose slices are read a few at a time.
template <typename T>
struct Slices
{
  const SliceReader<T>& read;
  std::array<int, 3> dimensions;
  int atOnce;

  std::size_t sliceSize() const
  {
    return static_cast<std::size_t>(this->dimensions[0]) * this->dimensions[1];
  }
  std::span<const T> get(int first, int last) const
  {
    const std::span<const T> values = this->read(first, last);
    const std::size_t expected = this->sliceSize() * (last - first);
    if (values.size() != expected)
    {
      throw std::invalid_argument("makeIsoStatistics: " + std::to_string(values.size()) + " values, but " +
        std::to_string(this->dimensions[0]) + " x " + std::to_string(this->dimensions[1]) + " x " +
        std::to_string(last - first) + " voxels");
    }
    return values;
  }
};

/// See ValueBins::fill.
double findFill(const std::vector<double>& sample)
{
  constexpr std::ptrdiff_t fewestDifferent = 256;
  constexpr double farAway = 10.0;
  // The two lowest values, and the two greatest.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[2] = { infinity, infinity };
  double high[2] = { -infinity, -infinity };
  for (const double v : sample)
  {
    low[1] = v < low[0] ? low[0] : v > low[0] && v < low[1] ? v : low[1];
    low[0] = std::min(low[0], v);
    high[1] = v > high[0] ? high[0] : v < high[0] && v > high[1] ? v : high[1];
    high[0] = std::max(high[0], v);
  }
  // Halves, as differences of large values may overflow.
  const auto isFar = [](double fill, double nearest, double farthest)
  { return std::abs(fill / 2 - nearest / 2) > farAway * std::abs(farthest / 2 - nearest / 2); };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const double fill = isFar(low[0], low[1], high[0]) ? low[0]
    : isFar(high[0], high[1], low[0])                ? high[0]
                                                     : none;
  if (std::count(sample.begin(), sample.end(), fill) < 2)
  {
    return none;
  }
  std::vector<double> sorted(sample);
  std::sort(sorted.begin(), sorted.end());
  const auto different = std::unique(sorted.begin(), sorted.end()) - sorted.begin();
  return different > fewestDifferent ? fill : none;
}

template <typename T>
std::optional<ValueBins> chooseBins(const Slices<T>& slices)
{
  FiniteRange range;
  std::vector<double> sample;
  const std::size_t count = slices.sliceSize() * slices.dimensions[2];
  const std::size_t step = std::max<std::size_t>(1, count / 1000000);
  std::size_t next = 0; // voxel of the sample, from the first of those read
  for (int first = 0; first < slices.dimensions[2]; first += slices.atOnce)
  {
    const std::span<const T> values =
      slices.get(first, std::min(first + slices.atOnce, slices.dimensions[2]));
    range.add(findFiniteRange(values));
    for (; next < values.size(); next += step)
    {
      const double v = static_cast<double>(values[next]);
      if (std::isfinite(v))
      {
        sample.push_back(v);
      }
    }
    next -= values.size();
  }
  double least = range.least;
  double greatest = range.greatest;
  if (!(least < greatest))
  {
    return std::nullopt;
  }

  const double fill =
    std::is_floating_point_v<T> ? findFill(sample) : std::numeric_limits<double>::quiet_NaN();
  std::erase(sample, fill);
  if (!sample.empty())
  {
    const auto outliers = static_cast<std::ptrdiff_t>(outlierShare * static_cast<double>(sample.size()));
    std::nth_element(sample.begin(), sample.begin() + outliers, sample.end());
    const double low = sample[outliers];
    std::nth_element(sample.begin(), sample.end() - 1 - outliers, sample.end());
    const double high = sample[sample.size() - 1 - outliers];
    if (low < high)
    {
      least = low;
      greatest = high;
    }
  }

  // Integers get one bin each, centered on them, where that is not too many. Halves: the full range of a
  // double does not fit in a double.
  const double halfRange = greatest / 2 - least / 2;
  if (std::is_integral_v<T> && halfRange < (SliceCounter::mostBins - 1) / 2.0)
  {
    return ValueBins{ least - 0.5, 1.0, static_cast<int>(std::lround(2 * halfRange)) + 1 };
  }
  return ValueBins{ least,
    std::max(halfRange / SliceCounter::mostBins * 2, std::numeric_limits<double>::min()),
    SliceCounter::mostBins, fill };
}

/// Every how many slices one is counted. Odd, so that slices that were interpolated between others do not
/// all count or all fail to.
int findCountedStep(const std::array<int, 3>& dimensions, std::int64_t mostVoxels)
{
  const std::int64_t slice = static_cast<std::int64_t>(dimensions[0]) * dimensions[1];
  const std::int64_t all = slice * dimensions[2];
  const std::int64_t step =
    std::min<std::int64_t>(all / std::max<std::int64_t>(mostVoxels, 1), dimensions[2] / fewestSlices);
  return static_cast<int>(std::max<std::int64_t>(step % 2 == 0 ? step - 1 : step, 1));
}

template <typename T>
IsoStatistics countValues(const Slices<T>& slices, const ValueBins& bins, std::int64_t mostVoxels)
{
  const std::array<int, 3> dimensions = slices.dimensions;
  const std::size_t sliceSize = slices.sliceSize();
  const int step = findCountedStep(dimensions, mostVoxels);
  tbb::combinable<SliceCounter> partial([&bins] { return SliceCounter(bins); });
  // Each slice with its neighbors.
  const int own = slices.atOnce - 2;
  for (int begin = 0; begin < dimensions[2]; begin += own)
  {
    const int end = std::min(begin + own, dimensions[2]);
    const int first = std::max(begin - 1, 0);
    const int last = std::min(end + 1, dimensions[2]);
    const std::span<const T> values = slices.get(first, last);
    const auto addSlab = [&](const tbb::blocked_range<int>& range)
    {
      SliceCounter& counter = partial.local();
      const auto binned = [&](int z)
      {
        std::vector<std::uint16_t> slice;
        if (z >= first && z < last)
        {
          slice.resize(sliceSize);
          const auto source = values.subspan(sliceSize * (z - first), sliceSize);
          std::transform(source.begin(), source.end(), slice.begin(), [&](T v) { return binOf(bins, v); });
        }
        return slice;
      };
      std::vector<std::uint16_t> previous;
      std::vector<std::uint16_t> slice;
      std::vector<std::uint16_t> next;
      for (int z = range.begin(); z < range.end(); ++z)
      {
        if (z % step != step / 2)
        {
          continue;
        }
        const bool goesOn = step == 1 && z > range.begin();
        previous = goesOn ? std::move(slice) : binned(z - 1);
        slice = goesOn ? std::move(next) : binned(z);
        next = binned(z + 1);
        counter.add(previous, slice, next, dimensions[0], dimensions[1]);
      }
    };
    tbb::task_arena(threadCount())
      .execute([&] { tbb::parallel_for(tbb::blocked_range<int>(begin, end, 16), addSlab); });
  }

  IsoStatistics total(bins);
  partial.combine_each([&total](SliceCounter& counter) { total.add(counter.finish()); });
  total.accumulate();
  return total;
}

} // namespace

IsoStatistics::IsoStatistics(const ValueBins& b)
  : bins(b)
  , voxels(b.count)
  , edges(b.count)
  , steps(b.count)
  , maskEdges(b.count)
  , maskSteps(b.count)
  , speckEdges(b.count)
{
}

void IsoStatistics::add(const IsoStatistics& other)
{
  for (auto sums : { &IsoStatistics::voxels, &IsoStatistics::edges, &IsoStatistics::steps,
         &IsoStatistics::maskEdges, &IsoStatistics::maskSteps, &IsoStatistics::speckEdges })
  {
    std::transform((this->*sums).begin(), (this->*sums).end(), (other.*sums).begin(), (this->*sums).begin(),
      std::plus<>());
  }
  this->changes += other.changes;
  this->maskChanges += other.maskChanges;
}

void IsoStatistics::accumulate()
{
  for (auto* sums : { &this->edges, &this->steps, &this->maskEdges, &this->maskSteps, &this->speckEdges })
  {
    std::partial_sum(sums->begin(), sums->end(), sums->begin());
  }
}

template <typename T>
std::optional<IsoStatistics> makeIsoStatistics(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce, std::int64_t mostVoxels)
{
  if (slicesAtOnce < 3)
  {
    throw std::invalid_argument(
      "makeIsoStatistics: " + std::to_string(slicesAtOnce) + " slices at once, expected 3 or more");
  }
  const Slices<T> slices{ read, dimensions, slicesAtOnce };
  const std::optional<ValueBins> bins = chooseBins(slices);
  return bins ? std::optional(countValues(slices, *bins, mostVoxels)) : std::nullopt;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::optional<IsoStatistics> makeIsoStatistics(                                                   \
    const SliceReader<T>&, std::array<int, 3>, int, std::int64_t);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
