// SPDX-License-Identifier: BSD-3-Clause
// Comparisons with a double as comparisons in the samples' type, at the ends of the type, too.
#include "IsoSurface/IsoThreshold.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

using ink::IsoThreshold;

template <class T>
class IsoThresholds : public testing::Test
{
};

using Integers = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
  std::uint32_t, std::int64_t, std::uint64_t>;
TYPED_TEST_SUITE(IsoThresholds, Integers);

} // namespace

TYPED_TEST(IsoThresholds, IsTheSmallestThatPasses)
{
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  // Exact for 64 bits, too.
  using Exact = long double;
  static_assert(std::numeric_limits<Exact>::digits >= Limits::digits);
  const double end = std::ldexp(1.0, Limits::digits);
  const auto first = static_cast<double>(Limits::lowest());
  const std::vector<double> values = { -1e300, std::nextafter(first, -INFINITY), first - 1.0, first,
    first + 0.5, first + 1.0, -0.5, 0.0, 0.5, 41.0, 41.5, std::nextafter(end, 0.0), end - 1.0, end - 0.5, end,
    end + 1.0, 1e300 };
  for (const double value : values)
  {
    const auto check = [value](const IsoThreshold<T>& found, const auto& passes)
    {
      EXPECT_EQ(found.reachable, passes(Limits::max())) << value;
      if (found.reachable)
      {
        EXPECT_TRUE(passes(found.lowest)) << value;
        EXPECT_TRUE(found.lowest == Limits::lowest() || !passes(static_cast<T>(found.lowest - 1))) << value;
      }
    };
    check(IsoThreshold<T>::atLeast(value), [value](T t) { return static_cast<Exact>(t) >= value; });
    check(IsoThreshold<T>::above(value), [value](T t) { return static_cast<Exact>(t) > value; });
  }
}

TEST(IsoThreshold, FloatsAreRoundedUp)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const double value : { -1e300, -1.0, 0.1, 0.5, 1.0 / 3.0, 1e20, 1e300 })
  {
    const IsoThreshold<float> least = IsoThreshold<float>::atLeast(value);
    EXPECT_TRUE(least.reachable);
    EXPECT_GE(static_cast<double>(least.lowest), value);
    EXPECT_TRUE(
      least.lowest == -infinity || static_cast<double>(std::nextafter(least.lowest, -infinity)) < value);
    const IsoThreshold<float> above = IsoThreshold<float>::above(value);
    EXPECT_GT(static_cast<double>(above.lowest), value);
    EXPECT_LE(static_cast<double>(std::nextafter(above.lowest, -infinity)), value);
  }
}
