// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/RepeatedTriangles.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ink
{

namespace
{

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// @param key(triangle): a hash that does not depend on the order of corners
/// @param areEqual(a, b) for triangles with equal keys
template <class Key, class Equal>
std::vector<std::uint32_t> findRepeats(std::size_t count, const Key& key, const Equal& areEqual)
{
  std::vector<std::uint64_t> keys(count);
  parallelForEach(count, [&](std::size_t i) { keys[i] = key(static_cast<std::uint32_t>(i)); });
  // A table with open addressing that is at most half full.
  std::vector<std::uint32_t> slots(std::bit_ceil(2 * count + 2), none);
  std::vector<std::uint32_t> repeats;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    std::size_t slot = keys[i] & (slots.size() - 1);
    while (slots[slot] != none && !(keys[slots[slot]] == keys[i] && areEqual(slots[slot], i)))
    {
      slot = (slot + 1) & (slots.size() - 1);
    }
    if (slots[slot] == none)
    {
      slots[slot] = i;
    }
    else
    {
      repeats.push_back(i);
    }
  }
  return repeats;
}

std::uint64_t keyOf(const glm::dvec3& point)
{
  // -0 is 0.
  return hash(std::bit_cast<std::uint64_t>(point.x + 0.0), std::bit_cast<std::uint64_t>(point.y + 0.0),
    std::bit_cast<std::uint64_t>(point.z + 0.0));
}

} // namespace

std::vector<std::uint32_t> repeatedTriangles(std::span<const Triangle> triangles)
{
  const auto sorted = [&](std::uint32_t t)
  {
    Triangle corners = triangles[t];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  return findRepeats(
    triangles.size(),
    [&](std::uint32_t t)
    {
      const auto [a, b, c] = triangles[t];
      return hash(hash(a) + hash(b) + hash(c));
    },
    [&](std::uint32_t s, std::uint32_t t) { return sorted(s) == sorted(t); });
}

std::vector<std::uint32_t> repeatedTriangles(
  std::span<const glm::dvec3> points, std::span<const Triangle> triangles)
{
  // Each point is a corner of six triangles.
  std::vector<std::uint64_t> ofPoint(points.size());
  parallelForEach(points.size(), [&](std::size_t i) { ofPoint[i] = keyOf(points[i]); });
  const auto sorted = [&](std::uint32_t t)
  {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const glm::dvec3& p = points[triangles[t][i]];
      corners[i] = { p.x, p.y, p.z };
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  const auto hasNumbers = [&](std::uint32_t t)
  {
    return std::all_of(triangles[t].begin(), triangles[t].end(),
      [&](std::uint32_t i)
      { return !(std::isnan(points[i].x) || std::isnan(points[i].y) || std::isnan(points[i].z)); });
  };
  return findRepeats(
    triangles.size(),
    [&](std::uint32_t t)
    {
      const auto [a, b, c] = triangles[t];
      return hash(ofPoint[a] + ofPoint[b] + ofPoint[c]);
    },
    // Numbers first: those that are none cannot be sorted.
    [&](std::uint32_t s, std::uint32_t t)
    { return hasNumbers(s) && hasNumbers(t) && sorted(s) == sorted(t); });
}

} // namespace ink
