// SPDX-License-Identifier: BSD-3-Clause
#include "Core/WeldedPoints.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ink
{

WeldedPoints::WeldedPoints(std::span<const glm::vec3> points)
  : of(points.size(), none)
{
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    if (std::isfinite(points[i].x) && std::isfinite(points[i].y) && std::isfinite(points[i].z))
    {
      order.push_back(i);
    }
  }
  std::sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b)
    {
      const glm::vec3& p = points[a];
      const glm::vec3& q = points[b];
      return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
    });
  // First maps each point to the first one at its position, then numbers the positions in the order of these.
  std::uint32_t leader = none;
  for (const std::uint32_t i : order)
  {
    leader = leader != none && points[i] == points[leader] ? leader : i;
    this->of[i] = leader;
  }
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    if (this->of[i] == i)
    {
      this->of[i] = static_cast<std::uint32_t>(this->positions.size());
      this->positions.push_back(points[i]);
      this->first.push_back(i);
    }
    else if (this->of[i] != none)
    {
      this->of[i] = this->of[this->of[i]];
    }
  }
}

} // namespace ink
