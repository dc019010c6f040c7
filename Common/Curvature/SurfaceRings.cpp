// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/SurfaceRings.h"

#include "Core/IsFinite.h"
#include "Core/ParallelChunks.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/RepeatedTriangles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace ink
{

namespace
{

constexpr std::size_t ringsPerChunk = 1 << 11;

bool hasTwice(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

} // namespace

SurfaceRings::SurfaceRings(const TriangleMesh& mesh, Seams seams)
{
  const auto isUsable = [&mesh](const Triangle& t)
  {
    return !hasTwice(t) && isFinite(mesh.points[t[0]]) && isFinite(mesh.points[t[1]]) &&
      isFinite(mesh.points[t[2]]);
  };
  const auto lastOf = [](const Triangle& t) { return std::max({ t[0], t[1], t[2] }); };
  std::atomic<bool> allUsable = true;
  parallelForChunks(mesh.triangles.size(),
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      const auto part = mesh.triangles.subspan(begin, end - begin);
      if (!std::all_of(part.begin(), part.end(),
            [&](const Triangle& t) { return lastOf(t) < mesh.points.size() && isUsable(t); }))
      {
        allUsable = false;
      }
    });
  this->Triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  if (!allUsable)
  {
    for (const Triangle& triangle : this->Triangles)
    {
      if (lastOf(triangle) >= mesh.points.size())
      {
        throw std::invalid_argument("a triangle names point " + std::to_string(lastOf(triangle)) +
          "; expected less than " + std::to_string(mesh.points.size()) + ", the number of points");
      }
    }
    std::erase_if(this->Triangles, [&](const Triangle& t) { return !isUsable(t); });
  }
  this->connect(mesh.points.size());
  if (seams == Seams::Joined && this->weldBorders(mesh.points))
  {
    this->connect(mesh.points.size());
  }
}

void SurfaceRings::connect(std::size_t pointCount)
{
  this->indexCorners(pointCount);
  this->fillRings();
  const auto branches = [](RingShape shape) { return shape == RingShape::NonManifold; };
  if (std::any_of(this->Shapes.begin(), this->Shapes.end(), branches))
  {
    if (const std::vector<std::uint32_t> repeats = repeatedTriangles(this->Triangles); !repeats.empty())
    {
      eraseIndices(this->Triangles, repeats);
      this->indexCorners(pointCount);
      this->fillRings();
    }
  }
}

void SurfaceRings::indexCorners(std::size_t pointCount)
{
  this->FirstCorner.assign(pointCount + 1, 0);
  for (const Triangle& triangle : this->Triangles)
  {
    for (const std::uint32_t site : triangle)
    {
      ++this->FirstCorner[site];
    }
  }
  std::exclusive_scan(
    this->FirstCorner.begin(), this->FirstCorner.end(), this->FirstCorner.begin(), std::size_t(0));
  this->Corners.resize(3 * this->Triangles.size());
  // Each offset runs to the next site's, which the last loop sets back.
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (const std::uint32_t site : this->Triangles[t])
    {
      this->Corners[this->FirstCorner[site]++] = static_cast<std::uint32_t>(t);
    }
  }
  std::shift_right(this->FirstCorner.begin(), this->FirstCorner.end(), 1);
  this->FirstCorner[0] = 0;
}

template <class Visit>
void SurfaceRings::visitLinks(std::size_t site, const Visit& visit) const
{
  for (std::size_t i = this->FirstCorner[site]; i < this->FirstCorner[site + 1]; ++i)
  {
    const Triangle& t = this->Triangles[this->Corners[i]];
    const int corner = t[0] == site ? 0 : t[1] == site ? 1 : 2;
    visit(LinkEdge{ t[corner == 2 ? 0 : corner + 1], t[corner == 0 ? 2 : corner - 1], this->Corners[i] });
  }
}

void SurfaceRings::fillRings()
{
  const std::size_t count = this->FirstCorner.size() - 1;
  this->Shapes.resize(count);
  this->FirstNeighbor.assign(count + 1, 0);
  std::vector<std::vector<std::uint32_t>> rings(chunksOf(count, ringsPerChunk));
  parallelForChunks(
    count,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      std::vector<LinkEdge> links;
      std::vector<std::uint32_t>& ring = rings[chunk];
      ring.reserve(6 * ringsPerChunk);
      for (std::size_t site = begin; site < end; ++site)
      {
        links.clear();
        this->visitLinks(site, [&links](const LinkEdge& link) { links.push_back(link); });
        const std::size_t before = ring.size();
        this->Shapes[site] = appendRing(links, ring);
        this->FirstNeighbor[site + 1] = ring.size() - before;
      }
    },
    ringsPerChunk);
  std::partial_sum(this->FirstNeighbor.begin(), this->FirstNeighbor.end(), this->FirstNeighbor.begin());
  this->Neighbors.resize(this->FirstNeighbor.back());
  parallelForChunks(
    count,
    [&](std::size_t chunk, std::size_t begin, std::size_t)
    {
      std::copy(rings[chunk].begin(), rings[chunk].end(),
        this->Neighbors.begin() + static_cast<std::ptrdiff_t>(this->FirstNeighbor[begin]));
    },
    ringsPerChunk);
}

bool SurfaceRings::weldBorders(std::span<const glm::dvec3> points)
{
  std::vector<std::uint32_t> open;
  for (std::uint32_t site = 0; site < this->size(); ++site)
  {
    if (this->Shapes[site] == RingShape::Open || this->Shapes[site] == RingShape::NonManifold)
    {
      open.push_back(site);
    }
  }
  if (open.empty())
  {
    return false;
  }
  glm::dvec3 lower(std::numeric_limits<double>::infinity());
  glm::dvec3 upper(-lower);
  for (const Triangle& triangle : this->Triangles)
  {
    for (const std::uint32_t corner : triangle)
    {
      lower = glm::min(lower, points[corner]);
      upper = glm::max(upper, points[corner]);
    }
  }
  const std::vector<std::uint32_t> firsts = coincidentPoints(points, open, coincidenceDistance(lower, upper));
  if (firsts == open)
  {
    return false;
  }
  this->Sites.resize(this->size());
  std::iota(this->Sites.begin(), this->Sites.end(), 0u);
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    this->Sites[open[i]] = firsts[i];
  }
  for (Triangle& triangle : this->Triangles)
  {
    for (std::uint32_t& corner : triangle)
    {
      corner = this->Sites[corner];
    }
  }
  std::erase_if(this->Triangles, hasTwice);
  return true;
}

glm::dvec3 SurfaceRings::areaVector(std::span<const glm::dvec3> points, std::size_t site) const
{
  glm::dvec3 sum(0.0);
  double size = 0.0;
  const glm::dvec3 origin = points[site];
  this->visitLinks(site,
    [&](const LinkEdge& link)
    {
      const glm::dvec3 area = glm::cross(points[link.from] - origin, points[link.to] - origin);
      sum += area;
      size += glm::dot(area, area);
    });
  // False for what is not finite.
  constexpr double rounding = 1e-24;
  return glm::dot(sum, sum) > rounding * size ? sum : glm::dvec3(0.0);
}

} // namespace ink
