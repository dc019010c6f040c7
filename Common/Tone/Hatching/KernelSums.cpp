// SPDX-License-Identifier: BSD-3-Clause
#include "Tone/Hatching/KernelSums.h"

#include "Core/ParallelChunks.h"
#include "Core/ParallelSort.h"
#include "Mesh/SurfaceSides.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

namespace ink::hatching
{

namespace
{

/// There may always be so many rows.
constexpr std::size_t fewRows = 1 << 16;

struct Key
{
  std::size_t row;
  float x;
  std::uint32_t sample;

  bool operator<(const Key& other) const
  {
    return std::tie(this->row, this->x, this->sample) < std::tie(other.row, other.x, other.sample);
  }
};

} // namespace

KernelSums::KernelSums(std::vector<Sample> samples, float radius)
  : Radius(radius)
{
  this->Lower = glm::vec3(std::numeric_limits<float>::infinity());
  glm::vec3 upper = -this->Lower;
  for (const Sample& sample : samples)
  {
    this->Lower = glm::min(this->Lower, sample.position);
    upper = glm::max(upper, sample.position);
  }
  // Wider rows take longer, but there are no more of them than samples.
  const glm::vec3 extent = samples.empty() ? glm::vec3(0.0f) : upper - this->Lower;
  const auto most = static_cast<float>(std::max(samples.size(), fewRows));
  this->Edge = std::max({ radius, std::sqrt(extent.y / most * extent.z), extent.y / most, extent.z / most });
  this->Rows = glm::ivec2(glm::vec2(extent.y, extent.z) / this->Edge) + 3;
  std::vector<Key> order(samples.size());
  parallelForEach(samples.size(),
    [&](std::size_t i)
    {
      const glm::ivec2 row = this->rowOf(samples[i].position);
      order[i] = { this->indexOf(row.x, row.y), samples[i].position.x, static_cast<std::uint32_t>(i) };
    });
  parallelSort(order.begin(), order.end());
  this->Begins.assign(this->indexOf(0, this->Rows.y) + 1, 0);
  this->Samples.reserve(order.size());
  for (const Key& key : order)
  {
    ++this->Begins[key.row + 1];
    this->Samples.push_back(samples[key.sample]);
  }
  std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
}

glm::ivec2 KernelSums::rowOf(const glm::vec3& position) const
{
  const glm::vec3 offset = (position - this->Lower) / this->Edge;
  return glm::ivec2(
    glm::clamp(glm::vec2(offset.y, offset.z) + 1.0f, glm::vec2(1.0f), glm::vec2(this->Rows - 2)));
}

glm::vec3 KernelSums::at(const glm::vec3& position, const glm::vec3& normal) const
{
  const glm::ivec2 row = this->rowOf(position);
  const float square = this->Radius * this->Radius;
  glm::vec3 sum(0.0f);
  for (int z = row.y - 1; z <= row.y + 1; ++z)
  {
    for (int y = row.x - 1; y <= row.x + 1; ++y)
    {
      const std::size_t index = this->indexOf(y, z);
      const Sample* const end = this->Samples.data() + this->Begins[index + 1];
      const Sample* sample = std::partition_point(this->Samples.data() + this->Begins[index], end,
        [&](const Sample& some) { return some.position.x < position.x - this->Radius; });
      for (; sample != end && sample->position.x <= position.x + this->Radius; ++sample)
      {
        const glm::vec3 offset = sample->position - position;
        const float squared = glm::dot(offset, offset);
        const float up = glm::dot(normal, offset);
        const float otherUp = glm::dot(sample->normal, offset);
        if (squared < square &&
          !areApart(glm::dot(normal, sample->normal), up * up, otherUp * otherUp, squared))
        {
          const float share = 1.0f - squared / square;
          sum += share * share * sample->weights;
        }
      }
    }
  }
  return sum;
}

} // namespace ink::hatching
