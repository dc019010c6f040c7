// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ActiveCellBound.h"

#include "SampledVolume.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::CrossingRule;

template <class T>
std::vector<std::size_t> bound(const Volume<T>& volume, double isoValue, CrossingRule rule)
{
  return ink::boundActiveCells(
    std::span<const T>(volume.values), volume.geometry.dimensions(), isoValue, rule);
}

/// The active cells, by layer.
template <class T>
std::vector<std::size_t> count(const Volume<T>& volume, double isoValue, CrossingRule rule)
{
  const glm::ivec3 cells = volume.geometry.dimensions() - 1;
  std::vector<std::size_t> counts;
  for (int layer = 0; layer < cells.z; ++layer)
  {
    ink::CellSelection selection;
    selection.begin = { 0, 0, layer };
    selection.end = { cells.x, cells.y, layer + 1 };
    counts.push_back(ink::findActiveCells(volume.field(), isoValue, rule, selection).count);
  }
  return counts;
}

template <class T>
Volume<T> randomVolume(unsigned seed)
{
  std::mt19937 random(seed);
  const auto size = [&random] { return 2 + static_cast<int>(random() % 20); };
  Volume<T> volume(ink::GridGeometry({ 5 * size(), size(), size() }));
  for (T& value : volume.values)
  {
    value = static_cast<T>(random() % 7);
  }
  return volume;
}

template <class T>
void expectBounds()
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const auto volume = randomVolume<T>(seed);
    for (const double isoValue : { -1.0, 0.0, 0.5, 3.0, 6.0, 6.5, 1e30 })
    {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", iso-value " << isoValue);
      EXPECT_EQ(
        bound(volume, isoValue, CrossingRule::HalfOpen), count(volume, isoValue, CrossingRule::HalfOpen));
      const auto bounds = bound(volume, isoValue, CrossingRule::Strict);
      const auto counts = count(volume, isoValue, CrossingRule::Strict);
      ASSERT_EQ(bounds.size(), counts.size());
      for (std::size_t layer = 0; layer < counts.size(); ++layer)
      {
        EXPECT_GE(bounds[layer], counts[layer]) << "layer " << layer;
      }
    }
  }
}

TEST(ActiveCellBound, BoundTheCellsOfEachLayer)
{
  expectBounds<unsigned char>();
  expectBounds<short>();
  expectBounds<unsigned long long>();
  expectBounds<float>();
  expectBounds<double>();
}

TEST(ActiveCellBound, HoldAtTheEndsOfTypes)
{
  Volume<unsigned char> volume(ink::GridGeometry({ 9, 9, 3 }), 255);
  EXPECT_EQ(bound(volume, 255, CrossingRule::HalfOpen), std::vector<std::size_t>({ 0, 0 }));
  // Every edge has two ends at the iso-value.
  EXPECT_EQ(bound(volume, 255, CrossingRule::Strict), std::vector<std::size_t>({ 64, 64 }));
  EXPECT_EQ(bound(volume, 256, CrossingRule::Strict), std::vector<std::size_t>({ 0, 0 }));
  volume.at({ 4, 4, 0 }) = 0;
  EXPECT_EQ(bound(volume, 255, CrossingRule::HalfOpen), std::vector<std::size_t>({ 4, 0 }));
}

TEST(ActiveCellBound, BoundCellsBesideMissingSamples)
{
  auto volume = randomVolume<float>(1);
  for (std::size_t n = 0; n < volume.values.size(); n += 11)
  {
    volume.values[n] =
      n % 2 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
  }
  const auto bounds = bound(volume, 3, CrossingRule::HalfOpen);
  const auto counts = count(volume, 3, CrossingRule::HalfOpen);
  for (std::size_t layer = 0; layer < counts.size(); ++layer)
  {
    EXPECT_GE(bounds[layer], counts[layer]) << "layer " << layer;
  }
}

TEST(ActiveCellBound, AreNoneWithoutCells)
{
  EXPECT_TRUE(bound(Volume<short>(ink::GridGeometry({ 1, 5, 5 })), 0, CrossingRule::HalfOpen).empty());
  EXPECT_TRUE(bound(Volume<short>(ink::GridGeometry({ 0, 0, 0 })), 0, CrossingRule::HalfOpen).empty());
}

TEST(ActiveCellBound, RefuseOtherSizes)
{
  const std::vector<short> values(26);
  EXPECT_THROW(ink::boundActiveCells(std::span<const short>(values), { 3, 3, 3 }, 0, CrossingRule::HalfOpen),
    std::invalid_argument);
}

} // namespace
