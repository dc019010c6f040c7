// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/NormalClusters.h"

#include "Core/ParallelFor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace ink
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t blocksFor(std::size_t count, std::size_t size)
{
  return (count + size - 1) / size;
}

} // namespace

void NormalClusters::store(const NormalCone& cone, Block& block, std::size_t lane)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    block.center[axis][lane] = static_cast<float>(cone.center[axis]);
    block.axis[axis][lane] = static_cast<float>(cone.axis[axis]);
  }
  block.cosine[lane] = static_cast<float>(cone.cosine);
  block.sine[lane] = static_cast<float>(cone.sine);
  block.lower[lane] = static_cast<float>(cone.lower);
  block.upper[lane] = static_cast<float>(cone.upper);
}

NormalCone NormalClusters::load(const Block& block, std::size_t lane)
{
  NormalCone cone;
  for (int axis = 0; axis < 3; ++axis)
  {
    cone.center[axis] = block.center[axis][lane];
    cone.axis[axis] = block.axis[axis][lane];
  }
  cone.cosine = block.cosine[lane];
  cone.sine = block.sine[lane];
  cone.lower = block.lower[lane];
  cone.upper = block.upper[lane];
  return cone;
}

NormalClusters::NormalClusters(std::size_t elements, const ItemsOf& itemsOf, std::size_t size)
  : Clusters(blocksFor(elements, size))
{
  const auto boundsOf = [&](std::size_t cluster, std::vector<NormalCone::Item>& items)
  {
    items.clear();
    itemsOf(cluster * size, std::min((cluster + 1) * size, elements), items);
  };
  if (this->Clusters == 0)
  {
    return;
  }
  constexpr std::size_t chunkSize = 1 << 8;
  const std::size_t chunks = blocksFor(this->Clusters, chunkSize);
  struct Box
  {
    glm::dvec3 least = glm::dvec3(infinity);
    glm::dvec3 most = glm::dvec3(-infinity);
  };
  std::vector<Box> boxes(chunks);
  parallelFor(chunks,
    [&](std::size_t chunk)
    {
      std::vector<NormalCone::Item> items;
      for (std::size_t i = chunk * chunkSize; i < std::min((chunk + 1) * chunkSize, this->Clusters); ++i)
      {
        boundsOf(i, items);
        for (const NormalCone::Item& item : items)
        {
          boxes[chunk].least = glm::min(boxes[chunk].least, item.position);
          boxes[chunk].most = glm::max(boxes[chunk].most, item.position);
        }
      }
    });
  Box whole;
  for (const Box& box : boxes)
  {
    whole.least = glm::min(whole.least, box.least);
    whole.most = glm::max(whole.most, box.most);
  }
  this->Ball = { 0.5 * whole.least + 0.5 * whole.most,
    std::max(glm::length(0.5 * whole.most - 0.5 * whole.least), 1e-300) };

  this->Sizes.push_back(this->Clusters);
  this->Levels.emplace_back(blocksFor(this->Clusters, width));
  parallelFor(chunks,
    [&](std::size_t chunk)
    {
      std::vector<NormalCone::Item> items;
      for (std::size_t i = chunk * chunkSize; i < std::min((chunk + 1) * chunkSize, this->Clusters); ++i)
      {
        boundsOf(i, items);
        for (NormalCone::Item& item : items)
        {
          item.position = this->Ball.toBall(item.position);
        }
        store(NormalCone::around(std::span<const NormalCone::Item>(items)), this->Levels[0][i / width],
          i % width);
      }
    });
  while (this->Sizes.back() > width)
  {
    const std::vector<Block>& below = this->Levels.back();
    std::vector<Block> level(blocksFor(below.size(), width));
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      NormalCone cones[width];
      const std::size_t count = std::min(width, this->Sizes.back() - i * width);
      for (std::size_t lane = 0; lane < count; ++lane)
      {
        cones[lane] = load(below[i], lane);
      }
      store(NormalCone::around(std::span<const NormalCone>(cones, count)), level[i / width], i % width);
    }
    this->Sizes.push_back(below.size());
    this->Levels.push_back(std::move(level));
  }
}

std::vector<std::uint32_t> NormalClusters::straddling(const Eye& eye) const
{
  if (this->Clusters == 0)
  {
    return {};
  }
  // With a parallel projection all points have the same v, of length 1, and the second term is 0.
  const glm::vec3 e = this->Ball.toBall(eye);
  const float perspective = eye.parallel ? 0.0f : 1.0f;
  const float slack = facingSlack(e);
  std::vector<std::uint32_t> found = { 0 };
  std::vector<std::uint32_t> blocks;
  for (std::size_t level = this->Levels.size(); level-- > 0;)
  {
    blocks.swap(found);
    found.resize(blocks.size() * width);
    std::size_t foundCount = 0;
    for (const std::uint32_t index : blocks)
    {
      const Block& b = this->Levels[level][index];
      std::uint32_t straddles[width];
      for (std::size_t i = 0; i < width; ++i)
      {
        const float x = e.x - perspective * b.center[0][i];
        const float y = e.y - perspective * b.center[1][i];
        const float z = e.z - perspective * b.center[2][i];
        const float ax = b.axis[0][i];
        const float ay = b.axis[1][i];
        const float az = b.axis[2][i];
        const float cx = y * az - z * ay;
        const float cy = z * ax - x * az;
        const float cz = x * ay - y * ax;
        const float straight = x * ax + y * ay + z * az;
        const float aside = std::sqrt(cx * cx + cy * cy + cz * cz) * b.sine[i];
        const float along = straight * b.cosine[i];
        // Bounds of n.(e - c), valid for an axis on the same side; an infinite bound times 0 is NaN, for
        // which neither holds.
        const bool front = (straight > 0.0f) & (along - aside - perspective * b.upper[i] > slack);
        const bool back = (straight < 0.0f) & (along + aside - perspective * b.lower[i] < -slack);
        straddles[i] = !(front | back);
      }
      const std::size_t count = std::min(width, this->Sizes[level] - index * width);
      for (std::size_t i = 0; i < count; ++i)
      {
        // Always written and sometimes kept: a branch would be guessed wrong too often.
        found[foundCount] = static_cast<std::uint32_t>(index * width + i);
        foundCount += straddles[i];
      }
    }
    found.resize(foundCount);
  }
  return found;
}

} // namespace ink
