// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/RingFit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace ink
{

RingFit::RingFit(std::span<const glm::dvec3> points, const SurfaceRings& rings,
  std::span<const glm::dvec3> normals, const CurvatureOptions& options)
  : Points(points)
  , Rings(rings)
  , Normals(normals)
  , Options(options)
{
}

int RingFit::fewestRingsAt(std::uint32_t site) const
{
  return this->Rings.shape(site) == RingShape::Closed ? fewestRings : fewestRingsAtBorders;
}

void RingFit::start(std::uint32_t site, Front& front) const
{
  const auto [axisU, axisV] = tangentAxes(this->Normals[site]);
  front.points.start({ this->Points[site], axisU, axisV, this->Normals[site] });
  front.points.add(this->Points[site]);
  for (const std::vector<std::uint32_t>* reached : { &front.sites, &front.away })
  {
    for (const std::uint32_t before : *reached)
    {
      front.isReached[before] = 0;
    }
  }
  front.sites.assign(1, site);
  front.away.clear();
  front.begin = 0;
  front.reach(site);
}

/// Adds the sites of the next rings that face to the start's side, as far as there is room.
void RingFit::addRings(int count, Front& front) const
{
  constexpr std::size_t mostNeighbors = 64;
  const glm::dvec3 up = front.points.frame.normal;
  for (; count > 0; --count)
  {
    const std::size_t end = front.sites.size();
    for (; front.begin < end; ++front.begin)
    {
      const std::span<const std::uint32_t> neighbors = this->Rings.ring(front.sites[front.begin]);
      // Of very many neighbors some all around: otherwise all of a large fan would be visited from each of
      // its points.
      const std::size_t step = 1 + neighbors.size() / mostNeighbors;
      for (std::size_t i = 0; i < neighbors.size(); i += step)
      {
        const std::uint32_t site = neighbors[i];
        if (!front.reach(site))
        {
          continue;
        }
        if (!(glm::dot(this->Normals[site], up) > 0.0))
        {
          front.away.push_back(site);
          continue;
        }
        front.sites.push_back(site);
        if (front.points.isFull())
        {
          return;
        }
        front.points.add(this->Points[site]);
      }
    }
  }
}

std::optional<JetFit> RingFit::fitFewest(std::uint32_t site, Front& front) const
{
  this->start(site, front);
  this->addRings(this->fewestRingsAt(site), front);
  return fitJet(front.points, front.points.count, this->Options.degree);
}

std::optional<JetFit> RingFit::fit(std::uint32_t site, Front& front) const
{
  // Of two residuals; that of few points is not known better.
  constexpr double muchLarger = 3.0;
  const auto fitPoints = [&front](int degree) { return fitJet(front.points, front.points.count, degree); };
  int degree = this->Options.degree;
  const int most = this->Options.rings;
  std::optional<JetFit> best;
  this->start(site, front);
  int collected = 0;
  for (int rings = this->Options.adaptive ? std::min(this->fewestRingsAt(site), most) : most;;)
  {
    this->addRings(rings - collected, front);
    collected = rings;
    const std::optional<JetFit> next = fitPoints(degree);
    if (next && best && next->residual > muchLarger * best->residual)
    {
      break;
    }
    best = next ? next : best;
    const double excess = best ? best->noiseExcess() : 0.0;
    if (rings == most || (best && excess <= 1.0))
    {
      break;
    }
    // Where noise dominates, fewer coefficients are known better, in half the time.
    degree = best && !this->Options.derivatives ? 2 : degree;
    // Reach and number of points divide noise by the third power of the rings. Some more, since residuals of
    // few points are not known well.
    constexpr double margin = 1.25;
    const double wanted = std::ceil(margin * rings * std::cbrt(excess));
    // Residuals without degrees of freedom say nothing.
    rings = std::isfinite(wanted) ? static_cast<int>(std::clamp<double>(wanted, rings + 1, most)) : rings + 1;
  }
  return best || this->Options.degree == 2 ? best : fitPoints(2);
}

std::optional<PrincipalCurvature> RingFit::fitPinned(std::uint32_t site, Front& front) const
{
  this->start(site, front);
  for (const std::uint32_t neighbor : this->Rings.ring(site))
  {
    if (!front.points.isFull())
    {
      front.points.add(this->Points[neighbor]);
    }
  }
  return fitPinnedQuadric(front.points);
}

} // namespace ink
