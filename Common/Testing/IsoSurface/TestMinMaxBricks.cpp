// SPDX-License-Identifier: BSD-3-Clause
// The min-max index: the same cells with it as without, whatever the values, and no more memory than it
// should.

#include "AnalyticFields.h"
#include "IsoSurface/MinMaxBricks.h"
#include "SampledVolume.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace ink
{

bool operator==(const CellRun& a, const CellRun& b)
{
  return a.cells == b.cells && a.first == b.first;
}

} // namespace ink

namespace
{

using namespace ink::testing;
using ink::CrossingRule;
using ink::GridGeometry;
using ink::MinMaxBricks;

std::vector<ink::CellRun> runsOf(const ink::ActiveCells& cells)
{
  std::vector<ink::CellRun> runs;
  for (const auto& slab : cells.slabs)
  {
    runs.insert(runs.end(), slab.runs.begin(), slab.runs.end());
  }
  return runs;
}

template <class T>
void expectSameCells(unsigned seed)
{
  std::mt19937 random(seed);
  const auto upTo = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const GridGeometry geometry({ 2 + upTo(150), 2 + upTo(20), 2 + upTo(40) });
  // Smooth, so that most bricks hold one side only.
  const Sphere sphere{ glm::dvec3(upTo(100), upTo(10), upTo(20)), 12.0 };
  auto volume =
    Volume<T>::from(geometry, [&](auto p) { return std::clamp(50 + sphere.value(p), 0.0, 100.0); });
  std::vector<std::uint8_t> marks(volume.values.size(), 0);
  for (int n = 0; n < 20 && seed % 2; ++n)
  {
    const std::size_t at = random() % volume.values.size();
    marks[at] = 2;
    if constexpr (std::is_floating_point_v<T>)
    {
      constexpr T infinity = std::numeric_limits<T>::infinity();
      volume.values[at] = n % 3 == 0 ? infinity
        : n % 3 == 1                 ? -infinity
                                     : std::numeric_limits<T>::quiet_NaN();
      marks[at] = 0;
    }
  }
  const auto field = volume.field(seed % 4 == 1 ? ink::ElementMarks{ marks, 2 } : ink::ElementMarks{});
  for (const CrossingRule rule : { CrossingRule::HalfOpen, CrossingRule::Strict })
  {
    MinMaxBricks ranges;
    for (const double isoValue : { 50.0, 45.5, 0.0, 100.0, -1.0, 1e30, std::nan("") })
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", iso-value " + std::to_string(isoValue));
      const std::span<const double> isoValues(&isoValue, 1);
      const auto expected = findActiveCells(field, isoValue, rule);
      const auto cells = findActiveCells(field, isoValues, rule, {}, {}, &ranges);
      EXPECT_TRUE(ranges.template fits<T>(geometry.dimensions()));
      EXPECT_EQ(cells.front().count, expected.count);
      EXPECT_EQ(runsOf(cells.front()), runsOf(expected));
    }
  }
}

TEST(MinMaxBricks, ChangeNoCells)
{
  for (unsigned seed = 0; seed < 24 && !HasFailure(); ++seed)
  {
    expectSameCells<unsigned char>(seed);
    expectSameCells<short>(seed);
    expectSameCells<long long>(seed);
    expectSameCells<float>(seed);
    expectSameCells<double>(seed);
  }
}

TEST(MinMaxBricks, HoldTheExtremesOfTheirSamples)
{
  const auto volume =
    Volume<short>::from(GridGeometry({ 70, 9, 6 }), [](auto p) { return p.x + 100 * p.y + 1000 * p.z; });
  MinMaxBricks ranges;
  const double isoValue = 500.0;
  findActiveCells(
    volume.field(), std::span<const double>(&isoValue, 1), CrossingRule::HalfOpen, {}, {}, &ranges);
  ASSERT_EQ(ranges.counts(), glm::ivec3(3, 3, 2));
  EXPECT_EQ(ranges.low<short>(0, 0)[0], 0);
  EXPECT_EQ(ranges.high<short>(0, 0)[0], 31 + 300 + 3000);
  EXPECT_EQ(ranges.low<short>(2, 1)[2], 64 + 800 + 4000);
  EXPECT_EQ(ranges.high<short>(2, 1)[2], 69 + 800 + 5000);
}

TEST(MinMaxBricks, TakeLittleMemory)
{
  const Volume<float> floats(GridGeometry({ 64, 64, 64 }));
  const Volume<unsigned char> bytes(GridGeometry({ 64, 64, 64 }));
  const double isoValue = 1.0;
  MinMaxBricks ranges;
  const std::span<const double> isoValues(&isoValue, 1);
  findActiveCells(floats.field(), isoValues, CrossingRule::HalfOpen, {}, {}, &ranges);
  EXPECT_EQ(ranges.bytes(), 4u * 64 * 64 * 64 / 128);
  ranges.clear();
  EXPECT_EQ(ranges.bytes(), 0u);
  findActiveCells(bytes.field(), isoValues, CrossingRule::HalfOpen, {}, {}, &ranges);
  EXPECT_EQ(ranges.bytes(), 64u * 64 * 64 / 256);
}

TEST(MinMaxBricks, AreLeftAloneByPartsAndInterruptions)
{
  const auto volume =
    Volume<float>::from(GridGeometry({ 40, 40, 80 }), [](const glm::dvec3& p) { return p.z - 20.5; });
  const double isoValue = 0.0;
  const std::span<const double> isoValues(&isoValue, 1);
  ink::CellSelection part;
  part.begin = { 3, 5, 18 };
  MinMaxBricks ranges;
  findActiveCells(volume.field(), isoValues, CrossingRule::HalfOpen, part, {}, &ranges);
  EXPECT_FALSE(ranges.fits<float>({ 40, 40, 80 }));
  findActiveCells(
    volume.field(), isoValues, CrossingRule::HalfOpen, {}, [](double) { return false; }, &ranges);
  EXPECT_FALSE(ranges.fits<float>({ 40, 40, 80 }));
  findActiveCells(volume.field(), isoValues, CrossingRule::HalfOpen, {}, {}, &ranges);
  EXPECT_TRUE(ranges.fits<float>({ 40, 40, 80 }));
  EXPECT_FALSE(ranges.fits<float>({ 40, 80, 40 }));
  // They serve parts too.
  const auto cells = findActiveCells(volume.field(), isoValues, CrossingRule::HalfOpen, part, {}, &ranges);
  EXPECT_EQ(cells.front().count, 36u * 34u);
}

} // namespace
