// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/NormalClusters.h"

#include "Core/ParallelChunks.h"
#include "Core/Prefetch.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#if defined(__x86_64__)
#  include <immintrin.h>
#elif defined(__aarch64__)
#  include <arm_neon.h>
#endif

namespace ink
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

#include "Simd/Simd.h"

using Floats = Group<float>;
using Words = Group<std::uint32_t>;

/// What a number is worth that stands in the higher half of a word, or in its highest byte.
constexpr double highHalf = 0x1p-16;
constexpr double highByte = 0x1p-24;

Floats toFloats(const Words& words)
{
  return __builtin_convertvector(reinterpret_cast<Group<std::int32_t>>(words), Floats);
}

Floats squareRootOf(const Floats& values)
{
  Floats roots;
  for (int i = 0; i < GroupSize; ++i)
  {
    roots[i] = __builtin_sqrtf(values[i]); // compilers make one instruction of it
  }
  return roots;
}

std::size_t blocksFor(std::size_t count, std::size_t size)
{
  return (count + size - 1) / size;
}

} // namespace

void NormalClusters::store(const NormalCone& cone, Block& block, std::size_t lane)
{
  const auto pair = [](int low, int high)
  { return static_cast<std::uint32_t>(high) << 16 | static_cast<std::uint16_t>(low); };
  block.axisXY[lane] = pair(cone.axis.x, cone.axis.y);
  block.axisZSine[lane] = pair(cone.axis.z, cone.sine);
  block.bounds[lane] = pair(cone.lower, cone.upper);
  for (int axis = 0; axis < 3; ++axis)
  {
    block.center[lane] |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(cone.center[axis]))
      << 8 * (axis + 1);
  }
}

NormalCone NormalClusters::coneOf(const Block& block, std::size_t lane)
{
  const auto low = [](std::uint32_t word) { return static_cast<std::int16_t>(word); };
  const auto high = [](std::uint32_t word) { return static_cast<std::int16_t>(word >> 16); };
  const auto lowest = [](std::uint32_t word) { return static_cast<int>(static_cast<std::int8_t>(word)); };
  NormalCone cone;
  cone.axis = { low(block.axisXY[lane]), high(block.axisXY[lane]), low(block.axisZSine[lane]) };
  cone.sine = high(block.axisZSine[lane]);
  cone.lower = low(block.bounds[lane]);
  cone.upper = high(block.bounds[lane]);
  for (int axis = 0; axis < 3; ++axis)
  {
    cone.center[axis] = lowest(block.center[lane] >> 8 * (axis + 1));
  }
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
  constexpr std::size_t clustersPerChunk = 1 << 8;
  struct Box
  {
    glm::dvec3 least = glm::dvec3(infinity);
    glm::dvec3 most = glm::dvec3(-infinity);
  };
  std::vector<Box> boxes(chunksOf(this->Clusters, clustersPerChunk));
  parallelForChunks(
    this->Clusters,
    [&](std::size_t chunk, std::size_t begin, std::size_t end)
    {
      std::vector<NormalCone::Item> items;
      for (std::size_t i = begin; i < end; ++i)
      {
        boundsOf(i, items);
        for (const NormalCone::Item& item : items)
        {
          boxes[chunk].least = glm::min(boxes[chunk].least, item.position);
          boxes[chunk].most = glm::max(boxes[chunk].most, item.position);
        }
      }
    },
    clustersPerChunk);
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
  parallelForChunks(
    this->Clusters,
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      std::vector<NormalCone::Item> items;
      for (std::size_t i = begin; i < end; ++i)
      {
        boundsOf(i, items);
        for (NormalCone::Item& item : items)
        {
          item.position = this->Ball.toBall(item.position);
        }
        store(NormalCone::around(std::span<const NormalCone::Item>(items)), this->Levels[0][i / width],
          i % width);
      }
    },
    clustersPerChunk);
  while (this->Sizes.back() > width)
  {
    const LargePageVector<Block>& below = this->Levels.back();
    LargePageVector<Block> level(blocksFor(below.size(), width));
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      NormalCone cones[width];
      const std::size_t count = std::min(width, this->Sizes.back() - i * width);
      for (std::size_t lane = 0; lane < count; ++lane)
      {
        cones[lane] = coneOf(below[i], lane);
      }
      store(NormalCone::around(std::span<const NormalCone>(cones, count)), level[i / width], i % width);
    }
    this->Sizes.push_back(below.size());
    this->Levels.push_back(std::move(level));
  }
}

/// An eye among the cones, and what their integers are worth. With a parallel projection all points have the
/// same v, of length 1, and what depends on positions is 0.
struct NormalClusters::View
{
  View(const UnitBall& ball, const Eye& eye)
    : position(ball.toBall(eye))
    , slack(facingSlack(this->position))
    , ofCenter(eye.parallel ? 0.0f : static_cast<float>(NormalCone::centerStep * highByte))
    , ofOffset(eye.parallel ? 0.0f : static_cast<float>(NormalCone::offsetStep * highHalf))
  {
  }

  /// A bit for each cone that may have items with n.v < 0 and n.v >= 0.
  std::uint32_t straddling(const Block& block) const
  {
    // Axes may be too long or too short.
    constexpr auto ofAxis = static_cast<float>(NormalCone::axisStep * highHalf);
    constexpr auto straightLeast = static_cast<float>(1.0 - NormalCone::axisError);
    constexpr auto asideMost = static_cast<float>(1.0 + NormalCone::axisError);
    constexpr auto ofSine = static_cast<float>(NormalCone::sineStep * highHalf);
    std::uint32_t outside = 0;
    for (std::size_t i = 0; i < width; i += GroupSize)
    {
      const auto centers = ink::load<Words>(block.center + i);
      const Floats x = this->position.x - this->ofCenter * toFloats((centers << 16) & 0xff000000u);
      const Floats y = this->position.y - this->ofCenter * toFloats((centers << 8) & 0xff000000u);
      const Floats z = this->position.z - this->ofCenter * toFloats(centers & 0xff000000u);
      const auto xy = ink::load<Words>(block.axisXY + i);
      const auto zSine = ink::load<Words>(block.axisZSine + i);
      const auto bounds = ink::load<Words>(block.bounds + i);
      const Floats ax = ofAxis * toFloats(xy << 16);
      const Floats ay = ofAxis * toFloats(xy & 0xffff0000u);
      const Floats az = ofAxis * toFloats(zSine << 16);
      const Floats sine = ofSine * toFloats(zSine & 0xffff0000u);
      const Floats cx = y * az - z * ay;
      const Floats cy = z * ax - x * az;
      const Floats cz = x * ay - y * ax;
      const Floats straight = straightLeast * (x * ax + y * ay + z * az);
      const Floats aside = asideMost * squareRootOf(cx * cx + cy * cy + cz * cz) * sine;
      const Floats along = straight * squareRootOf(1.0f - sine * sine);
      // Bounds of n.(e - c), valid for an axis on the same side; NaN, for which neither holds, of an eye
      // beyond float.
      const auto front =
        (straight > 0.0f) & (along - aside - this->ofOffset * toFloats(bounds & 0xffff0000u) > this->slack);
      const auto back =
        (straight < 0.0f) & (along + aside - this->ofOffset * toFloats(bounds << 16) < -this->slack);
      const auto bounded = (bounds & 0xffff0000u) != static_cast<std::uint32_t>(NormalCone::unbounded) << 16;
      outside |= static_cast<std::uint32_t>(bitsOf<4>((front | back) & bounded)) << i;
    }
    return ~outside;
  }

  glm::vec3 position;
  float slack;
  float ofCenter;
  float ofOffset;
};

std::vector<std::uint32_t> NormalClusters::straddling(const Eye& eye) const
{
  if (this->Clusters == 0)
  {
    return {};
  }
  constexpr std::size_t ahead = 12; // blocks, enough for memory to answer
  const View view(this->Ball, eye);
  std::vector<std::uint32_t> found = { 0 };
  std::vector<std::uint32_t> blocks;
  for (std::size_t level = this->Levels.size(); level-- > 0;)
  {
    blocks.swap(found);
    found.resize(blocks.size() * width);
    std::size_t foundCount = 0;
    for (std::size_t n = 0; n < blocks.size(); ++n)
    {
      prefetchObject(this->Levels[level][blocks[std::min(n + ahead, blocks.size() - 1)]]);
      const std::uint32_t index = blocks[n];
      const std::uint32_t straddles = view.straddling(this->Levels[level][index]);
      const std::size_t count = std::min(width, this->Sizes[level] - index * width);
      for (std::size_t i = 0; i < count; ++i)
      {
        // Always written and sometimes kept: a branch would be guessed wrong too often.
        found[foundCount] = static_cast<std::uint32_t>(index * width + i);
        foundCount += straddles >> i & 1;
      }
    }
    found.resize(foundCount);
  }
  return found;
}

} // namespace ink
