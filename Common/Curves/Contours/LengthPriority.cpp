// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/LengthPriority.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace ink
{

namespace
{

double chainLength(const Contours& contours, std::size_t chain)
{
  const std::size_t begin = contours.chains.offsets[chain];
  const std::size_t end = contours.chains.offsets[chain + 1];
  if (begin == end)
  {
    return 0.0;
  }
  const double closing = contours.chains.closed[chain]
    ? glm::distance(contours.positions[end - 1], contours.positions[begin])
    : 0.0;
  return contours.arcLength[end - 1] + closing;
}

} // namespace

std::vector<float> lengthPriorities(const Contours& contours)
{
  const std::size_t count = contours.chains.size();
  std::vector<double> lengths(count);
  for (std::size_t chain = 0; chain < count; ++chain)
  {
    lengths[chain] = chainLength(contours, chain);
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  // Rounding makes no chain one that is never drawn.
  const float most = std::nextafter(1.0f, 0.0f);
  std::vector<float> priorities(count, 0.0f);
  double before = 0.0;
  for (const std::size_t chain : order)
  {
    priorities[chain] = total > 0.0 ? std::min(static_cast<float>(before / total), most) : 0.0f;
    before += lengths[chain];
  }
  return priorities;
}

} // namespace ink
