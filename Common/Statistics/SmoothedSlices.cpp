// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/SmoothedSlices.h"

#include "Core/ParallelFor.h"
#include "Fields/ScalarDifference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace ink
{
namespace
{

/// A weighted sum with the sum of its weights.
struct Sum
{
  double values = 0.0;
  double weights = 0.0;

  void add(const Sum& other, double weight)
  {
    this->values += weight * other.values;
    this->weights += weight * other.weights;
  }
};

Sum binomial(const Sum* before, const Sum& middle, const Sum* after)
{
  Sum sum;
  sum.add(middle, 0.5);
  for (const Sum* neighbor : { before, after })
  {
    if (neighbor)
    {
      sum.add(*neighbor, 0.25);
    }
  }
  return sum;
}

/// Smooths lines of `count` sums that are `step` apart.
void smoothLine(Sum* line, std::size_t count, std::size_t step)
{
  Sum before;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Sum middle = line[i * step];
    line[i * step] =
      binomial(i > 0 ? &before : nullptr, middle, i + 1 < count ? &line[(i + 1) * step] : nullptr);
    before = middle;
  }
}

} // namespace

template <typename T>
SliceReader<double> smoothedSlices(
  const SliceReader<T>& read, std::array<int, 3> dimensions, int slicesAtOnce)
{
  auto flat = std::make_shared<std::vector<Sum>>(); // along x and y
  auto smooth = std::make_shared<std::vector<double>>();
  return [=, &read](int first, int last)
  {
    const auto width = static_cast<std::size_t>(dimensions[0]);
    const auto height = static_cast<std::size_t>(dimensions[1]);
    const int depth = dimensions[2];
    const std::size_t slice = width * height;
    const int begin = std::max(first - 1, 0);
    const int end = std::min(last + 1, depth);
    flat->assign(slice * static_cast<std::size_t>(end - begin), {});
    for (int from = begin; from < end; from += slicesAtOnce)
    {
      const int to = std::min(from + slicesAtOnce, end);
      const std::span<const T> values = read(from, to);
      if (values.size() != slice * static_cast<std::size_t>(to - from))
      {
        throw std::invalid_argument("smoothedSlices: " + std::to_string(values.size()) +
          " values, but expected " + std::to_string(slice * static_cast<std::size_t>(to - from)));
      }
      parallelFor(static_cast<std::size_t>(to - from),
        [&](std::size_t z)
        {
          Sum* const sums = flat->data() + slice * (static_cast<std::size_t>(from - begin) + z);
          for (std::size_t i = 0; i < slice; ++i)
          {
            const double value = static_cast<double>(values[z * slice + i]);
            if (std::isfinite(value))
            {
              sums[i] = { value, 1.0 };
            }
          }
          for (std::size_t y = 0; y < height; ++y)
          {
            smoothLine(sums + y * width, width, 1);
          }
          for (std::size_t x = 0; x < width; ++x)
          {
            smoothLine(sums + x, height, width);
          }
        });
    }
    smooth->resize(slice * static_cast<std::size_t>(last - first));
    parallelFor(static_cast<std::size_t>(last - first),
      [&](std::size_t z)
      {
        const Sum* const middle = flat->data() + slice * (static_cast<std::size_t>(first - begin) + z);
        const bool hasBefore = first + static_cast<int>(z) > 0;
        const bool hasAfter = first + static_cast<int>(z) + 1 < depth;
        for (std::size_t i = 0; i < slice; ++i)
        {
          const Sum sum = binomial(
            hasBefore ? middle + i - slice : nullptr, middle[i], hasAfter ? middle + i + slice : nullptr);
          (*smooth)[z * slice + i] =
            sum.weights > 0.0 ? sum.values / sum.weights : std::numeric_limits<double>::quiet_NaN();
        }
      });
    return std::span<const double>(*smooth);
  };
}

#define INK_INSTANTIATE(T)                                                                                   \
  template SliceReader<double> smoothedSlices(const SliceReader<T>&, std::array<int, 3>, int);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
