// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/SurfaceStretch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

// A triangle whose height is less than this fraction of its longest side is degenerate.
constexpr double thin = 1e-9;

double longestSide(const glm::dvec3 (&corners)[3])
{
  return std::max({ glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
    glm::distance(corners[2], corners[0]) });
}

} // namespace

double largestStretch(const glm::dvec3 (&before)[3], const glm::dvec3 (&now)[3])
{
  const double side = longestSide(before);
  double stretch = longestSide(now) / side;
  const glm::dvec3 a = (before[1] - before[0]) / side;
  const glm::dvec3 b = (before[2] - before[0]) / side;
  const double aa = glm::dot(a, a);
  const double ab = glm::dot(a, b);
  const double bb = glm::dot(b, b);
  const double area = aa * bb - ab * ab;
  if (area > thin * thin)
  {
    // The eigenvalues of the first metric's inverse times the second metric are the singular values squared.
    const glm::dvec3 u = (now[1] - now[0]) / side;
    const glm::dvec3 v = (now[2] - now[0]) / side;
    const double uu = glm::dot(u, u);
    const double uv = glm::dot(u, v);
    const double vv = glm::dot(v, v);
    const double half = 0.5 * (bb * uu - 2.0 * ab * uv + aa * vv) / area;
    const double product = (uu * vv - uv * uv) / area;
    stretch = std::sqrt(half + std::sqrt(std::max(half * half - product, 0.0)));
  }
  return std::isfinite(stretch) ? stretch : 1.0;
}

std::vector<float> pointStretch(std::span<const glm::dvec3> before, std::span<const glm::dvec3> now,
  std::span<const Triangle> triangles, int rounds)
{
  std::vector<float> stretch(before.size(), 0.0f);
  for (const auto& [a, b, c] : triangles)
  {
    const auto own =
      static_cast<float>(largestStretch({ before[a], before[b], before[c] }, { now[a], now[b], now[c] }));
    for (const std::uint32_t point : { a, b, c })
    {
      stretch[point] = std::max(stretch[point], own);
    }
  }
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<float> wider = stretch;
    for (const auto& [a, b, c] : triangles)
    {
      const float most = std::max({ stretch[a], stretch[b], stretch[c] });
      for (const std::uint32_t point : { a, b, c })
      {
        wider[point] = std::max(wider[point], most);
      }
    }
    stretch = std::move(wider);
  }
  return stretch;
}

} // namespace ink
