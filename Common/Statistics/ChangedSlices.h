// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/IsoStatistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

/// Internal to Common/Statistics: readers of a volume's slices that change some of its voxels, or leave some
/// out.
namespace ink
{

/// A volume whose values that are so are another one.
template <typename T, class Suits>
SliceReader<T> replacedSlices(const SliceReader<T>& read, const Suits& isSo, T other)
{
  return [read, isSo, other, held = std::vector<T>()](int first, int last) mutable
  {
    const std::span<const T> values = read(first, last);
    held.assign(values.begin(), values.end());
    std::replace_if(held.begin(), held.end(), isSo, other);
    return std::span<const T>(held);
  };
}

/// A volume whose fill value is NaN, see ValueBins::fill.
template <typename T>
SliceReader<T> withoutFill(const SliceReader<T>& read, double fill)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    if (!std::isnan(fill))
    {
      return replacedSlices(
        read, [fill = static_cast<T>(fill)](T value) { return value == fill; },
        std::numeric_limits<T>::quiet_NaN());
    }
  }
  return read;
}

/// A volume none of whose values is below one.
template <typename T>
SliceReader<T> raisedSlices(const SliceReader<T>& read, double least)
{
  const T lowest = static_cast<T>(std::is_integral_v<T> ? std::ceil(least) : least);
  return replacedSlices(
    read, [lowest](T value) { return value < lowest; }, lowest);
}

/// Some voxels of a volume.
/// @param read must outlive the result
/// @param box the first and the last one along x, y and z
template <typename T>
SliceReader<T> croppedSlices(
  const SliceReader<T>& read, const std::array<int, 3>& dimensions, const std::array<int, 6>& box)
{
  return [&read, dimensions, box, held = std::vector<T>()](int first, int last) mutable
  {
    const std::span<const T> values = read(box[4] + first, box[4] + last);
    const auto width = static_cast<std::size_t>(dimensions[0]);
    const auto height = static_cast<std::size_t>(dimensions[1]);
    held.clear();
    for (std::size_t row = 0; row < values.size() / width; ++row)
    {
      const auto y = static_cast<int>(row % height);
      if (y >= box[2] && y <= box[3])
      {
        const auto kept = values.subspan(row * width + box[0], box[1] - box[0] + 1);
        held.insert(held.end(), kept.begin(), kept.end());
      }
    }
    return std::span<const T>(held);
  };
}

} // namespace ink
