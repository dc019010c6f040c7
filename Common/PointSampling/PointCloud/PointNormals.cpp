// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PointCloud/PointNormals.h"

#include "Core/DisjointSets.h"
#include "Core/KdTree.h"
#include "Core/ParallelChunks.h"
#include "Core/WeldedPoints.h"
#include "PointSampling/PointCloud/PcaNormal.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace ink
{

namespace
{

constexpr std::size_t normalsPerChunk = 1 << 10;
// The degree of the neighborhood graph: more neighbors smooth normals, but hardly change the tree.
constexpr std::size_t mostEdges = 16;

struct Edge
{
  float weight;
  std::uint32_t from;
  std::uint32_t to;

  bool operator<(const Edge& other) const
  {
    return std::tie(this->weight, this->from, this->to) < std::tie(other.weight, other.from, other.to);
  }
};

/// Flips normals so that they agree along the tree's edges, starting from one point of each component.
void orient(std::span<const glm::vec3> points, std::vector<Edge>& edges, std::vector<glm::vec3>& normals)
{
  std::sort(edges.begin(), edges.end());
  DisjointSets parts(points.size());
  std::erase_if(edges, [&](const Edge& edge) { return !parts.join(edge.from, edge.to); });

  std::vector<std::uint32_t> begin(points.size() + 1);
  for (const Edge& edge : edges)
  {
    ++begin[edge.from + 1];
    ++begin[edge.to + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> adjacent(2 * edges.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const Edge& edge : edges)
  {
    adjacent[next[edge.from]++] = edge.to;
    adjacent[next[edge.to]++] = edge.from;
  }

  std::vector<glm::dvec3> middle(points.size(), glm::dvec3(0.0));
  std::vector<std::uint32_t> size(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    middle[parts.least(i)] += glm::dvec3(points[i]);
    ++size[parts.least(i)];
  }
  std::vector<double> farthest(points.size(), -1.0);
  std::vector<std::uint32_t> root(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    const std::uint32_t part = parts.least(i);
    const glm::dvec3 offset = glm::dvec3(points[i]) - middle[part] / static_cast<double>(size[part]);
    if (const double distance = glm::dot(offset, offset); distance > farthest[part])
    {
      farthest[part] = distance;
      root[part] = i;
    }
  }

  std::vector<bool> seen(points.size());
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t part = 0; part < points.size(); ++part)
  {
    if (farthest[part] < 0.0)
    {
      continue;
    }
    const std::uint32_t start = root[part];
    const glm::vec3 outwards = points[start] - glm::vec3(middle[part] / static_cast<double>(size[part]));
    normals[start] *= glm::dot(normals[start], outwards) < 0.0f ? -1.0f : 1.0f;
    seen[start] = true;
    waiting.assign(1, start);
    while (!waiting.empty())
    {
      const std::uint32_t point = waiting.back();
      waiting.pop_back();
      for (std::uint32_t i = begin[point]; i < begin[point + 1]; ++i)
      {
        if (const std::uint32_t other = adjacent[i]; !seen[other])
        {
          seen[other] = true;
          normals[other] *= glm::dot(normals[other], normals[point]) < 0.0f ? -1.0f : 1.0f;
          waiting.push_back(other);
        }
      }
    }
  }
}

} // namespace

std::vector<glm::vec3> estimateNormals(std::span<const glm::vec3> points, int neighbors,
  const Progress& progress, const std::optional<glm::vec3>& viewpoint)
{
  const WeldedPoints distinct(points);
  const std::span<const glm::vec3> positions(distinct.positions);
  const KdTree tree(positions);
  const auto count = static_cast<std::size_t>(std::clamp(neighbors, 3, KdTree::most));
  const std::size_t found = std::min(count, positions.size());
  const std::size_t joined = viewpoint ? 0 : std::min(found, mostEdges);
  std::vector<glm::vec3> normals(positions.size());
  std::vector<std::uint32_t> near(joined * positions.size());
  if (!parallelForChunks(
        positions.size(),
        [&](std::size_t, std::size_t begin, std::size_t end)
        {
          std::array<std::uint32_t, KdTree::most> all;
          const std::span<std::uint32_t> mine(all.data(), found);
          for (std::size_t i = begin; i < end; ++i)
          {
            tree.find(positions[i], mine);
            normals[i] = pcaNormal(positions, mine);
            std::copy_n(mine.begin(), joined, near.begin() + static_cast<std::ptrdiff_t>(i * joined));
          }
        },
        normalsPerChunk, progress))
  {
    return {};
  }
  if (viewpoint)
  {
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      normals[i] *= glm::dot(normals[i], *viewpoint - positions[i]) < 0.0f ? -1.0f : 1.0f;
    }
  }
  else
  {
    std::vector<Edge> edges;
    edges.reserve(near.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i)
    {
      for (std::size_t n = 0; n < joined; ++n)
      {
        const std::uint32_t other = near[i * joined + n];
        if (other != i)
        {
          edges.push_back({ 1.0f - std::abs(glm::dot(normals[i], normals[other])), i, other });
        }
      }
    }
    orient(positions, edges, normals);
  }
  std::vector<glm::vec3> result(points.size(), glm::vec3(0.0f));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (distinct.of[i] != WeldedPoints::none)
    {
      result[i] = normals[distinct.of[i]];
    }
  }
  return result;
}

} // namespace ink
