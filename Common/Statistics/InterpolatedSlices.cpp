// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/InterpolatedSlices.h"

#include "Core/OtherAxes.h"
#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Resampling/SliceDistances.h"
#include "Fields/ScalarDifference.h"
#include "Statistics/Periodogram.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace ink
{
namespace
{

constexpr int linesAcross = 96;
constexpr int tilesAcross = 4; ///< of a slice
constexpr int fewestSamples = 3;
constexpr int fewestOriginal = 8;
constexpr std::ptrdiff_t fewestBends = 24; ///< along a line
constexpr double fewestLines = 10.0;       ///< of a tile where it has the most
constexpr double fewLines = 0.05;          ///< of these, where a tile begins and ends
/// As wide as the longest step, nearly.
constexpr std::ptrdiff_t halfMean = 5;
constexpr double leastStep = 2.2;
constexpr double longestStep = 10.0;
constexpr double leastProminence = 12.0;
constexpr double clearProminence = 60.0;
constexpr double leastAmplitude = 0.17; ///< of bends, by what they are around
/// What stands further beside the grid than this share of a step is left out.
constexpr double mostOutside = 0.25;
constexpr double mostBend = 0.4;         ///< along an axis, by that along any other
constexpr double mostBendOfClear = 0.55; ///< where the peak is as clear

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
        const auto count = static_cast<std::size_t>(this->samples() - 2);
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
    const auto [u, v] = otherAxes(this->Axis);
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
      return this->Field.at(sample);
    };
    T before;
    T here = valueAt(0);
    T after = valueAt(1);
    for (std::size_t i = 0; i < tile.sums.size(); ++i)
    {
      before = std::exchange(here, std::exchange(after, valueAt(i + 2)));
      const double bend = std::abs(difference(before, here) + difference(after, here));
      const bool isMasked = static_cast<double>(before) == least || static_cast<double>(here) == least ||
        static_cast<double>(after) == least;
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

/// The bends of a tile as shares of what they are around.
void addSeries(const Bends::Tile& tile, Periodogram& periodogram)
{
  const double most = *std::max_element(tile.counts.begin(), tile.counts.end());
  const auto isEnough = [&](double count) { return count >= fewLines * most; };
  const auto first = std::find_if(tile.counts.begin(), tile.counts.end(), isEnough) - tile.counts.begin();
  const auto last =
    std::find_if(tile.counts.rbegin(), tile.counts.rend(), isEnough).base() - tile.counts.begin();
  if (most < fewestLines || last - first < fewestBends)
  {
    return;
  }
  std::vector<double> means;
  std::transform(tile.sums.begin() + first, tile.sums.begin() + last, tile.counts.begin() + first,
    std::back_inserter(means), [](double sum, double count) { return sum / std::max(count, 1.0); });
  std::vector<double> shares;
  for (auto mean = means.begin() + halfMean; mean + halfMean < means.end(); ++mean)
  {
    const double around =
      std::accumulate(mean - halfMean, mean + halfMean + 1, 0.0) / static_cast<double>(2 * halfMean + 1);
    shares.push_back(around > 0.0 ? *mean / around - 1.0 : 0.0);
  }
  periodogram.add(static_cast<std::size_t>(first + halfMean), std::move(shares));
}

Periodogram makePeriodogram(const Bends& bends)
{
  Periodogram periodogram;
  for (const Bends::Tile& tile : bends.tiles)
  {
    addSeries(tile, periodogram);
  }
  return periodogram;
}

bool repeats(const Periodogram::Peak& peak)
{
  return peak.prominence >= leastProminence && peak.amplitude >= leastAmplitude;
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
  glm::dvec3 spacing = field.geometry().spacing();
  if (std::min({ dimensions.x, dimensions.y, dimensions.z }) < fewestSamples || thickSlices(spacing))
  {
    return found;
  }
  const double least = Lines(field, 0).least();
  const std::array bends{ Lines(field, 0).measure(least), Lines(field, 1).measure(least),
    Lines(field, 2).measure(least) };
  const std::array means{ bends[0].mean(), bends[1].mean(), bends[2].mean() };
  const auto across = static_cast<std::size_t>(std::min_element(means.begin(), means.end()) - means.begin());
  const double within = std::min(means[(across + 1) % 3], means[(across + 2) % 3]);
  if (!(means[across] <= mostBendOfClear * within))
  {
    return found;
  }
  const Periodogram periodogram = makePeriodogram(bends[across]);
  const int samples = dimensions[static_cast<int>(across)];
  const Periodogram::Peak peak = periodogram.findPeak(1.0 / longestStep, 1.0 / leastStep, samples);
  const double most = peak.prominence < clearProminence ? mostBend : mostBendOfClear;
  const double step = 1.0 / peak.frequency;
  if (!repeats(peak) || means[across] > most * within || step < leastStep || step > longestStep)
  {
    return found;
  }
  // Lattices repeat along other axes, too.
  for (const std::size_t other : { (across + 1) % 3, (across + 2) % 3 })
  {
    if (repeats(makePeriodogram(bends[other])
                  .findPeak(1.0 / longestStep, 1.0 / leastStep, dimensions[static_cast<int>(other)])))
    {
      return found;
    }
  }
  spacing[static_cast<int>(across)] *= step;
  const std::optional<ThickSlices> slices = thickSlices(spacing);
  if (!slices || slices->axis != static_cast<int>(across))
  {
    return found;
  }
  // The first bend is that of the second sample.
  double first = std::fmod(periodogram.firstMaximum(peak.frequency) + 1.0, step);
  first -= first > (1.0 - mostOutside) * step ? step : 0.0;
  const int count = static_cast<int>(std::floor((samples - 1.0 - first) / step + mostOutside)) + 1;
  if (count >= fewestOriginal)
  {
    found[across] = { first, step, count };
  }
  return found;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::array<OriginalSamples, 3> findInterpolatedSlices(const GridField<T>&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
