// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/ContourPoints.h"

#include <glm/geometric.hpp>

#include <cstddef>
#include <utility>

namespace ink
{

void joinCoincidentPoints(Contours& contours)
{
  Contours joined;
  joined.positions.reserve(contours.positions.size());
  joined.elements.reserve(contours.elements.size());
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    const std::size_t begin = contours.chains.offsets[chain];
    const std::size_t end = contours.chains.offsets[chain + 1];
    const bool closed = contours.chains.closed[chain] != 0;
    const std::size_t first = joined.positions.size();
    for (std::size_t n = begin; n < end; ++n)
    {
      // The last of those that coincide, whose segment leads on.
      const std::size_t next = n + 1 < end ? n + 1 : begin;
      if ((n + 1 == end && !closed) || contours.positions[n] != contours.positions[next])
      {
        joined.positions.push_back(contours.positions[n]);
        joined.elements.push_back(contours.elements[n]);
      }
    }
    if (joined.positions.size() < first + 2)
    {
      joined.positions.resize(first);
      joined.elements.resize(first);
      continue;
    }
    if (!closed)
    {
      joined.elements.back() = joined.elements[joined.elements.size() - 2];
    }
    joined.chains.offsets.push_back(joined.positions.size());
    joined.chains.closed.push_back(closed);
    joined.kinds.push_back(contours.kinds[chain]);
  }
  contours = std::move(joined);
}

void measureArcLength(Contours& contours)
{
  contours.arcLength.assign(contours.positions.size(), 0.0);
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    for (std::size_t n = contours.chains.offsets[chain] + 1; n < contours.chains.offsets[chain + 1]; ++n)
    {
      contours.arcLength[n] =
        contours.arcLength[n - 1] + glm::distance(contours.positions[n - 1], contours.positions[n]);
    }
  }
}

} // namespace ink
