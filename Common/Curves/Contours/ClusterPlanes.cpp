// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/ClusterPlanes.h"

#include "Core/ParallelChunks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
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

#include "Simd/Simd.h"

using Floats = Group<float>;
using Words = Group<std::uint32_t>;
using Masks = VectorOf<std::uint16_t, 16>::Type;

constexpr float largest = 127.0f; ///< deviation, in steps
/// What a deviation is worth where it stands as the highest byte of a word.
constexpr float highestByte = 0x1p-24f;

Floats highestBytes(const Words& words)
{
  return __builtin_convertvector(reinterpret_cast<Group<std::int32_t>>(words & 0xff000000u), Floats);
}

std::uint32_t byteOf(double deviation, float step)
{
  const double steps = step > 0.0f ? deviation / static_cast<double>(step) : 0.0;
  return static_cast<std::uint8_t>(static_cast<std::int8_t>(steps + (steps < 0.0 ? -0.5 : 0.5)));
}

} // namespace

ClusterPlanes::Cluster ClusterPlanes::around(
  std::span<const NormalCone::Item> items, std::size_t itemsPerElement)
{
  Cluster cluster{};
  glm::dvec4 planes[most]; // normals and offsets
  std::size_t count = 0;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    const glm::dvec4 plane(items[i].normal, glm::dot(items[i].normal, items[i].position));
    const std::size_t n = std::find(planes, planes + count, plane) - planes;
    if (n == most)
    {
      cluster.normalStep = std::numeric_limits<float>::quiet_NaN();
      std::fill_n(cluster.planesOf, items.size() / itemsPerElement, 1);
      return cluster;
    }
    planes[n] = plane;
    count = std::max(count, n + 1);
    cluster.planesOf[i / itemsPerElement] |= static_cast<std::uint16_t>(1u << n);
  }
  glm::dvec4 sum(0.0);
  for (std::size_t n = 0; n < count; ++n)
  {
    sum += planes[n];
  }
  const glm::vec4 mean(sum / static_cast<double>(count));
  double ofNormals = 0.0;
  double ofOffsets = 0.0;
  for (std::size_t n = 0; n < count; ++n)
  {
    planes[n] -= glm::dvec4(mean);
    const glm::dvec4 size = glm::abs(planes[n]);
    ofNormals = std::max({ ofNormals, size.x, size.y, size.z });
    ofOffsets = std::max(ofOffsets, size.w);
  }
  // Rounded up, so that no deviation exceeds a byte.
  const auto stepFor = [](double deviation)
  { return static_cast<float>(deviation * (1.0 + 1e-6)) / largest; };
  cluster.normalStep = stepFor(ofNormals);
  cluster.offsetStep = stepFor(ofOffsets);
  for (int axis = 0; axis < 3; ++axis)
  {
    cluster.normal[axis] = mean[axis];
  }
  cluster.offset = mean.w;
  for (std::size_t n = 0; n < count; ++n)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      cluster.deviations[n] |= byteOf(planes[n][axis], cluster.normalStep) << 8 * axis;
    }
    cluster.deviations[n] |= byteOf(planes[n].w, cluster.offsetStep) << 24;
  }
  return cluster;
}

ClusterPlanes::ClusterPlanes(std::size_t elements, std::size_t itemsPerElement, const UnitBall& ball,
  const NormalClusters::ItemsOf& itemsOf)
  : Ball(ball)
  , Clusters((elements + NormalClusters::clusterSize - 1) / NormalClusters::clusterSize)
{
  constexpr std::size_t clustersPerChunk = 1 << 8;
  parallelForChunks(
    this->Clusters.size(),
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      std::vector<NormalCone::Item> items;
      for (std::size_t i = begin; i < end; ++i)
      {
        items.clear();
        itemsOf(
          i * NormalClusters::clusterSize, std::min((i + 1) * NormalClusters::clusterSize, elements), items);
        for (NormalCone::Item& item : items)
        {
          item.position = this->Ball.toBall(item.position);
        }
        this->Clusters[i] = around(items, itemsPerElement);
      }
    },
    clustersPerChunk);
}

ClusterPlanes::View::View(const ClusterPlanes& planes, const Eye& eye)
  : Clusters(planes.Clusters.data())
  , Perspective(eye.parallel ? 0.0f : 1.0f)
{
  const glm::vec3 e = planes.Ball.toBall(eye);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Position[axis] = e[axis];
  }
  this->Slack = facingSlack(e);
  this->Span = std::abs(e.x) + std::abs(e.y) + std::abs(e.z);
}

std::uint32_t ClusterPlanes::View::straddling(std::size_t cluster) const
{
  const Cluster& c = this->Clusters[cluster];
  const auto& [x, y, z] = this->Position;
  const float mean = c.normal[0] * x + c.normal[1] * y + c.normal[2] * z - this->Perspective * c.offset;
  // Deviations are off by half a step.
  const float slack = this->Slack + 0.501f * (c.normalStep * this->Span + c.offsetStep * this->Perspective);
  const float step = c.normalStep * highestByte;
  const float ofX = x * step;
  const float ofY = y * step;
  const float ofZ = z * step;
  const float ofOffset = -this->Perspective * c.offsetStep * highestByte;
  std::uint32_t front = 0;
  std::uint32_t back = 0;
  for (std::size_t i = 0; i < most; i += GroupSize)
  {
    const auto words = load<Words>(c.deviations + i);
    const Floats facing = mean + highestBytes(words << 24) * ofX + highestBytes(words << 16) * ofY +
      highestBytes(words << 8) * ofZ + highestBytes(words) * ofOffset;
    // An eye beyond float makes NaN, for which neither holds.
    front |= static_cast<std::uint32_t>(bitsOf<4>(facing > slack)) << i;
    back |= static_cast<std::uint32_t>(bitsOf<4>(facing < -slack)) << i;
  }
  const auto masks = load<Masks>(c.planesOf);
  const Masks notInFront = masks & static_cast<std::uint16_t>(~front);
  const Masks notBehind = masks & static_cast<std::uint16_t>(~back);
  return static_cast<std::uint32_t>(bitsOf<2>((notInFront != 0) & (notBehind != 0)));
}

} // namespace ink
