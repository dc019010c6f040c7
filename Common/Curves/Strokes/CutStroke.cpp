// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Strokes/CutStroke.h"

#include "Core/Hash.h"

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

/// How far cuts lie from even ones, as a share of the strokes' length.
constexpr double jitter = 0.4;

} // namespace

std::vector<std::size_t> cutStroke(std::span<const double> arcLengths, double length, std::uint64_t key)
{
  if (arcLengths.empty())
  {
    return {};
  }
  std::vector<std::size_t> cuts{ 0 };
  const std::size_t last = arcLengths.size() - 1;
  const double begin = arcLengths.front();
  const double whole = arcLengths.back() - begin;
  // No more than there are segments.
  const double wanted = length > 0.0 ? std::min(std::ceil(whole / length), static_cast<double>(last)) : 1.0;
  const auto count = static_cast<std::uint64_t>(std::max(wanted, 1.0));
  for (std::uint64_t i = 1; i < count; ++i)
  {
    const double at = static_cast<double>(i) + jitter * (2.0 * unitDouble(hash(key, i)) - 1.0);
    const auto found =
      std::lower_bound(arcLengths.begin(), arcLengths.end(), begin + at * whole / static_cast<double>(count));
    const auto point = static_cast<std::size_t>(found - arcLengths.begin());
    if (point > cuts.back() && point < last)
    {
      cuts.push_back(point);
    }
  }
  if (last > 0)
  {
    cuts.push_back(last);
  }
  return cuts;
}

} // namespace ink
