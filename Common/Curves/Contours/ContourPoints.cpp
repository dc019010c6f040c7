// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/ContourPoints.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ink
{

namespace
{

/// Leaves the named values of an array, in ascending order, if it has any.
template <typename Value>
void keep(std::vector<Value>& values, const std::vector<std::size_t>& kept)
{
  if (values.empty())
  {
    return;
  }
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    values[i] = values[kept[i]];
  }
  values.resize(kept.size());
}

} // namespace

void joinCoincidentPoints(Contours& contours)
{
  std::vector<std::size_t> kept; // points
  kept.reserve(contours.positions.size());
  Polylines chains;
  std::vector<ContourKind> kinds;
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    const std::size_t begin = contours.chains.offsets[chain];
    const std::size_t end = contours.chains.offsets[chain + 1];
    const bool closed = contours.chains.closed[chain] != 0;
    const std::size_t first = kept.size();
    for (std::size_t n = begin; n < end; ++n)
    {
      // The last of those that coincide, whose segment leads on.
      const std::size_t next = n + 1 < end ? n + 1 : begin;
      if ((n + 1 == end && !closed) || contours.positions[n] != contours.positions[next])
      {
        kept.push_back(n);
      }
    }
    if (kept.size() < first + 2)
    {
      kept.resize(first);
      continue;
    }
    if (!closed && !contours.elements.empty())
    {
      contours.elements[kept.back()] = contours.elements[kept[kept.size() - 2]];
    }
    chains.offsets.push_back(kept.size());
    chains.closed.push_back(closed);
    kinds.push_back(contours.kinds[chain]);
  }
  contours.chains = std::move(chains);
  contours.kinds = std::move(kinds);
  keep(contours.positions, kept);
  keep(contours.normals, kept);
  keep(contours.radialCurvature, kept);
  keep(contours.elements, kept);
}

void measureArcLength(Contours& contours)
{
  contours.arcLength.assign(contours.positions.size(), 0.0);
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    for (std::size_t n = contours.chains.offsets[chain] + 1; n < contours.chains.offsets[chain + 1]; ++n)
    {
      const glm::dvec3 step = contours.positions[n] - contours.positions[n - 1];
      const double length = glm::length(step);
      // Squares overflow long before lengths do.
      contours.arcLength[n] =
        contours.arcLength[n - 1] + (std::isfinite(length) ? length : std::hypot(step.x, step.y, step.z));
    }
  }
}

} // namespace ink
