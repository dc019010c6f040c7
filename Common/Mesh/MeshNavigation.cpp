// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshNavigation.h"

#include "Core/ParallelChunks.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/GeodesicUnfolding.h"
#include "Mesh/ScaledPoints.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace ink
{

namespace
{

/// A triangle that is flatter than this, relative to its longest side, has no area: rounding alone would say
/// where its third corner is.
constexpr double leastHeight = 1e-10;

bool hasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const double longest = std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
  // Scaled, so that squares neither overflow nor vanish. False for NaN.
  const double doubleArea = glm::length(glm::cross((b - a) / longest, (c - a) / longest));
  return longest > 0.0 && std::isfinite(longest) && doubleArea > leastHeight;
}

} // namespace

TriangleChart::TriangleChart(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  : origin(a)
{
  const glm::dvec3 second = b - a;
  const glm::dvec3 third = c - a;
  this->length = glm::length(second);
  this->axisX = second / this->length;
  this->x2 = glm::dot(third, this->axisX);
  const glm::dvec3 up = third - this->x2 * this->axisX;
  this->y2 = glm::length(up);
  this->axisY = up / this->y2;
}

glm::dvec3 TriangleChart::normal() const
{
  return glm::cross(this->axisX, this->axisY);
}

double TriangleChart::perimeter() const
{
  const glm::dvec2 third = this->corner(2);
  return this->length + glm::length(third) + glm::distance(third, this->corner(1));
}

MeshNavigation::MeshNavigation(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Links(3 * mesh.triangles.size(), border)
  , Usable(mesh.triangles.size())
{
}

MeshNavigation::MeshNavigation(const TriangleMesh& mesh, double featureAngle)
  : MeshNavigation(mesh)
{
  const std::size_t count = mesh.triangles.size();
  for (const Triangle& triangle : mesh.triangles)
  {
    const std::uint32_t largest = std::max({ triangle[0], triangle[1], triangle[2] });
    if (largest >= mesh.points.size())
    {
      throw std::invalid_argument("a triangle has the point " + std::to_string(largest) + "; expected 0 to " +
        std::to_string(static_cast<std::ptrdiff_t>(mesh.points.size()) - 1));
    }
  }
  for (std::size_t t = 0; t < count; ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    this->Usable[t] = hasArea(mesh.points[a], mesh.points[b], mesh.points[c]);
  }
  if (!this->measure())
  {
    return;
  }
  // Points that coincide are one, so that seams are closed and slivers along them are edges.
  std::vector<std::uint32_t> used;
  std::vector<std::uint8_t> isUsed(mesh.points.size());
  for (std::uint32_t t = 0; t < count; ++t)
  {
    for (const std::uint32_t point : mesh.triangles[t])
    {
      if (this->isUsable(t) && isUsed[point] == 0)
      {
        isUsed[point] = 1;
        used.push_back(point);
      }
    }
  }
  const double distance = coincidenceDistance(this->Lower, this->Upper);
  const std::vector<std::uint32_t> firsts = coincidentPoints(mesh.points, used, distance);
  const std::vector<glm::vec3> scaled = scalePoints(mesh, cumulateArea(mesh), distance).points;
  std::vector<glm::vec3> welded = scaled;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    welded[used[i]] = scaled[firsts[i]];
  }
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t t = 0; t < count; ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    if (this->isUsable(t) && welded[a] != welded[b] && welded[b] != welded[c] && welded[c] != welded[a])
    {
      triangles.push_back(mesh.triangles[t]);
      ids.push_back(t);
    }
    else
    {
      this->Usable[t] = 0;
    }
  }
  // Only its rings of triangles around edges are used: who is whose neighbor.
  const GeodesicUnfolding rings(welded, triangles);
  parallelForEach(ids.size(),
    [&](std::size_t n)
    {
      for (std::uint32_t edge = 0; edge < 3; ++edge)
      {
        const std::uint32_t link = rings.facets()[n].across[edge];
        if (link == border || rings.facets()[link / 3].across[link % 3] != 3 * n + edge)
        {
          continue;
        }
        const std::uint32_t t = ids[n];
        const std::uint32_t other = ids[link / 3];
        const auto corner = [&](std::uint32_t triangle, std::uint32_t c)
        { return mesh.points[mesh.triangles[triangle][c % 3]]; };
        const bool opposed = glm::distance(corner(t, edge), corner(other, link % 3 + 1)) <=
          glm::distance(corner(t, edge), corner(other, link % 3));
        this->Links[3 * std::size_t(t) + edge] = 6 * other + 2 * (link % 3) + (opposed ? 1 : 0);
      }
    });
  this->cutFeatures(featureAngle, 0.0);
}

bool MeshNavigation::measure()
{
  this->Area = cumulateArea(this->Mesh).area.back();
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (std::uint32_t t = 0; t < this->Usable.size(); ++t)
  {
    for (const std::uint32_t point : this->Mesh.triangles[t])
    {
      if (this->isUsable(t))
      {
        low = glm::min(low, this->Mesh.points[point]);
        high = glm::max(high, this->Mesh.points[point]);
      }
    }
  }
  if (!(low.x <= high.x))
  {
    return false;
  }
  this->Lower = low;
  this->Upper = high;
  return true;
}

MeshNavigation MeshNavigation::part(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) const
{
  MeshNavigation result(mesh);
  std::vector<std::uint32_t> numbers(this->Usable.size(), border);
  for (std::uint32_t n = 0; n < triangles.size(); ++n)
  {
    numbers[triangles[n]] = n;
  }
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    result.Usable[n] = this->Usable[triangles[n]];
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const std::uint32_t link = this->Links[3 * std::size_t(triangles[n]) + edge];
      if (link != border && numbers[link / 6] != border)
      {
        result.Links[3 * n + edge] = 6 * numbers[link / 6] + link % 6;
      }
    }
  }
  result.measure();
  return result;
}

void MeshNavigation::cutFeatures(double angle, double reach)
{
  if (angle >= 180.0)
  {
    return;
  }
  const double leastCosine = std::cos(angle * std::numbers::pi / 180.0);
  // Walks need all links, so none is cut before all edges are known.
  std::vector<std::uint8_t> features(this->Links.size());
  // Walks are long where many edges are steep.
  constexpr std::size_t trianglesPerChunk = 1 << 10;
  parallelForEach(
    this->Usable.size(),
    [&](std::size_t n)
    {
      const auto t = static_cast<std::uint32_t>(n);
      for (std::uint32_t edge = 0; edge < 3; ++edge)
      {
        const std::optional<Neighbor> other = this->across(t, edge);
        if (!other || other->triangle < t)
        {
          continue;
        }
        const double likeness = (other->opposed ? 1.0 : -1.0) *
          glm::dot(this->chart(t).normal(), this->chart(other->triangle).normal());
        if (likeness < leastCosine && !(reach > 0.0 && this->isStraight(t, edge, *other, reach, leastCosine)))
        {
          features[3 * n + edge] = 1;
          features[3 * std::size_t(other->triangle) + other->edge] = 1;
        }
      }
    },
    trianglesPerChunk);
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    this->Links[i] = features[i] != 0 ? border : this->Links[i];
  }
}

bool MeshNavigation::isStraight(
  std::uint32_t triangle, std::uint32_t edge, const Neighbor& other, double reach, double leastCosine) const
{
  // From the middle of the edge to where one gets at right angles to it.
  const auto side = [&](std::uint32_t t, std::uint32_t e) -> std::optional<glm::dvec3>
  {
    const TriangleChart own = this->chart(t);
    const glm::dvec2 along = glm::normalize(own.corner((e + 1) % 3) - own.corner(e));
    MeshPoint middle{ t, glm::dvec3(0.5) };
    middle.weights[static_cast<int>(e + 2) % 3] = 0.0;
    const std::optional<Arrival> end = this->walk(middle, -along.y * own.axisX + along.x * own.axisY, reach);
    if (!end)
    {
      return std::nullopt;
    }
    const glm::dvec3 edgeAlong = along.x * own.axisX + along.y * own.axisY;
    const glm::dvec3 offset = this->position(end->at) - this->position(middle);
    return offset - glm::dot(offset, edgeAlong) * edgeAlong;
  };
  const std::optional<glm::dvec3> here = side(triangle, edge);
  const std::optional<glm::dvec3> there = side(other.triangle, other.edge);
  return here && there && -glm::dot(*here, *there) >= leastCosine * glm::length(*here) * glm::length(*there);
}

glm::dvec3 MeshNavigation::position(const MeshPoint& point) const
{
  const auto& [a, b, c] = this->Mesh.triangles[point.triangle];
  const glm::dvec3& origin = this->Mesh.points[a];
  return origin + point.weights.y * (this->Mesh.points[b] - origin) +
    point.weights.z * (this->Mesh.points[c] - origin);
}

std::uint32_t MeshNavigation::nearestPoint(const MeshPoint& point) const
{
  const glm::dvec3& w = point.weights;
  const std::size_t corner = w.x >= w.y ? (w.x >= w.z ? 0 : 2) : (w.y >= w.z ? 1 : 2);
  return this->Mesh.triangles[point.triangle][corner];
}

bool MeshNavigation::cross(
  MeshPoint& point, TriangleChart& chart, std::uint32_t edge, glm::dvec2& vector) const
{
  const std::optional<Neighbor> next = this->across(point.triangle, edge);
  if (!next)
  {
    return false;
  }
  const std::uint32_t corners[2] = { next->corner(0), next->corner(1) };
  const std::uint32_t after = (edge + 1) % 3;
  const glm::dvec2 along = glm::normalize(chart.corner(after) - chart.corner(edge));
  const double onwards = glm::dot(vector, along);
  const double outwards = vector.x * along.y - vector.y * along.x;
  chart = this->chart(next->triangle);
  const glm::dvec2 there = glm::normalize(chart.corner(corners[1]) - chart.corner(corners[0]));
  const glm::dvec2 inwards = next->opposed ? glm::dvec2(there.y, -there.x) : glm::dvec2(-there.y, there.x);
  vector = onwards * there + outwards * inwards;

  const double first = std::max(point.weights[edge], 0.0);
  const double second = std::max(point.weights[after], 0.0);
  point.triangle = next->triangle;
  point.weights = glm::dvec3(0.0);
  point.weights[corners[0]] = first / (first + second);
  point.weights[corners[1]] = second / (first + second);
  return true;
}

std::optional<MeshNavigation::Arrival> MeshNavigation::walk(
  MeshPoint from, const glm::dvec3& direction, double distance) const
{
  if (!this->isUsable(from.triangle))
  {
    return std::nullopt;
  }
  TriangleChart chart = this->chart(from.triangle);
  glm::dvec2 heading(glm::dot(direction, chart.axisX), glm::dot(direction, chart.axisY));
  const double size = glm::length(heading);
  if (!(size > 0.0))
  {
    return std::nullopt;
  }
  heading /= size;
  // A straight line meets an edge of a triangle once; more crossings than this only fit around a vertex.
  constexpr int mostCrossings = 100000;
  for (int n = 0; n < mostCrossings; ++n)
  {
    const glm::dvec3 rates = chart.rates(heading.x, heading.y);
    double step = distance;
    int exit = -1;
    for (int corner = 0; corner < 3; ++corner)
    {
      if (rates[corner] < 0.0 && from.weights[corner] < -rates[corner] * step)
      {
        step = std::max(from.weights[corner], 0.0) / -rates[corner];
        exit = corner;
      }
    }
    from.weights += step * rates;
    distance -= step;
    if (exit < 0)
    {
      from.weights = glm::max(from.weights, 0.0);
      return Arrival{ from, heading.x * chart.axisX + heading.y * chart.axisY };
    }
    from.weights[exit] = 0.0;
    // Next to a vertex rather than on it, so that there is one way to go on.
    for (int corner = 1; corner < 3; ++corner)
    {
      double& weight = from.weights[(exit + corner) % 3];
      weight = std::clamp(weight, 1e-9, 1.0 - 1e-9);
    }
    if (!this->cross(from, chart, static_cast<std::uint32_t>(exit + 1) % 3, heading))
    {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

} // namespace ink
