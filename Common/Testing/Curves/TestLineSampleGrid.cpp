// SPDX-License-Identifier: BSD-3-Clause
// What a grid finds is what comparing with all samples finds.

#include "Curves/Streamlines/LineSampleGrid.h"

#include "Core/Hash.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace
{

using namespace ink;

LineSample sampleAt(std::uint64_t id)
{
  const auto coordinate = [&](std::uint64_t n) { return 20.0f * unitFloat(hash(1, id, n)) - 10.0f; };
  const glm::vec3 normal(unitFloat(hash(1, id, 3)) - 0.5f, unitFloat(hash(1, id, 4)) - 0.5f, 0.4f);
  return { { coordinate(0), coordinate(1), 0.2f * coordinate(2) }, glm::normalize(normal) };
}

} // namespace

TEST(LineSampleGrid, FindsWhatIsNear)
{
  std::vector<LineSample> samples;
  LineSampleGrid grid(1.0f);
  EXPECT_TRUE(grid.isEmpty());
  int found = 0;
  for (std::uint64_t i = 0; i < 2000; ++i)
  {
    const LineSample asked = sampleAt(i);
    const float distance = 0.2f + 0.8f * unitFloat(hash(2, i));
    const bool expected = std::any_of(samples.begin(), samples.end(),
      [&](const LineSample& other) { return areNear(asked, other, distance); });
    ASSERT_EQ(grid.isNear(asked, distance), expected) << i;
    found += expected ? 1 : 0;
    samples.push_back(asked);
    grid.insert(asked);
  }
  EXPECT_GT(found, 300);
  EXPECT_LT(found, 1700);
  grid.clear();
  EXPECT_TRUE(grid.isEmpty());
  EXPECT_FALSE(grid.isNear(sampleAt(5), 1.0f));
}

TEST(LineSampleGrid, SheetsAreApart)
{
  const glm::vec3 up(0.0f, 0.0f, 1.0f);
  const LineSample here{ { 0.0f, 0.0f, 0.0f }, up };
  EXPECT_TRUE(areNear(here, { { 0.5f, 0.0f, 0.1f }, up }, 1.0f));
  EXPECT_FALSE(areNear(here, { { 1.5f, 0.0f, 0.0f }, up }, 1.0f));
  EXPECT_FALSE(areNear(here, { { 0.0f, 0.1f, -0.2f }, -up }, 1.0f)); // the other side of a wall
  EXPECT_FALSE(areNear(here, { { 0.0f, 0.1f, 0.5f }, up }, 1.0f));   // a sheet above
}
