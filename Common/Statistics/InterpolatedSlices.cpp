// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/InterpolatedSlices.h"

#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Resampling/SliceDistances.h"
#include "Fields/ScalarDifference.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ink
{
namespace
{

constexpr int linesAcross = 96;
constexpr int tilesAcross = 4;          ///< of a slice
constexpr std::size_t fewestBends = 24; ///< along a line
constexpr double fewestLines = 10.0;    ///< of a tile where it has the most
constexpr double fewLines = 0.05;       ///< of these, where a tile begins and ends
/// As wide as the longest step, nearly.
constexpr std::ptrdiff_t halfMean = 5;
constexpr double leastStep = 2.2;
constexpr double longestStep = 10.0;
constexpr double leastProminence = 12.0;
constexpr double leastProminenceOfMultiples = 6.0;
constexpr double mostBend = 0.4;

/// By how much values bend along an axis: the means of the magnitudes of second differences.
struct Bends
{
  /// For each tile of a slice, at each sample but the last and the first one; where there are none, 0.
  struct Tile
  {
    std::vector<double> sums;
    std::vector<double> counts;
  };
  std::vector<Tile> tiles;

  double mean() const
  {
    double sum = 0.0;
    double count = 0.0;
    for (const Tile& tile : this->tiles)
    {
      sum = std::accumulate(tile.sums.begin(), tile.sums.end(), sum);
      count = std::accumulate(tile.counts.begin(), tile.counts.end(), count);
    }
    return count > 0.0 ? sum / count : 0.0;
  }
};

/// Some lines of a grid along an axis, in tiles of the slices across it.
template <class T>
class Lines
{
public:
  Lines(const GridField<T>& field, int axis)
    : Field(field)
    , Axis(axis)
  {
  }

  /// @param least the value of what is masked, which does not count
  Bends measure(double least) const
  {
    Bends bends;
    bends.tiles.resize(static_cast<std::size_t>(tilesAcross) * tilesAcross);
    parallelFor(bends.tiles.size(),
      [&](std::size_t tile)
      {
        const auto count = static_cast<std::size_t>(std::max(this->samples() - 2, 0));
        Bends::Tile& own = bends.tiles[tile];
        own = { std::vector<double>(count), std::vector<double>(count) };
        this->forEachLine(tile, [&](glm::ivec3 sample) { this->add(sample, least, own); });
      });
    return bends;
  }

  double least() const
  {
    std::vector<double> leasts(
      static_cast<std::size_t>(tilesAcross) * tilesAcross, std::numeric_limits<double>::infinity());
    parallelFor(leasts.size(),
      [&](std::size_t tile)
      {
        this->forEachLine(tile,
          [&](glm::ivec3 sample)
          {
            for (sample[this->Axis] = 0; sample[this->Axis] < this->samples(); ++sample[this->Axis])
            {
              leasts[tile] = std::fmin(leasts[tile], static_cast<double>(this->Field.at(sample)));
            }
          });
      });
    return *std::min_element(leasts.begin(), leasts.end());
  }

private:
  int samples() const { return this->Field.geometry().dimensions()[this->Axis]; }

  template <class Visit>
  void forEachLine(std::size_t tile, const Visit& visit) const
  {
    const glm::ivec3& dimensions = this->Field.geometry().dimensions();
    const int u = this->Axis == 0 ? 1 : 0;
    const int v = this->Axis == 2 ? 1 : 2;
    const auto linesOf = [&](int axis) { return std::min(dimensions[axis], linesAcross); };
    // The one of so many that are as far apart as that goes.
    const auto lineOf = [&](int axis, int n) {
      return static_cast<int>(
        (static_cast<std::int64_t>(2 * n + 1) * dimensions[axis]) / (2 * linesOf(axis)));
    };
    const auto beginOf = [&](int axis, int part) { return part * linesOf(axis) / tilesAcross; };
    const int column = static_cast<int>(tile) % tilesAcross;
    const int row = static_cast<int>(tile) / tilesAcross;
    glm::ivec3 sample(0);
    for (int j = beginOf(v, row); j < beginOf(v, row + 1); ++j)
    {
      for (int i = beginOf(u, column); i < beginOf(u, column + 1); ++i)
      {
        sample[u] = lineOf(u, i);
        sample[v] = lineOf(v, j);
        visit(sample);
      }
    }
  }

  void add(glm::ivec3 sample, double least, Bends::Tile& tile) const
  {
    const auto valueAt = [&](std::size_t i)
    {
      sample[this->Axis] = static_cast<int>(i);
      return static_cast<double>(this->Field.at(sample));
    };
    double before = 0.0;
    double here = valueAt(0);
    double after = valueAt(1);
    for (std::size_t i = 0; i < tile.sums.size(); ++i)
    {
      before = std::exchange(here, std::exchange(after, valueAt(i + 2)));
      const double bend = std::abs((before - here) + (after - here));
      const bool isMasked = before == least || here == least || after == least;
      const bool isFlat = before == here && here == after;
      if (std::isfinite(bend) && !isMasked && !isFlat)
      {
        tile.sums[i] += bend;
        tile.counts[i] += 1.0;
      }
    }
  }

  const GridField<T>& Field;
  int Axis;
};

/// What repeats along an axis, of each tile: bends as shares of what they are around, faded in and out.
class Periodogram
{
public:
  explicit Periodogram(const Bends& bends)
  {
    for (const Bends::Tile& tile : bends.tiles)
    {
      this->add(tile);
    }
  }

  bool isEmpty() const { return this->All.empty(); }

  /// Averaged over the tiles.
  double power(double frequency) const
  {
    double sum = 0.0;
    for (const Series& series : this->All)
    {
      sum += std::norm(series.at(frequency)) / static_cast<double>(series.values.size());
    }
    return sum / static_cast<double>(this->All.size());
  }

  /// Where the first maximum of what repeats so often is, from 0.
  double firstMaximum(double frequency) const
  {
    std::complex<double> sum = 0.0;
    for (const Series& series : this->All)
    {
      sum += series.at(frequency);
    }
    const double turns = -std::arg(sum) / (2.0 * std::numbers::pi);
    return (turns < 0.0 ? turns + 1.0 : turns) / frequency;
  }

private:
  struct Series
  {
    std::size_t begin;
    std::vector<double> values;

    std::complex<double> at(double frequency) const
    {
      const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi * frequency);
      std::complex<double> phase =
        std::polar(1.0, -2.0 * std::numbers::pi * frequency * static_cast<double>(this->begin));
      std::complex<double> sum = 0.0;
      for (const double value : this->values)
      {
        sum += value * phase;
        phase *= turn;
      }
      return sum;
    }
  };

  void add(const Bends::Tile& tile)
  {
    const double most = tile.counts.empty() ? 0.0 : *std::max_element(tile.counts.begin(), tile.counts.end());
    if (most < fewestLines)
    {
      return;
    }
    const auto isEnough = [&](double count) { return count >= fewLines * most; };
    const auto first = std::find_if(tile.counts.begin(), tile.counts.end(), isEnough);
    const auto last = std::find_if(tile.counts.rbegin(), tile.counts.rend(), isEnough).base();
    std::vector<double> means;
    for (auto count = first; count != last; ++count)
    {
      means.push_back(
        tile.sums[static_cast<std::size_t>(count - tile.counts.begin())] / std::max(*count, 1.0));
    }
    if (means.size() < fewestBends)
    {
      return;
    }
    Series series{ static_cast<std::size_t>(first - tile.counts.begin() + halfMean), {} };
    for (auto mean = means.begin() + halfMean; mean + halfMean < means.end(); ++mean)
    {
      const double around =
        std::accumulate(mean - halfMean, mean + halfMean + 1, 0.0) / static_cast<double>(2 * halfMean + 1);
      series.values.push_back(around > 0.0 ? *mean / around - 1.0 : 0.0);
    }
    const auto count = static_cast<double>(series.values.size());
    const double mean = std::accumulate(series.values.begin(), series.values.end(), 0.0) / count;
    for (std::size_t i = 0; i < series.values.size(); ++i)
    {
      const double place = static_cast<double>(i) / (count - 1.0);
      series.values[i] = (series.values[i] - mean) * (0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * place));
    }
    this->All.push_back(std::move(series));
  }

  std::vector<Series> All;
};

/// A peak of a periodogram, and how many times as high it is as what is around it.
struct Peak
{
  double frequency;
  double prominence;
};

/// The powers of a periodogram of so many samples, at frequencies up to that of every second one.
class Powers
{
public:
  Powers(const Periodogram& periodogram, int samples)
    : Resolution(1.0 / samples)
  {
    const auto count = static_cast<std::size_t>(perSample * samples / 2);
    for (std::size_t k = 0; k <= count; ++k)
    {
      this->All.push_back(periodogram.power(this->frequencyOf(k)));
    }
  }

  /// The most prominent one of those between two frequencies.
  Peak highest(double low, double high) const
  {
    Peak best{ low, 0.0 };
    for (std::size_t k = this->indexOf(low); k <= this->indexOf(high); ++k)
    {
      const double prominence = this->prominence(k);
      best = prominence > best.prominence ? Peak{ this->frequencyOf(k), prominence } : best;
    }
    return best;
  }

private:
  static constexpr double perSample = 4.0;

  double frequencyOf(std::size_t k) const { return static_cast<double>(k) * this->Resolution / perSample; }
  std::size_t indexOf(double frequency) const
  {
    const double k = std::round(std::max(frequency, 0.0) * perSample / this->Resolution);
    return std::min(static_cast<std::size_t>(k), this->All.size() - 1);
  }

  double prominence(std::size_t k) const
  {
    const double frequency = this->frequencyOf(k);
    // Peaks of what is faded in and out are twice as wide as the resolution, to either side.
    const double inner = std::max(0.125 * frequency, 2.0 * this->Resolution);
    const double outer = std::max(0.25 * frequency, 4.0 * this->Resolution);
    std::vector<double> around;
    const auto add = [&](double from, double to)
    {
      for (std::size_t i = this->indexOf(from); i <= this->indexOf(to); ++i)
      {
        around.push_back(this->All[i]);
      }
    };
    add(std::max(frequency - outer, 0.75 / longestStep), std::max(frequency - inner, 0.75 / longestStep));
    if (frequency + inner < 0.5)
    {
      add(frequency + inner, frequency + outer);
    }
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::nth_element(around.begin(), middle, around.end());
    return *middle > 0.0 ? this->All[k] / *middle : 0.0;
  }

  double Resolution;
  std::vector<double> All;
};

/// How often something repeats along an axis of so many samples; no value if nothing does.
std::optional<double> findFrequency(const Periodogram& periodogram, int samples)
{
  if (periodogram.isEmpty())
  {
    return std::nullopt;
  }
  const Powers powers(periodogram, samples);
  Peak peak = powers.highest(1.0 / longestStep, 1.0 / leastStep);
  if (peak.prominence < leastProminence)
  {
    return std::nullopt;
  }
  // What repeats in jumps does so at multiples of its frequency, too.
  const double resolution = 1.0 / samples;
  for (const double divisor : { 4.0, 3.0, 2.0 })
  {
    const double frequency = peak.frequency / divisor;
    const Peak lower = powers.highest(frequency - resolution, frequency + resolution);
    if (frequency > 1.0 / longestStep && lower.prominence > leastProminenceOfMultiples)
    {
      peak = lower;
      break;
    }
  }
  double best = peak.frequency;
  constexpr int refined = 32;
  for (int i = -refined; i <= refined; ++i)
  {
    const double near = peak.frequency + 0.5 * resolution * i / refined;
    best = periodogram.power(near) > periodogram.power(best) ? near : best;
  }
  return best;
}

} // namespace

template <class T>
std::array<OriginalSamples, 3> findInterpolatedSlices(const GridField<T>& field)
{
  const glm::ivec3& dimensions = field.geometry().dimensions();
  std::array<OriginalSamples, 3> found;
  for (int axis = 0; axis < 3; ++axis)
  {
    found[static_cast<std::size_t>(axis)].count = dimensions[axis];
  }
  if (std::min({ dimensions.x, dimensions.y, dimensions.z }) < 3)
  {
    return found;
  }
  const double least = Lines(field, 0).least();
  const std::array bends{ Lines(field, 0).measure(least), Lines(field, 1).measure(least),
    Lines(field, 2).measure(least) };
  const std::array means{ bends[0].mean(), bends[1].mean(), bends[2].mean() };
  const auto across = static_cast<std::size_t>(std::min_element(means.begin(), means.end()) - means.begin());
  const double within = std::min(means[(across + 1) % 3], means[(across + 2) % 3]);
  if (!(means[across] <= mostBend * within))
  {
    return found;
  }
  const Periodogram periodogram(bends[across]);
  const int samples = dimensions[static_cast<int>(across)];
  const std::optional<double> frequency = findFrequency(periodogram, samples);
  if (!frequency)
  {
    return found;
  }
  const double step = 1.0 / *frequency;
  glm::dvec3 spacing = field.geometry().spacing();
  spacing[static_cast<int>(across)] *= step;
  const std::optional<ThickSlices> slices = thickSlices(spacing);
  if (!slices || slices->axis != static_cast<int>(across))
  {
    return found;
  }
  // The first bend is that of the second sample. Those beside the grid's first and last slice take these.
  double first = std::fmod(periodogram.firstMaximum(*frequency) + 1.0, step);
  first -= first > 0.5 * step ? step : 0.0;
  const int count = static_cast<int>(std::floor((samples - 1.0 - first) / step + 0.5)) + 1;
  found[across] = { first, step, count };
  return found;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::array<OriginalSamples, 3> findInterpolatedSlices(const GridField<T>&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
