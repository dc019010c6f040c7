#include "Statistics/IsoValue.h"

#include "Parallel/Threads.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ink
{
namespace
{

constexpr int maximumBins = 4096;
// A surface crossed by fewer edges says nothing about sharpness.
constexpr std::int64_t fewestEdges = 200;
// A maximum counts if the sharpness falls by this fraction on both sides of it.
constexpr double prominence = 0.05;
// The share of a surface's edges that may belong to voxels with at most one neighbour inside; above it is
// noise.
constexpr double largestSpeckShare = 0.05;
// A disc that touches the sides of its square covers 78.5 % of it: the border of a round field of view.
constexpr double largestInsideShare = 0.75;
// The share of voxels at either end of the range that may be outliers.
constexpr double outlierShare = 1e-4;

constexpr std::uint16_t noBin = std::numeric_limits<std::uint16_t>::max();

/// Maps values to bins; the threshold i lies between the bins i and i + 1.
struct Binning
{
  double low = 0.0;
  double width = 1.0;
  int count = 0;

  template <typename T>
  std::uint16_t bin(T value) const
  {
    const double v = static_cast<double>(value);
    if (!std::isfinite(v))
    {
      return noBin;
    }
    return static_cast<std::uint16_t>(std::clamp((v - this->low) / this->width, 0.0, this->count - 1.0));
  }
};

/// A volume whose slices are handed over a few at a time.
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
      throw std::invalid_argument("suggestIsoValue: " + std::to_string(values.size()) + " values, but " +
        std::to_string(this->dimensions[0]) + " x " + std::to_string(this->dimensions[1]) + " x " +
        std::to_string(last - first) + " voxels");
    }
    return values;
  }
};

template <typename T>
std::optional<Binning> chooseBinning(const Slices<T>& slices)
{
  double least = std::numeric_limits<double>::max();
  double greatest = std::numeric_limits<double>::lowest();
  std::vector<double> sample;
  const std::size_t count = slices.sliceSize() * slices.dimensions[2];
  const std::size_t step = std::max<std::size_t>(1, count / 1000000);
  std::size_t i = 0;
  for (int first = 0; first < slices.dimensions[2]; first += slices.atOnce)
  {
    for (const T value : slices.get(first, std::min(first + slices.atOnce, slices.dimensions[2])))
    {
      const double v = static_cast<double>(value);
      if (std::isfinite(v))
      {
        least = std::min(least, v);
        greatest = std::max(greatest, v);
        if (i % step == 0)
        {
          sample.push_back(v);
        }
      }
      ++i;
    }
  }
  if (!(least < greatest))
  {
    return std::nullopt;
  }

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

  // Integers get one bin each, centred on them, where that is not too many. Halves: the full range of a
  // double does not fit in a double.
  const double halfRange = greatest / 2 - least / 2;
  if (std::is_integral_v<T> && halfRange < (maximumBins - 1) / 2.0)
  {
    return Binning{ least - 0.5, 1.0, static_cast<int>(std::lround(2 * halfRange)) + 1 };
  }
  return Binning{ least, std::max(halfRange / maximumBins * 2, std::numeric_limits<double>::min()),
    maximumBins };
}

/// What is known about each threshold. Sums of integers, so that the order of summation does not matter.
struct Profile
{
  explicit Profile(int bins)
    : voxels(bins)
    , edges(bins)
    , steps(bins)
    , speckEdges(bins)
  {
  }

  void add(const Profile& other)
  {
    for (std::size_t i = 0; i < this->voxels.size(); ++i)
    {
      this->voxels[i] += other.voxels[i];
      this->edges[i] += other.edges[i];
      this->steps[i] += other.steps[i];
      this->speckEdges[i] += other.speckEdges[i];
    }
  }

  /// From differences between neighbouring thresholds to the thresholds' own sums.
  void accumulate()
  {
    for (auto* sums : { &this->edges, &this->steps, &this->speckEdges })
    {
      std::int64_t sum = 0;
      for (std::int64_t& value : *sums)
      {
        value = sum += value;
      }
    }
  }

  std::vector<std::int64_t> voxels; ///< in each bin
  std::vector<std::int64_t> edges;  ///< that cross the threshold
  std::vector<std::int64_t> steps;  ///< of those edges, in bins, summed
  std::vector<std::int64_t>
    speckEdges; ///< of those edges, at voxels with at most one neighbour above the threshold
};

/// Adds slice z of the volume to profile. previous and next are empty beyond the volume.
void addSlice(std::span<const std::uint16_t> previous, std::span<const std::uint16_t> slice,
  std::span<const std::uint16_t> next, int width, int height, Profile& profile)
{
  const auto addEdge = [&profile](std::uint16_t a, std::uint16_t b)
  {
    if (a != b && b != noBin)
    {
      const auto [low, high] = std::minmax(a, b);
      profile.edges[low] += 1;
      profile.edges[high] -= 1;
      profile.steps[low] += high - low;
      profile.steps[high] -= high - low;
    }
  };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const std::uint16_t bin = slice[i];
      if (bin == noBin)
      {
        continue;
      }
      ++profile.voxels[bin];

      // The highest and second highest neighbour decide where this voxel is a speck.
      int highest = -1;
      int second = -1;
      int neighbours = 0;
      const auto look = [&](std::uint16_t other)
      {
        if (other == noBin)
        {
          return;
        }
        ++neighbours;
        if (other > highest)
        {
          second = highest;
          highest = other;
        }
        else if (other > second)
        {
          second = other;
        }
      };
      if (x + 1 < width)
      {
        addEdge(bin, slice[i + 1]);
        look(slice[i + 1]);
      }
      if (y + 1 < height)
      {
        addEdge(bin, slice[i + width]);
        look(slice[i + width]);
      }
      if (!next.empty())
      {
        addEdge(bin, next[i]);
        look(next[i]);
      }
      if (x > 0)
      {
        look(slice[i - 1]);
      }
      if (y > 0)
      {
        look(slice[i - width]);
      }
      if (!previous.empty())
      {
        look(previous[i]);
      }
      // Voxels at the border have fewer neighbours and would look like specks.
      if (neighbours == 6 && second < bin)
      {
        profile.speckEdges[std::max(second, 0)] += 5;
        profile.speckEdges[bin] -= 5;
      }
    }
  }
}

template <typename T>
Profile makeProfile(const Slices<T>& slices, const Binning& binning)
{
  const std::array<int, 3> dimensions = slices.dimensions;
  const std::size_t sliceSize = slices.sliceSize();
  tbb::combinable<Profile> partial([&binning] { return Profile(binning.count); });
  // Each slice with its neighbours.
  const int own = slices.atOnce - 2;
  for (int begin = 0; begin < dimensions[2]; begin += own)
  {
    const int end = std::min(begin + own, dimensions[2]);
    const int first = std::max(begin - 1, 0);
    const int last = std::min(end + 1, dimensions[2]);
    const std::span<const T> values = slices.get(first, last);
    const auto addSlab = [&](const tbb::blocked_range<int>& range)
    {
      Profile& profile = partial.local();
      const auto binned = [&](int z)
      {
        std::vector<std::uint16_t> slice;
        if (z >= first && z < last)
        {
          slice.resize(sliceSize);
          const auto source = values.subspan(sliceSize * (z - first), sliceSize);
          std::transform(source.begin(), source.end(), slice.begin(), [&](T v) { return binning.bin(v); });
        }
        return slice;
      };
      std::vector<std::uint16_t> previous = binned(range.begin() - 1);
      std::vector<std::uint16_t> slice = binned(range.begin());
      for (int z = range.begin(); z < range.end(); ++z)
      {
        std::vector<std::uint16_t> next = binned(z + 1);
        addSlice(previous, slice, next, dimensions[0], dimensions[1], profile);
        previous = std::move(slice);
        slice = std::move(next);
      }
    };
    tbb::task_arena(threadCount())
      .execute([&] { tbb::parallel_for(tbb::blocked_range<int>(begin, end, 16), addSlab); });
  }

  Profile total(binning.count);
  partial.combine_each([&total](const Profile& profile) { total.add(profile); });
  total.accumulate();
  return total;
}

/// The mean step along the edges that cross each threshold. Infinite for noise and the border of the field of
/// view, so that nothing beside them is a maximum; zero for thresholds that hardly any edge crosses.
std::vector<double> sharpness(const Profile& profile)
{
  const std::int64_t all = std::accumulate(profile.voxels.begin(), profile.voxels.end(), std::int64_t{ 0 });
  std::vector<double> result(profile.edges.size(), 0.0);
  std::int64_t inside = all;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    inside -= profile.voxels[i];
    if (profile.edges[i] < fewestEdges)
    {
      continue;
    }
    const auto edges = static_cast<double>(profile.edges[i]);
    const bool noise = static_cast<double>(profile.speckEdges[i]) > largestSpeckShare * edges;
    const bool border = static_cast<double>(inside) > largestInsideShare * static_cast<double>(all);
    result[i] = noise || border ? std::numeric_limits<double>::infinity()
                                : static_cast<double>(profile.steps[i]) / edges;
  }
  return result;
}

/// The middle of the lowest prominent maximum, as a position between bins.
std::optional<double> lowestMaximum(const std::vector<double>& values)
{
  constexpr double keep = 1.0 - prominence;
  double valley = 0.0;
  std::size_t first = 0;
  std::size_t last = 0;
  double peak = 0.0;
  for (std::size_t i = 0; i <= values.size(); ++i)
  {
    const double value = i < values.size() ? values[i] : 0.0;
    if (value < keep * peak)
    {
      if (std::isfinite(peak) && valley < keep * peak)
      {
        return (static_cast<double>(first) + static_cast<double>(last)) / 2;
      }
      valley = peak = value;
      first = last = i;
    }
    else if (value > peak)
    {
      peak = value;
      first = last = i;
    }
    else if (value == peak && last + 1 == i)
    {
      last = i;
    }
    valley = std::min(valley, value);
  }
  return std::nullopt;
}

double otsuThreshold(const std::vector<std::int64_t>& histogram)
{
  double count = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < histogram.size(); ++i)
  {
    count += static_cast<double>(histogram[i]);
    sum += static_cast<double>(histogram[i]) * static_cast<double>(i);
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double best = -1.0;
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i + 1 < histogram.size(); ++i)
  {
    below += static_cast<double>(histogram[i]);
    sumBelow += static_cast<double>(histogram[i]) * static_cast<double>(i);
    if (below == 0.0 || below == count)
    {
      continue;
    }
    const double difference = sumBelow / below - (sum - sumBelow) / (count - below);
    const double variance = below * (count - below) * difference * difference;
    if (variance > best)
    {
      best = variance;
      first = last = i;
    }
    else if (variance == best)
    {
      last = i;
    }
  }
  return (static_cast<double>(first) + static_cast<double>(last)) / 2;
}

} // namespace

template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce)
{
  if (slicesAtOnce < 3)
  {
    throw std::invalid_argument(
      "suggestIsoValue: " + std::to_string(slicesAtOnce) + " slices at once, expected 3 or more");
  }
  const Slices<T> slices{ read, dimensions, slicesAtOnce };
  const std::optional<Binning> binning = chooseBinning(slices);
  if (!binning)
  {
    return std::nullopt;
  }

  const Profile profile = makeProfile(slices, *binning);
  const std::optional<double> maximum = lowestMaximum(sharpness(profile));
  const double threshold = maximum ? *maximum : otsuThreshold(profile.voxels);
  return IsoSuggestion{ binning->low + (threshold + 1.0) * binning->width,
    maximum ? IsoSuggestion::Method::Boundary : IsoSuggestion::Method::Otsu };
}

template <typename T>
std::optional<IsoSuggestion> suggestIsoValue(std::span<const T> values, std::array<int, 3> dimensions)
{
  for (int& dimension : dimensions)
  {
    dimension = std::max(dimension, 0);
  }
  const std::size_t sliceSize = static_cast<std::size_t>(dimensions[0]) * dimensions[1];
  if (values.size() != sliceSize * dimensions[2])
  {
    throw std::invalid_argument("suggestIsoValue: " + std::to_string(values.size()) + " values, but " +
      std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
      std::to_string(dimensions[2]) + " voxels");
  }
  const SliceReader<T> read = [&](int first, int last)
  { return values.subspan(sliceSize * first, sliceSize * (last - first)); };
  return suggestIsoValue(read, dimensions, std::max(dimensions[2], 1) + 2);
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::optional<IsoSuggestion> suggestIsoValue(std::span<const T>, std::array<int, 3>);             \
  template std::optional<IsoSuggestion> suggestIsoValue(const SliceReader<T>&, std::array<int, 3>, int)
INK_INSTANTIATE(char);
INK_INSTANTIATE(signed char);
INK_INSTANTIATE(unsigned char);
INK_INSTANTIATE(short);
INK_INSTANTIATE(unsigned short);
INK_INSTANTIATE(int);
INK_INSTANTIATE(unsigned int);
INK_INSTANTIATE(long);
INK_INSTANTIATE(unsigned long);
INK_INSTANTIATE(long long);
INK_INSTANTIATE(unsigned long long);
INK_INSTANTIATE(float);
INK_INSTANTIATE(double);
#undef INK_INSTANTIATE

} // namespace ink
