// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/RepeatedSamples.h"

#include "Core/ParallelChunks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace ink
{
namespace
{

/// Of each sample along an axis whether the next one differs from it, anywhere in the grid.
using Changes = std::vector<char>;

constexpr std::size_t fewestBorders = 16;
constexpr double leastShown = 0.8; ///< of the borders between blocks
/// How far borders are from the grid's: half a sample, and what the fit is off.
constexpr double mostBeside = 0.75;
constexpr double leastDifferent = 0.25; ///< of the borders; of what is symmetric, half are

Changes noChanges(int samples)
{
  return Changes(static_cast<std::size_t>(std::max(samples - 1, 0)), 0);
}

bool isFull(const Changes& changes)
{
  return std::all_of(changes.begin(), changes.end(), [](char change) { return change != 0; });
}

template <class Sample>
std::array<Changes, 3> findChanges(const Sample* samples, const std::array<int, 3>& dimensions)
{
  // No structured binding, which Clang before 16 does not let lambdas capture.
  const int columns = dimensions[0];
  const int rows = dimensions[1];
  const int slices = dimensions[2];
  const auto row = [&](int y, int z)
  { return samples + (static_cast<std::size_t>(z) * rows + static_cast<std::size_t>(y)) * columns; };
  const std::size_t rowBytes = sizeof(Sample) * static_cast<std::size_t>(columns);
  const auto differ = [&](const Sample* one, const Sample* other)
  { return std::memcmp(one, other, rowBytes) != 0; };
  constexpr std::size_t slicesPerChunk = 8;
  const auto count = static_cast<std::size_t>(slices);
  std::vector<std::array<Changes, 2>> parts(
    chunksOf(count, slicesPerChunk), { noChanges(columns), noChanges(rows) });
  std::array all{ noChanges(columns), noChanges(rows), noChanges(slices) };
  parallelForChunks(
    count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      auto& [alongX, alongY] = parts[chunk];
      for (auto z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      {
        const bool fullX = isFull(alongX);
        for (int y = 0; y < rows; ++y)
        {
          const Sample* here = row(y, z);
          for (std::size_t x = 0; !fullX && x < alongX.size(); ++x)
          {
            alongX[x] |= static_cast<char>(here[x] != here[x + 1]);
          }
          if (y + 1 < rows && !alongY[static_cast<std::size_t>(y)])
          {
            alongY[static_cast<std::size_t>(y)] = static_cast<char>(differ(here, row(y + 1, z)));
          }
          if (z + 1 < slices && !all[2][static_cast<std::size_t>(z)])
          {
            all[2][static_cast<std::size_t>(z)] = static_cast<char>(differ(here, row(y, z + 1)));
          }
        }
      }
    },
    slicesPerChunk);
  for (const auto& part : parts)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      std::transform(part[axis].begin(), part[axis].end(), all[axis].begin(), all[axis].begin(),
        [](char one, char other) { return static_cast<char>(one | other); });
    }
  }
  return all;
}

/// The grid whose borders these are, without its count; of step 1 if it is none.
OriginalSamples fitBorders(const Changes& changes)
{
  std::vector<int> borders;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    if (changes[i])
    {
      borders.push_back(static_cast<int>(i));
    }
  }
  if (borders.size() < fewestBorders)
  {
    return {};
  }
  std::vector<int> apart(borders.size() - 1);
  std::transform(borders.begin() + 1, borders.end(), borders.begin(), apart.begin(), std::minus<>());
  const int least = *std::min_element(apart.begin(), apart.end());
  if (least < 2)
  {
    return {};
  }
  // Blocks of a grid are as long as the shortest, or one sample longer.
  double sum = 0.0;
  double blocks = 0.0;
  for (const int one : apart)
  {
    sum += one <= least + 1 ? one : 0;
    blocks += one <= least + 1 ? 1.0 : 0.0;
  }
  double step = sum / blocks;
  // Counted with a first guess, then fitted by least squares.
  std::vector<double> places(borders.size());
  double offset = 0.0;
  for (int refined = 0; refined < 2; ++refined)
  {
    for (std::size_t i = 0; i < apart.size(); ++i)
    {
      places[i + 1] = places[i] + std::round(apart[i] / step);
    }
    const auto count = static_cast<double>(borders.size());
    const double meanPlace = std::accumulate(places.begin(), places.end(), 0.0) / count;
    const double meanBorder = std::accumulate(borders.begin(), borders.end(), 0.0) / count;
    double both = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < borders.size(); ++i)
    {
      both += (places[i] - meanPlace) * (borders[i] - meanBorder);
      square += (places[i] - meanPlace) * (places[i] - meanPlace);
    }
    step = both / square;
    offset = meanBorder - step * meanPlace;
  }
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    if (std::abs(borders[i] - (offset + step * places[i])) > mostBeside)
    {
      return {};
    }
  }
  const bool shows = static_cast<double>(borders.size()) >= leastShown * (places.back() + 1.0);
  // A border is half a sample behind the one that it follows, the middle half a block behind the border.
  return shows ? OriginalSamples{ offset + 0.5 + 0.5 * step, step, 0 } : OriginalSamples();
}

/// Those whose middle is within the grid.
OriginalSamples within(OriginalSamples repeated, int samples)
{
  const double before = std::floor((repeated.first + 0.5) / repeated.step);
  repeated.first -= before * repeated.step;
  repeated.count = static_cast<int>(std::ceil((samples - 0.5 - repeated.first) / repeated.step));
  return repeated;
}

/// Whether the samples that were repeated along an axis change as those of nothing that is made of blocks.
template <class Sample>
bool differ(const Sample* samples, const std::array<int, 3>& dimensions,
  const std::array<OriginalSamples, 3>& found, std::size_t axis)
{
  std::array indices{ found[0].indices(dimensions[0]), found[1].indices(dimensions[1]),
    found[2].indices(dimensions[2]) };
  std::swap(indices[0], indices[axis]);
  std::array<std::size_t, 3> strides{ 1, static_cast<std::size_t>(dimensions[0]),
    static_cast<std::size_t>(dimensions[0]) * static_cast<std::size_t>(dimensions[1]) };
  std::swap(strides[0], strides[axis]);
  std::vector<std::size_t> changes;
  for (std::size_t i = 0; i + 1 < indices[0].size(); ++i)
  {
    const std::size_t here = strides[0] * static_cast<std::size_t>(indices[0][i]);
    const std::size_t next = strides[0] * static_cast<std::size_t>(indices[0][i + 1]);
    std::size_t count = 0;
    for (const int z : indices[2])
    {
      for (const int y : indices[1])
      {
        const std::size_t row =
          strides[1] * static_cast<std::size_t>(y) + strides[2] * static_cast<std::size_t>(z);
        count += samples[row + here] != samples[row + next] ? 1 : 0;
      }
    }
    if (count > 0)
    {
      changes.push_back(count);
    }
  }
  const auto borders = static_cast<double>(changes.size());
  std::sort(changes.begin(), changes.end());
  const auto different = std::unique(changes.begin(), changes.end()) - changes.begin();
  return static_cast<double>(different) >= leastDifferent * borders;
}

} // namespace

std::array<OriginalSamples, 3> findRepeatedSamples(
  const void* samples, std::size_t bytesPerSample, const std::array<int, 3>& dimensions)
{
  const auto find = [&](auto sample)
  {
    const auto* values = static_cast<const decltype(sample)*>(samples);
    const std::array changes = findChanges(values, dimensions);
    std::array<OriginalSamples, 3> found;
    std::size_t axes = 0;
    bool allDiffer = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      found[axis] = within(fitBorders(changes[axis]), dimensions[axis]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const bool isRepeated = found[axis].step > 1.0;
      axes += isRepeated ? 1 : 0;
      allDiffer = allDiffer && (!isRepeated || differ(values, dimensions, found, axis));
    }
    if (axes < 2 || !allDiffer)
    {
      std::transform(
        dimensions.begin(), dimensions.end(), found.begin(), [](int count) { return within({}, count); });
    }
    return found;
  };
  switch (bytesPerSample)
  {
    case 1:
      return find(std::uint8_t());
    case 2:
      return find(std::uint16_t());
    case 4:
      return find(std::uint32_t());
    case 8:
      return find(std::uint64_t());
    default:
      throw std::invalid_argument(
        "findRepeatedSamples: " + std::to_string(bytesPerSample) + " bytes a sample, expected 1, 2, 4 or 8");
  }
}

} // namespace ink
