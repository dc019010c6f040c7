// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ActiveCellBound.h"

#include "Core/ParallelFor.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/IsoThreshold.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace ink
{
namespace
{

/// Counts the cells of a row, between four rows of samples, that have both a lower and an upper edge end: a
/// sample below `over` (all samples, if no value reaches it) and one at or above `upper`. Written so that
/// compilers vectorize it.
template <class T>
std::size_t countRow(
  const T* const rows[4], int samples, const IsoThreshold<T>& over, T upper, std::uint8_t* flags)
{
  // Bit 0: any of the four samples at x is a lower end; bit 1: any is an upper one. NaN is a lower one.
  const T* const a = rows[0];
  const T* const b = rows[1];
  const T* const c = rows[2];
  const T* const d = rows[3];
  const int all = !over.reachable;
  const T lower = over.lowest;
  for (int x = 0; x < samples; ++x)
  {
    const int low = all | !(a[x] >= lower) | !(b[x] >= lower) | !(c[x] >= lower) | !(d[x] >= lower);
    const int high = (a[x] >= upper) | (b[x] >= upper) | (c[x] >= upper) | (d[x] >= upper);
    flags[x] = static_cast<std::uint8_t>(low | high << 1);
  }
  std::uint32_t count = 0;
  for (int x = 0; x + 1 < samples; ++x)
  {
    count += (flags[x] | flags[x + 1]) == 3;
  }
  return count;
}

} // namespace

template <class T>
std::vector<std::size_t> boundActiveCells(
  std::span<const T> values, const glm::ivec3& dimensions, double isoValue, CrossingRule rule)
{
  const std::size_t row = dimensions.x;
  const std::size_t slice = row * dimensions.y;
  if (values.size() != slice * dimensions.z)
  {
    throw std::invalid_argument("boundActiveCells: " + std::to_string(values.size()) + " values, expected " +
      std::to_string(slice * dimensions.z));
  }
  if (std::min({ dimensions.x, dimensions.y, dimensions.z }) < 2)
  {
    return {};
  }
  std::vector<std::size_t> counts(static_cast<std::size_t>(dimensions.z - 1));
  // By the strict rule a sample at the iso-value can be either end.
  const IsoThreshold<T> upper = IsoThreshold<T>::atLeast(isoValue);
  const IsoThreshold<T> over = rule == CrossingRule::HalfOpen ? upper : IsoThreshold<T>::above(isoValue);
  if (!upper.reachable)
  {
    return counts;
  }
  const auto countLayer = [&](std::size_t layer)
  {
    std::vector<std::uint8_t> flags(row);
    for (int y = 0; y + 1 < dimensions.y; ++y)
    {
      const T* first = values.data() + layer * slice + y * row;
      const T* const rows[4] = { first, first + row, first + slice, first + slice + row };
      counts[layer] += countRow(rows, dimensions.x, over, upper.lowest, flags.data());
    }
  };
  parallelFor(counts.size(), countLayer);
  return counts;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template std::vector<std::size_t> boundActiveCells(                                                        \
    std::span<const T>, const glm::ivec3&, double, CrossingRule);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
