// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/FiniteRange.h"

#include "Core/ParallelChunks.h"
#include "Fields/ScalarDifference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace ink
{
namespace
{

constexpr std::size_t valuesPerChunk = std::size_t{ 1 } << 20;

template <typename T>
FiniteRange summarize(std::span<const T> values)
{
  // The neutral elements of minimum and maximum.
  T least = std::numeric_limits<T>::max();
  T greatest = std::numeric_limits<T>::lowest();
  std::uint64_t finite = values.size();
  if constexpr (std::is_floating_point_v<T>)
  {
    finite = 0;
    for (const T value : values)
    {
      // False for NaN, too.
      const bool isFinite = std::abs(value) <= std::numeric_limits<T>::max();
      finite += isFinite;
      least = isFinite && value < least ? value : least;
      greatest = isFinite && value > greatest ? value : greatest;
    }
  }
  else
  {
    for (const T value : values)
    {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  }
  FiniteRange summary;
  summary.notFinite = values.size() - finite;
  if (finite > 0)
  {
    summary.least = static_cast<double>(least);
    summary.greatest = static_cast<double>(greatest);
  }
  return summary;
}

} // namespace

void FiniteRange::add(const FiniteRange& other)
{
  this->least = std::min(this->least, other.least);
  this->greatest = std::max(this->greatest, other.greatest);
  this->notFinite += other.notFinite;
}

template <typename T>
FiniteRange findFiniteRange(std::span<const T> values)
{
  std::vector<FiniteRange> chunks(chunksOf(values.size(), valuesPerChunk));
  parallelForChunks(
    values.size(),
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    { chunks[chunk] = summarize(values.subspan(begin, end - begin)); },
    valuesPerChunk);
  FiniteRange all;
  for (const FiniteRange& chunk : chunks)
  {
    all.add(chunk);
  }
  return all;
}

#define INK_INSTANTIATE(T) template FiniteRange findFiniteRange(std::span<const T>);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
