// SPDX-License-Identifier: BSD-3-Clause
#include "Stippling/QuantizedPosition.h"

#include "Core/Hash.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include <cmath>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::stipple;

glm::vec3 randomPosition(std::uint64_t n, const glm::vec3& low, const glm::vec3& edges)
{
  return low +
    edges *
    glm::vec3(unitFloat(hash(1, 3 * n)), unitFloat(hash(1, 3 * n + 1)), unitFloat(hash(1, 3 * n + 2)));
}

/// Half a step and what single precision cannot hold.
glm::vec3 bound(const QuantizationBox& box, const glm::vec3& edges)
{
  constexpr float epsilon = 1.2e-7f;
  return box.scale * edges / (2.0f * quantizationSteps) +
    2.0f * epsilon * (glm::abs(box.low) + box.scale * edges);
}

TEST(QuantizedPosition, IsWithinHalfAStep)
{
  const glm::vec3 low(-0.3f, 0.4f, 0.1f);
  for (const glm::vec3& edges : { glm::vec3(1.0f), glm::vec3(1e-3f, 1e-3f, 1.0f), glm::vec3(1e-9f),
         glm::vec3(1e9f), glm::vec3(0.01f, 0.0f, 0.02f) })
  {
    for (const float size : { 1.0f, 0.25f, 1e-3f })
    {
      std::vector<glm::vec3> positions;
      glm::vec3 least(INFINITY);
      glm::vec3 most(-INFINITY);
      for (std::uint64_t n = 0; n < 500; ++n)
      {
        positions.push_back(randomPosition(n, low, size * edges));
        least = glm::min(least, positions.back());
        most = glm::max(most, positions.back());
      }
      const QuantizationBox box = fitQuantizationBox(least, most, edges);
      EXPECT_LE(box.scale, 1.001f * size + 1e-5f / std::max(edges.x, 1e-5f));
      const glm::vec3 allowed = bound(box, edges);
      for (const glm::vec3& position : positions)
      {
        const glm::vec3 off =
          glm::abs(dequantizePosition(quantizePosition(position, box, edges), box, edges) - position);
        EXPECT_TRUE(off.x <= allowed.x && off.y <= allowed.y && off.z <= allowed.z)
          << off.x << ' ' << off.y << ' ' << off.z << " in a box of " << edges.x << " times " << box.scale;
      }
    }
  }
}

TEST(QuantizedPosition, KeepsTheBoxesEndsAndSinglePositions)
{
  const glm::vec3 low(1.0f, 2.0f, 3.0f);
  const glm::vec3 high(3.0f, 2.5f, 4.0f);
  const QuantizationBox box = fitQuantizationBox(low, high, high - low);
  EXPECT_EQ(box.scale, 1.0f);
  EXPECT_EQ(quantizePosition(low, box, high - low), 0u);
  EXPECT_EQ(quantizePosition(high, box, high - low), 0x3fffffffu);
  EXPECT_EQ(dequantizePosition(0u, box, high - low), low);
  const glm::vec3 edges(0.5f, 0.0f, 2.0f);
  const QuantizationBox point = fitQuantizationBox(low, low, edges);
  EXPECT_EQ(point.scale, 0.0f);
  EXPECT_EQ(dequantizePosition(quantizePosition(low, point, edges), point, edges), low);
}

TEST(QuantizedPosition, MovesWhatLiesBeyondToTheBox)
{
  const QuantizationBox box{ glm::vec3(0.0f), 1.0f };
  const glm::vec3 edges(1.0f);
  EXPECT_EQ(quantizePosition(glm::vec3(-5.0f), box, edges), 0u);
  EXPECT_EQ(quantizePosition(glm::vec3(7.0f, 0.0f, 1e30f), box, edges), 0x3ff003ffu);
}

} // namespace
