// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "Statistics/IsoStatistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace
{

/// Counts by what IsoStatistics says, threshold by threshold.
class Count
{
public:
  Count(const std::vector<float>& values, const std::array<int, 3>& size)
    : Values(values)
    , Size(size)
  {
  }

  /// At the threshold between bins, which are integers from 0 on, `low` and `low` + 1.
  struct Sums
  {
    std::int64_t edges = 0, steps = 0, maskEdges = 0, maskSteps = 0, speckEdges = 0;
  };
  Sums at(int low) const
  {
    Sums sums;
    std::array<int, 3> p{};
    for (p[2] = 0; p[2] < this->Size[2]; ++p[2])
    {
      for (p[1] = 0; p[1] < this->Size[1]; ++p[1])
      {
        for (p[0] = 0; p[0] < this->Size[0]; ++p[0])
        {
          this->add(p, low, sums);
        }
      }
    }
    return sums;
  }

private:
  std::optional<int> get(std::array<int, 3> p, int axis, int way) const
  {
    p[axis] += way;
    if (p[axis] < 0 || p[axis] >= this->Size[axis])
    {
      return {};
    }
    const float value =
      this->Values[static_cast<std::size_t>(p[0] + this->Size[0] * (p[1] + this->Size[1] * p[2]))];
    return std::isfinite(value) ? std::optional(static_cast<int>(value)) : std::nullopt;
  }

  void add(const std::array<int, 3>& p, int low, Sums& sums) const
  {
    const std::optional<int> own = this->get(p, 0, 0);
    if (!own)
    {
      return;
    }
    int present = 0;
    int above = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int way : { -1, 1 })
      {
        const std::optional<int> other = this->get(p, axis, way);
        present += other ? 1 : 0;
        above += other && *other > low ? 1 : 0;
        if (other && *own <= low && *other > low)
        {
          ++sums.edges;
          sums.steps += *other - *own;
          if (this->get(p, axis, -way) == own)
          {
            ++sums.maskEdges;
            sums.maskSteps += *other - *own;
          }
        }
      }
    }
    // All but one of a voxel's edges at least.
    sums.speckEdges += present == 6 && *own > low && above <= 1 ? 5 : 0;
  }

  const std::vector<float>& Values;
  std::array<int, 3> Size;
};

std::vector<float> numbers(const std::array<int, 3>& size, int levels, double gapShare)
{
  std::vector<float> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::uint64_t random = ink::hash(7, i, static_cast<std::uint64_t>(levels));
    // Small numbers mostly, so that there are runs of equal ones and specks.
    const auto number = static_cast<int>(random % static_cast<std::uint64_t>(levels));
    const bool gap = static_cast<double>(random >> 40) < gapShare * 0x1p24;
    values[i] = gap             ? std::numeric_limits<float>::quiet_NaN()
      : (random >> 20) % 3 == 0 ? static_cast<float>(number)
                                : 0.0f;
  }
  values.front() = 0.0f;
  values.back() = static_cast<float>(levels - 1);
  return values;
}

} // namespace

TEST(SliceCounter, CountsEdgesMasksAndSpecks)
{
  for (const std::array<int, 3>& size :
    { std::array{ 9, 8, 7 }, std::array{ 17, 1, 5 }, std::array{ 1, 6, 6 }, std::array{ 40, 3, 1 } })
  {
    for (const double gapShare : { 0.0, 0.05 })
    {
      constexpr int levels = 6;
      SCOPED_TRACE(testing::Message() << size[0] << 'x' << size[1] << 'x' << size[2] << ' ' << gapShare);
      const std::vector<float> values = numbers(size, levels, gapShare);
      // As short integers a bin is a number, too, but there are no gaps.
      std::vector<short> shorts;
      if (gapShare == 0.0)
      {
        shorts.assign(values.begin(), values.end());
      }
      const std::size_t slice = static_cast<std::size_t>(size[0] * size[1]);
      const auto floats = ink::makeIsoStatistics<float>([&](int first, int last)
        { return std::span(values).subspan(slice * first, slice * (last - first)); },
        size, 3);
      ASSERT_TRUE(floats);
      const auto integers = gapShare > 0.0
        ? std::nullopt
        : ink::makeIsoStatistics<short>([&](int first, int last)
            { return std::span(std::as_const(shorts)).subspan(slice * first, slice * (last - first)); },
            size, size[2] + 2);
      const Count count(values, size);
      for (int low = 0; low + 1 < levels; ++low)
      {
        SCOPED_TRACE(low);
        const Count::Sums expected = count.at(low);
        const auto bin = static_cast<std::size_t>((low + 0.5 - floats->bins.low) / floats->bins.width);
        EXPECT_EQ(floats->edges[bin], expected.edges);
        EXPECT_EQ(floats->maskEdges[bin], expected.maskEdges);
        EXPECT_EQ(floats->speckEdges[bin], expected.speckEdges);
        if (integers)
        {
          const auto at = static_cast<std::size_t>(low);
          EXPECT_EQ(integers->edges[at], expected.edges);
          EXPECT_EQ(integers->steps[at], expected.steps);
          EXPECT_EQ(integers->maskEdges[at], expected.maskEdges);
          EXPECT_EQ(integers->maskSteps[at], expected.maskSteps);
          EXPECT_EQ(integers->speckEdges[at], expected.speckEdges);
        }
      }
    }
  }
}

TEST(SliceCounter, HasRoomForManyLargeSteps)
{
  // More edges, of the largest step there is, than sums have room for.
  const std::array<int, 3> size{ 1024, 1024, 8 };
  std::vector<short> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = (i + i / 1024 + i / (1024 * 1024)) % 2 == 0 ? 0 : 4000;
  }
  const auto statistics = ink::makeIsoStatistics<short>([&](int first, int last)
    { return std::span(std::as_const(values)).subspan(1024 * 1024 * first, 1024 * 1024 * (last - first)); },
    size, size[2] + 2);
  ASSERT_TRUE(statistics);
  const std::int64_t edges = std::int64_t(2) * 1023 * 1024 * 8 + std::int64_t(1024) * 1024 * 7;
  EXPECT_EQ(statistics->edges[0], edges);
  EXPECT_EQ(statistics->steps[0], 4000 * edges);
  EXPECT_EQ(statistics->edges[3999], edges);
  EXPECT_EQ(statistics->steps[3999], 4000 * edges);
}
