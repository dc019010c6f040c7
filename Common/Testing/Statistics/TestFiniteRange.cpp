// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/FiniteRange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace
{

template <typename T>
ink::FiniteRange summarize(const std::vector<T>& values)
{
  return ink::findFiniteRange(std::span<const T>(values));
}

TEST(FiniteRange, FindsTheRangeOfFiniteValues)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto summary = summarize<float>({ nan, 3, -infinity, -7.5, infinity, 2 });
  EXPECT_EQ(summary.least, -7.5);
  EXPECT_EQ(summary.greatest, 3);
  EXPECT_EQ(summary.notFinite, 3U);
}

TEST(FiniteRange, HasNoRangeWithoutFiniteValues)
{
  for (const auto& summary :
    { summarize<double>({}), summarize<double>({ std::numeric_limits<double>::infinity() }) })
  {
    EXPECT_GT(summary.least, summary.greatest);
  }
}

TEST(FiniteRange, TakesTheEndsOfTypes)
{
  using Limits = std::numeric_limits<std::int8_t>;
  const auto bytes = summarize<signed char>({ Limits::max(), Limits::lowest() });
  EXPECT_EQ(bytes.least, -128);
  EXPECT_EQ(bytes.greatest, 127);
  const double largest = std::numeric_limits<double>::max();
  const auto doubles = summarize<double>({ -largest, largest });
  EXPECT_EQ(doubles.least, -largest);
  EXPECT_EQ(doubles.greatest, largest);
}

TEST(FiniteRange, JoinsParts)
{
  // Longer than what a thread takes at a time.
  std::vector<double> values(3'000'001, 5.0);
  values[7] = -1;
  values[2'999'999] = 9;
  values[1'500'000] = std::numeric_limits<double>::quiet_NaN();
  const auto whole = summarize(values);
  EXPECT_EQ(whole.least, -1);
  EXPECT_EQ(whole.greatest, 9);
  EXPECT_EQ(whole.notFinite, 1U);
  ink::FiniteRange joined;
  for (std::size_t first = 0; first < values.size(); first += 700'000)
  {
    const std::size_t size = std::min<std::size_t>(700'000, values.size() - first);
    joined.add(ink::findFiniteRange(std::span<const double>(values).subspan(first, size)));
  }
  EXPECT_EQ(joined.least, whole.least);
  EXPECT_EQ(joined.greatest, whole.greatest);
  EXPECT_EQ(joined.notFinite, whole.notFinite);
}

} // namespace
