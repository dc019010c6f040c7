// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PointCloud/PointRadii.h"

#include "Core/KdTree.h"
#include "Core/ParallelChunks.h"
#include "Core/UnitOrZero.h"
#include "Core/WeldedPoints.h"
#include "PointSampling/PointCloud/PcaNormal.h"
#include "PointSampling/PointCloud/VoronoiCell2D.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace ink
{

namespace
{

constexpr std::size_t radiiPerChunk = 1 << 10;
constexpr std::size_t mostNeighbors = VoronoiCell2D::mostNeighbors;
constexpr std::size_t smoothed = 12; // neighbors over which radii are smoothed
constexpr std::size_t spacingAt = 8; // the neighbor whose distance measures the local spacing
constexpr std::size_t onALine = 6;   // the neighbor whose distance is the radius for collinear points
// Ratios of the spacing to that of the densest neighbors from which a point is isolated: when it is off their
// plane, and in any case.
constexpr float isolatedAbove = 3.0f;
constexpr float isolatedAnyway = 8.0f;
constexpr std::size_t densest = 3;    // of the neighbors
constexpr float outOfPlane = 0.3f;    // of the distance to the neighbors
constexpr float isolatedCloud = 6.0f; // times the median distance of all points
constexpr float thickCloud = 0.25f;   // of the distance to the neighbors: their deviation from their plane
constexpr float holeFrom = 3.0f;      // times the median distance of cell corners
constexpr float ownMedianCounts = 4.0f;
constexpr float overlap = 1.25f;
constexpr float noNeighbor = std::numeric_limits<float>::infinity();

float median(std::span<float> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Distinct positions with their neighbors, and the results of each step. Each step writes only to its own
/// position's entries.
struct Neighborhoods
{
  const std::vector<glm::vec3>& positions;
  std::vector<glm::vec3> normals;
  bool oneSided; // whether normals distinguish the sides of a surface
  KdTree tree;
  std::size_t count;                // neighbors per position
  std::vector<std::uint32_t> found; // all neighbors, nearest first
  std::vector<float> spacing;
  std::vector<char> isolated;
  std::vector<float> middle;   // median distance of the cell's corners; infinite without corners
  std::vector<float> farthest; // of these corners
  std::vector<float> cover;
  std::vector<float> wide; // the largest covering radius nearby

  Neighborhoods(const std::vector<glm::vec3>& thePositions, std::vector<glm::vec3> theNormals)
    : positions(thePositions)
    , normals(std::move(theNormals))
    , oneSided(!this->normals.empty())
    , tree(positions)
    , count(std::min(mostNeighbors, positions.size() - 1))
    , found(count * positions.size())
    , spacing(positions.size())
    , isolated(positions.size())
    , middle(positions.size())
    , farthest(positions.size())
    , cover(positions.size())
    , wide(positions.size())
  {
    this->normals.resize(positions.size(), glm::vec3(0.0f));
  }

  std::span<std::uint32_t> near(std::size_t i) { return { &this->found[i * this->count], this->count }; }
  std::span<const std::uint32_t> near(std::size_t i) const
  {
    return { &this->found[i * this->count], this->count };
  }

  void findNeighbors(std::size_t i)
  {
    std::array<std::uint32_t, mostNeighbors + 1> nearest;
    const std::span<std::uint32_t> wanted(nearest.data(), this->count + 1);
    this->tree.find(this->positions[i], wanted);
    // The position itself is the nearest, except for others whose distance rounds to 0.
    const auto self = std::find(wanted.begin(), wanted.end() - 1, static_cast<std::uint32_t>(i));
    std::copy(self + 1, wanted.end(), std::copy(wanted.begin(), self, this->near(i).begin()));
    const std::uint32_t other = this->near(i)[std::min(spacingAt, this->count) - 1];
    this->spacing[i] = glm::distance(this->positions[i], this->positions[other]);
  }

  /// Isolated points are single points and small groups among others, and those of volumetric clouds.
  void findIsolated(std::size_t i, float usualSpacing)
  {
    const auto all = this->near(i);
    std::array<float, mostNeighbors> spacings;
    std::transform(
      all.begin(), all.end(), spacings.begin(), [&](std::uint32_t n) { return this->spacing[n]; });
    const std::size_t rank = std::min(densest, this->count) - 1;
    std::nth_element(spacings.begin(), spacings.begin() + rank, spacings.begin() + this->count);
    const float apart = this->spacing[i] / spacings[rank];
    const bool sparse = this->spacing[i] > isolatedCloud * usualSpacing;
    this->isolated[i] = apart > isolatedAnyway;
    if (!this->isolated[i] && (sparse || apart > isolatedAbove))
    {
      const glm::vec3 normal = pcaNormal(this->positions, all);
      glm::vec3 middleOfAll(0.0f);
      for (const std::uint32_t n : all)
      {
        middleOfAll += this->positions[n] / static_cast<float>(this->count);
      }
      float thickness = 0.0f;
      for (const std::uint32_t n : all)
      {
        const float height = glm::dot(this->positions[n] - middleOfAll, normal);
        thickness += height * height / static_cast<float>(this->count);
      }
      const float height = std::abs(glm::dot(this->positions[i] - middleOfAll, normal));
      this->isolated[i] = (apart > isolatedAbove && height > outOfPlane * this->spacing[i]) ||
        (sparse && std::sqrt(thickness) > thickCloud * this->spacing[i]);
    }
  }

  /// The neighborhood of isolated points is no surface, either.
  bool isAmongIsolated(std::size_t i) const
  {
    const auto all = this->near(i);
    const auto alone =
      std::count_if(all.begin(), all.end(), [&](std::uint32_t n) { return this->isolated[n] != 0; });
    return 2 * static_cast<std::size_t>(alone) > this->count;
  }

  /// Whether another position can be a neighbor on the same side of the same surface.
  bool belongs(std::size_t i, std::uint32_t other) const
  {
    return !this->isolated[other] &&
      (!this->oneSided || glm::dot(this->normals[i], this->normals[other]) >= 0.0f);
  }

  VoronoiCell2D cellOf(std::size_t i) const
  {
    const auto all = this->near(i);
    const glm::vec3 normal =
      this->normals[i] != glm::vec3(0.0f) ? this->normals[i] : pcaNormal(this->positions, all);
    const glm::vec3 aside = std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = glm::normalize(glm::cross(normal, aside));
    const glm::vec3 v = glm::cross(normal, u);
    VoronoiCell2D cell(glm::distance(this->positions[i], this->positions[all.back()]));
    float extent = cell.extent();
    for (const std::uint32_t other : all)
    {
      const glm::vec3 offset = this->positions[other] - this->positions[i];
      const float distance = glm::length(offset);
      if (distance >= 2.0f * extent)
      {
        break;
      }
      const glm::vec2 flat(glm::dot(offset, u), glm::dot(offset, v));
      const float length = glm::length(flat);
      if (length > 0.0f && this->belongs(i, other))
      {
        cell.cut(flat * (distance / length));
        extent = cell.extent();
      }
    }
    return cell;
  }

  void measureCell(std::size_t i)
  {
    std::array<float, VoronoiCell2D::mostCorners> corners;
    const auto those = std::span(corners).first(this->cellOf(i).corners(corners));
    this->farthest[i] = those.empty() ? noNeighbor : *std::max_element(those.begin(), those.end());
    this->middle[i] = those.empty() ? noNeighbor : median(those);
  }

  void coverCell(std::size_t i)
  {
    std::array<float, mostNeighbors + 1> middles;
    std::size_t measured = 0;
    const auto add = [&](std::size_t point)
    {
      if (std::isfinite(this->middle[point]))
      {
        middles[measured++] = this->middle[point];
      }
    };
    add(i);
    for (const std::uint32_t other : this->near(i))
    {
      if (this->belongs(i, other))
      {
        add(other);
      }
    }
    if (measured == 0)
    {
      const std::uint32_t other = this->near(i)[std::min(onALine, this->count) - 1];
      this->cover[i] = glm::distance(this->positions[i], this->positions[other]);
      return;
    }
    const float around = median(std::span(middles).first(measured));
    const float limit = holeFrom * std::max(std::min(this->middle[i], ownMedianCounts * around), around);
    this->cover[i] = this->farthest[i];
    if (!(this->farthest[i] <= limit))
    {
      std::array<float, VoronoiCell2D::mostCorners> corners;
      this->cover[i] = around;
      for (const float corner : std::span(corners).first(this->cellOf(i).corners(corners)))
      {
        this->cover[i] = corner <= limit ? std::max(this->cover[i], corner) : this->cover[i];
      }
    }
  }

  /// Calls body(other) for the position itself and for its nearest neighbors.
  template <class Body>
  void forNearest(std::size_t i, const Body& body) const
  {
    body(i);
    std::size_t left = smoothed;
    for (const std::uint32_t other : this->near(i))
    {
      if (left > 0 && this->belongs(i, other))
      {
        body(other);
        --left;
      }
    }
  }

  void widen(std::size_t i)
  {
    this->forNearest(
      i, [&](std::size_t other) { this->wide[i] = std::max(this->wide[i], this->cover[other]); });
  }

  float radiusOf(std::size_t i) const
  {
    float sum = 0.0f;
    float number = 0.0f;
    this->forNearest(i,
      [&](std::size_t other)
      {
        sum += this->wide[other];
        number += 1.0f;
      });
    return overlap * std::max(sum / number, this->cover[i]);
  }
};

/// The normals of the distinct positions of some points.
std::vector<glm::vec3> normalsOf(const WeldedPoints& distinct, std::span<const glm::vec3> normals)
{
  std::vector<glm::vec3> result;
  for (const std::uint32_t point : distinct.first)
  {
    if (!normals.empty())
    {
      result.push_back(unitOrZero(normals[point]));
    }
  }
  return result;
}

} // namespace

PointRadii pointRadii(
  std::span<const glm::vec3> points, std::span<const glm::vec3> normals, const Progress& progress)
{
  PointRadii result{ std::vector<float>(points.size()), std::vector<char>(points.size()) };
  WeldedPoints distinct(points);
  if (distinct.positions.size() < 2)
  {
    return result;
  }
  // In units of their extent, squared distances neither underflow nor overflow.
  glm::vec3 low = distinct.positions.front();
  glm::vec3 high = low;
  for (const glm::vec3& position : distinct.positions)
  {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  const glm::dvec3 size = glm::dvec3(high) - glm::dvec3(low);
  const double unit = std::max({ size.x, size.y, size.z });
  for (glm::vec3& position : distinct.positions)
  {
    position = glm::vec3((glm::dvec3(position) - glm::dvec3(low)) / unit);
  }

  Neighborhoods all(distinct.positions, normalsOf(distinct, normals));
  std::vector<float> radius(distinct.positions.size());
  // Finding the neighbors takes about half of the time, the cells most of the rest.
  double done = 0.0;
  const auto run = [&](double share, const auto& step)
  {
    const double before = done;
    done += share;
    const Progress part = [&](double of) { return !progress || progress(before + share * of); };
    return parallelForEach(distinct.positions.size(), step, radiiPerChunk, part);
  };
  const auto unlessIsolated = [&](const auto& step)
  {
    return [&](std::size_t i)
    {
      if (!all.isolated[i])
      {
        step(i);
      }
    };
  };
  const auto findIsolated = [&]
  {
    std::vector<float> spacings = all.spacing;
    const float usual = median(spacings);
    std::vector<char> more(distinct.positions.size());
    if (!run(0.08, [&](std::size_t i) { all.findIsolated(i, usual); }) ||
      !run(0.02, [&](std::size_t i) { more[i] = all.isolated[i] || all.isAmongIsolated(i); }))
    {
      return false;
    }
    all.isolated = std::move(more);
    return true;
  };
  if (!run(0.5, [&](std::size_t i) { all.findNeighbors(i); }) || !findIsolated() ||
    !run(0.3, unlessIsolated([&](std::size_t i) { all.measureCell(i); })) ||
    !run(0.05, unlessIsolated([&](std::size_t i) { all.coverCell(i); })) ||
    !run(0.02, unlessIsolated([&](std::size_t i) { all.widen(i); })) ||
    !run(
      0.03, unlessIsolated([&](std::size_t i) { radius[i] = static_cast<float>(unit * all.radiusOf(i)); })))
  {
    return {};
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (const std::uint32_t welded = distinct.of[i]; welded != WeldedPoints::none)
    {
      result.radius[i] = radius[welded];
      result.isolated[i] = all.isolated[welded];
      result.isolatedCount += all.isolated[welded] ? 1 : 0;
    }
  }
  return result;
}

} // namespace ink
