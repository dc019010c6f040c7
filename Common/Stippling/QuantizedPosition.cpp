// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/QuantizedPosition.h"

#include <algorithm>
#include <cmath>

namespace ink::stipple
{

namespace
{

constexpr int bitsPerAxis = 10;
constexpr std::uint32_t mask = (1u << bitsPerAxis) - 1u;
static_assert(mask == quantizationSteps);

} // namespace

QuantizationBox fitQuantizationBox(const glm::vec3& low, const glm::vec3& high, const glm::vec3& edges)
{
  QuantizationBox box{ low, 0.0f };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (edges[axis] > 0.0f)
    {
      box.scale = std::max(box.scale, (high[axis] - low[axis]) / edges[axis]);
    }
  }
  return box;
}

std::uint32_t quantizePosition(const glm::vec3& position, const QuantizationBox& box, const glm::vec3& edges)
{
  std::uint32_t packed = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const float length = box.scale * edges[axis];
    const float share = length > 0.0f ? (position[axis] - box.low[axis]) / length : 0.0f;
    const auto step =
      static_cast<std::uint32_t>(std::lround(std::clamp(share, 0.0f, 1.0f) * quantizationSteps));
    packed |= step << (bitsPerAxis * axis);
  }
  return packed;
}

glm::vec3 dequantizePosition(std::uint32_t packed, const QuantizationBox& box, const glm::vec3& edges)
{
  const glm::vec3 steps(static_cast<float>(packed & mask), static_cast<float>(packed >> bitsPerAxis & mask),
    static_cast<float>(packed >> (2 * bitsPerAxis) & mask));
  return box.low + box.scale * (edges / static_cast<float>(quantizationSteps)) * steps;
}

} // namespace ink::stipple
