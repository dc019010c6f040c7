// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/SampleGroups.h"

#include "Core/MortonOrder.h"
#include "Core/ParallelChunks.h"
#include "Core/ParallelSort.h"

#include <glm/common.hpp>

#include <cmath>
#include <tuple>

namespace ink
{
namespace
{

struct Key
{
  std::uint64_t cube;
  std::uint32_t direction;
  std::uint32_t sample;

  bool isOfGroup(const Key& other) const
  {
    return this->cube == other.cube && this->direction == other.direction;
  }
  bool operator<(const Key& other) const
  {
    return std::tie(this->cube, this->direction, this->sample) <
      std::tie(other.cube, other.direction, other.sample);
  }
};

/// Which face of a cube around the origin a vector points through, and which quarter of it.
std::uint32_t directionOf(const glm::vec3& v)
{
  const glm::vec3 size = glm::abs(v);
  const std::uint32_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t signs = (v.x < 0.0f ? 1u : 0u) | (v.y < 0.0f ? 2u : 0u) | (v.z < 0.0f ? 4u : 0u);
  return 8 * axis + signs;
}

} // namespace

SampleGroups groupSamples(
  std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, float edge)
{
  std::vector<Key> keys(positions.size());
  parallelForEach(keys.size(),
    [&](std::size_t i)
    {
      keys[i] = { mortonOfGroup(positions[i] / edge), directionOf(normals[i]),
        static_cast<std::uint32_t>(i) };
    });
  parallelSort(keys.begin(), keys.end());
  SampleGroups groups;
  groups.samples.reserve(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    if (i == 0 || !keys[i].isOfGroup(keys[i - 1]))
    {
      groups.begins.push_back(i);
    }
    groups.samples.push_back(keys[i].sample);
  }
  groups.begins.push_back(keys.size());
  return groups;
}

float groupEdge(double area, double samples)
{
  return static_cast<float>(std::sqrt(1.5 * area * samples));
}

} // namespace ink
