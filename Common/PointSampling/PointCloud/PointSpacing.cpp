// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/PointCloud/PointSpacing.h"

#include "Core/Threads.h"

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace ink
{

namespace
{

constexpr std::size_t maximumQueries = 64;
constexpr std::size_t neighbors = 6;
constexpr float infinity = std::numeric_limits<float>::infinity();

/// The distance from a point to its sixth nearest distinct neighbor, or to the farthest if there are fewer;
/// infinite if there are none.
float distanceToNeighbors(std::span<const glm::vec3> points, std::size_t query)
{
  std::array<float, neighbors> nearest;
  nearest.fill(infinity);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const glm::vec3 offset = points[i] - points[query];
    const float squared = glm::dot(offset, offset);
    // False for positions that are not finite, and for duplicates of the point, as in meshes with separate
    // triangles.
    if (squared > 0.0f && squared < nearest.back())
    {
      const auto slot = std::upper_bound(nearest.begin(), nearest.end(), squared);
      std::move_backward(slot, nearest.end() - 1, nearest.end());
      *slot = squared;
    }
  }
  const auto found = std::find(nearest.begin(), nearest.end(), infinity);
  return found == nearest.begin() ? infinity : std::sqrt(*(found - 1));
}

} // namespace

float discRadiusFromSpacing(std::span<const glm::vec3> points)
{
  const std::size_t queries = std::min(points.size(), maximumQueries);
  std::vector<float> distances(queries);
  tbb::task_arena arena(threadCount());
  arena.execute(
    [&]
    {
      tbb::parallel_for(std::size_t(0), queries,
        [&](std::size_t i) { distances[i] = distanceToNeighbors(points, i * points.size() / queries); });
    });
  std::erase(distances, infinity);
  if (distances.empty())
  {
    return 0.0f;
  }
  const auto median = distances.begin() + distances.size() / 2;
  std::nth_element(distances.begin(), median, distances.end());
  return *median;
}

} // namespace ink
