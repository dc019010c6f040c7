// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/MaterialValues.h"

#include <algorithm>
#include <numeric>

namespace ink
{
namespace
{

constexpr std::size_t fewestBins = 8;
/// A peak has this many times the voxels that there are beside the boundary.
constexpr double clearance = 1.5;

} // namespace

std::optional<double> findMaterialValue(
  std::span<const std::int64_t> histogram, const BinRange& range, bool boundaryAtEnd)
{
  if (range.end < range.begin + fewestBins)
  {
    return std::nullopt;
  }
  const auto bins = histogram.subspan(range.begin, range.end - range.begin);
  const std::size_t width = bins.size() / 8;
  std::int64_t sum = std::accumulate(bins.begin(), bins.begin() + width, std::int64_t(0));
  const std::int64_t lowest = sum;
  std::int64_t most = sum;
  std::size_t peak = 0;
  for (std::size_t first = 1; first + width <= bins.size(); ++first)
  {
    sum += bins[first + width - 1] - bins[first - 1];
    if (sum > most)
    {
      most = sum;
      peak = first;
    }
  }
  const std::int64_t beside = boundaryAtEnd ? sum : lowest;
  const std::size_t distance = boundaryAtEnd ? bins.size() - width - peak : peak;
  if (distance < width || static_cast<double>(most) < clearance * static_cast<double>(beside))
  {
    return std::nullopt;
  }
  double moment = 0.0;
  for (std::size_t i = peak; i < peak + width; ++i)
  {
    moment += static_cast<double>(bins[i]) * static_cast<double>(i);
  }
  return static_cast<double>(range.begin) + moment / static_cast<double>(most);
}

} // namespace ink
