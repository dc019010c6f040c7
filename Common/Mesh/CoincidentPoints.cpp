// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CoincidentPoints.h"

#include "Core/ParallelSort.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace ink
{

namespace
{

double largest(const glm::dvec3& v)
{
  return std::max({ v.x, v.y, v.z });
}

/// A point's position along a direction of space, which no plane of a usual mesh is at right angles to.
struct Key
{
  double along;
  std::uint32_t point;
  std::size_t entry;
  bool operator<(const Key& other) const
  {
    return this->along != other.along ? this->along < other.along : this->point < other.point;
  }
};

} // namespace

double coincidenceDistance(const glm::dvec3& lower, const glm::dvec3& upper)
{
  return 1e-6 * largest(upper - lower);
}

std::vector<std::uint32_t> coincidentPoints(
  std::span<const glm::dvec3> points, std::span<const std::uint32_t> named, double distance)
{
  const glm::dvec3 direction =
    glm::normalize(glm::dvec3(std::numbers::pi, std::numbers::e, std::numbers::phi));
  std::vector<Key> keys;
  keys.reserve(named.size());
  for (const std::uint32_t point : named)
  {
    keys.push_back({ glm::dot(points[point], direction), point, keys.size() });
  }
  parallelSort(keys.begin(), keys.end());
  // Those that stand for others, in the keys' order, each with the least index of its points.
  struct Group
  {
    const Key* first;
    std::uint32_t least;
  };
  std::vector<Group> groups;
  std::vector<std::size_t> groupOf(named.size());
  std::size_t begin = 0;
  for (const Key& key : keys)
  {
    while (begin < groups.size() && key.along - groups[begin].first->along > std::numbers::sqrt3 * distance)
    {
      ++begin;
    }
    const auto found = std::find_if(groups.begin() + static_cast<std::ptrdiff_t>(begin), groups.end(),
      [&](const Group& group)
      { return largest(glm::abs(points[group.first->point] - points[key.point])) <= distance; });
    groupOf[key.entry] = static_cast<std::size_t>(found - groups.begin());
    if (found == groups.end())
    {
      groups.push_back({ &key, key.point });
    }
    else
    {
      found->least = std::min(found->least, key.point);
    }
  }
  std::vector<std::uint32_t> result;
  result.reserve(named.size());
  for (const std::size_t group : groupOf)
  {
    result.push_back(groups[group].least);
  }
  return result;
}

} // namespace ink
