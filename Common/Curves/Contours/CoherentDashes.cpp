// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/CoherentDashes.h"

#include "Core/KdTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

namespace ink
{

void CoherentDashes::align(Contours& contours, double period, double reach)
{
  std::optional<KdTree> before;
  if (!this->Positions.empty())
  {
    before.emplace(this->Positions);
  }
  const glm::dvec3 origin = before || contours.positions.empty() ? this->Origin : contours.positions.front();
  std::vector<glm::vec3> positions;
  std::vector<float> phases;
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    if (contours.kinds[chain] != ContourKind::Silhouette)
    {
      continue; // it does not move
    }
    const std::size_t begin = contours.chains.offsets[chain];
    const std::size_t end = contours.chains.offsets[chain + 1];
    const bool closed = contours.chains.closed[chain] != 0;
    const std::size_t segments = contours.chains.segmentCount(chain);
    const double whole = contours.arcLength[end - 1] - contours.arcLength[begin] +
      (closed ? glm::distance(contours.positions[end - 1], contours.positions[begin]) : 0.0);
    const double fitted = closed && whole > 0.0 ? whole / std::max(std::round(whole / period), 1.0) : period;
    const std::size_t first = positions.size();
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < segments; ++i)
    {
      const glm::dvec3& from = contours.positions[begin + i];
      const glm::dvec3& to = contours.positions[begin + i + 1 < end ? begin + i + 1 : begin];
      const double length = glm::distance(from, to);
      const double phase = (contours.arcLength[begin + i] + 0.5 * length) / fitted;
      positions.emplace_back(0.5 * (from + to) - origin);
      phases.push_back(static_cast<float>(phase - std::floor(phase)));
      if (before)
      {
        std::uint32_t nearest;
        before->find(positions.back(), { &nearest, 1 });
        if (glm::distance(this->Positions[nearest], positions.back()) <= reach)
        {
          sum += std::polar(length, 2.0 * std::numbers::pi * (this->Phases[nearest] - phases.back()));
        }
      }
    }
    if (sum == 0.0)
    {
      continue;
    }
    const double shift = std::arg(sum) / (2.0 * std::numbers::pi);
    for (std::size_t i = begin; i < end; ++i)
    {
      contours.arcLength[i] += shift * fitted;
    }
    for (std::size_t i = first; i < phases.size(); ++i)
    {
      phases[i] += static_cast<float>(shift);
    }
  }
  this->Origin = origin;
  this->Positions = std::move(positions);
  this->Phases = std::move(phases);
}

} // namespace ink
