// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/IsoValue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace
{

constexpr int size = 48;
constexpr std::array<int, 3> cube{ size, size, size };

/// A number in [-1, 1] that depends on index alone.
double noise(std::uint64_t index)
{
  index = (index + 0x9e3779b97f4a7c15U) * 0xbf58476d1ce4e5b9U;
  index = (index ^ (index >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((index ^ (index >> 31U)) >> 11U) * 0x1p-52 - 1.0;
}

/// A volume of the value f(distance to the center, voxel index).
template <typename T>
std::vector<T> volume(const std::function<double(double, std::size_t)>& f)
{
  std::vector<T> values;
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const double c = (size - 1) / 2.0;
        values.push_back(static_cast<T>(f(std::hypot(x - c, y - c, z - c), values.size())));
      }
    }
  }
  return values;
}

/// From 1 inside to 0 outside of a sphere, over about three voxels.
double blurredSphere(double distance, double radius)
{
  return 1.0 / (1.0 + std::exp(2.0 * (distance - radius)));
}

template <typename T>
std::optional<ink::IsoSuggestion> suggest(const std::vector<T>& values)
{
  return ink::suggestIsoValue<T>(values, cube);
}

using Method = ink::IsoSuggestion::Method;

template <typename T>
class IsoValueOfType : public testing::Test
{
};
using ScalarTypes = testing::Types<signed char, unsigned char, short, unsigned short, int, unsigned int,
  long long, unsigned long long, float, double>;
TYPED_TEST_SUITE(IsoValueOfType, ScalarTypes);

TYPED_TEST(IsoValueOfType, LiesHalfWayBetweenTwoMaterials)
{
  const auto values =
    volume<TypeParam>([](double d, std::size_t i) { return 10 + 100 * blurredSphere(d, 14) + 4 * noise(i); });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->method, Method::Boundary);
  EXPECT_NEAR(suggestion->value, 60.0, 10.0);
}

TYPED_TEST(IsoValueOfType, SeparatesTheLimitsOfTheType)
{
  using Limits = std::numeric_limits<TypeParam>;
  auto values = volume<TypeParam>([](double, std::size_t) { return 0.0; });
  const auto inside = volume<unsigned char>([](double d, std::size_t) { return d < 14 ? 1 : 0; });
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = inside[i] != 0 ? Limits::max() : Limits::lowest();
  }
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  const auto low = static_cast<double>(Limits::lowest());
  const auto high = static_cast<double>(Limits::max());
  EXPECT_GT(suggestion->value, low + (high / 4 - low / 4));
  EXPECT_LT(suggestion->value, high - (high / 4 - low / 4));
}

TEST(IsoValue, FindsTheOuterOfTwoNestedSurfaces)
{
  const auto values = volume<float>(
    [](double d, std::size_t i) { return 40 * blurredSphere(d, 18) + 200 * blurredSphere(d, 9) + noise(i); });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->method, Method::Boundary);
  EXPECT_GT(suggestion->value, 10.0);
  EXPECT_LT(suggestion->value, 38.0);
}

TEST(IsoValue, IsNotLedAstrayByNoiseInTheAir)
{
  // Half as strong as the object: most intersected edges belong to noise at every value up to 50.
  const auto values =
    volume<float>([](double d, std::size_t i) { return 100 * blurredSphere(d, 14) + 25 * (1 + noise(i)); });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_GT(suggestion->value, 50.0);
  EXPECT_LT(suggestion->value, 100.0);
}

TEST(IsoValue, PassesOverTheBorderOfTheFieldOfView)
{
  // A scanner's padding around its round field of view.
  auto values = volume<short>(
    [](double d, std::size_t i) { return -1000 + 1040 * blurredSphere(d, 14) + 20 * noise(i); });
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double c = (size - 1) / 2.0;
    if (std::hypot(static_cast<double>(i % size) - c, static_cast<double>(i / size % size) - c) > size / 2.0)
    {
      values[i] = -3024;
    }
  }
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_GT(suggestion->value, -800.0);
  EXPECT_LT(suggestion->value, 0.0);
}

TEST(IsoValue, TakesTheMiddleOfTwoValues)
{
  const auto suggestion = suggest(volume<double>([](double d, std::size_t) { return d < 14 ? 7.0 : 3.0; }));
  ASSERT_TRUE(suggestion);
  EXPECT_NEAR(suggestion->value, 5.0, 0.01);
}

TEST(IsoValue, IsMissingForOneValue)
{
  EXPECT_FALSE(suggest(volume<float>([](double, std::size_t) { return 4.0; })));
  EXPECT_FALSE(ink::suggestIsoValue<float>({}, { 0, 4, 4 }));
  EXPECT_FALSE(suggest(volume<float>([](double, std::size_t) { return std::nan(""); })));
}

TEST(IsoValue, SkipsWhatIsNotFinite)
{
  const auto clean =
    volume<float>([](double d, std::size_t i) { return 100 * blurredSphere(d, 14) + 2 * noise(i); });
  auto dirty = clean;
  for (std::size_t i = 0; i < dirty.size(); i += 7)
  {
    const float bad[] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
      -std::numeric_limits<float>::infinity() };
    dirty[i] = bad[i / 7 % 3];
  }
  const auto suggestion = suggest(dirty);
  ASSERT_TRUE(suggestion);
  EXPECT_NEAR(suggestion->value, suggest(clean)->value, 8.0);
}

TEST(IsoValue, IsNotSqueezedByOutliers)
{
  auto values =
    volume<float>([](double d, std::size_t i) { return 100 * blurredSphere(d, 14) + 2 * noise(i); });
  values[5] = 1e30F;
  values[500] = -1e30F;
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_NEAR(suggestion->value, 50.0, 10.0);
}

TEST(IsoValue, SplitsAHistogramWithoutBoundaries)
{
  // Noise only: no surface is worth anything, but a value within the range is still given.
  const auto suggestion = suggest(volume<float>([](double, std::size_t i) { return noise(i); }));
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->method, Method::Otsu);
  EXPECT_NEAR(suggestion->value, 0.0, 0.05);
}

TEST(IsoValue, WorksOnOneSliceAndOneRow)
{
  const std::vector<float> row{ 0, 0, 0, 0, 8, 8, 8, 8 };
  const auto ofRow = ink::suggestIsoValue<float>(row, { 8, 1, 1 });
  ASSERT_TRUE(ofRow);
  EXPECT_NEAR(ofRow->value, 4.0, 0.1);
  const auto ofSlice = ink::suggestIsoValue<float>(row, { 4, 2, 1 });
  ASSERT_TRUE(ofSlice);
  EXPECT_NEAR(ofSlice->value, 4.0, 0.1);
}

TEST(IsoValue, IsTheSameOnAnyNumberOfThreads)
{
  const auto values =
    volume<float>([](double d, std::size_t i) { return blurredSphere(d, 14) + noise(i) / 10; });
  std::vector<double> found;
  for (const char* threads : { "1", "2" })
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    found.push_back(suggest(values)->value);
  }
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(found[0], found[1]);
}

TEST(IsoValue, RejectsAWrongSize)
{
  EXPECT_THROW(ink::suggestIsoValue<float>(std::vector<float>(7), { 2, 2, 2 }), std::invalid_argument);
}

TEST(IsoValue, IsTheSameFromAFewSlicesAtATime)
{
  auto values = volume<float>(
    [](double distance, std::size_t index) { return 100 * blurredSphere(distance, 15) + 5 * noise(index); });
  values[1000] = std::numeric_limits<float>::quiet_NaN();
  const auto whole = suggest(values);
  ASSERT_TRUE(whole);
  for (const int atOnce : { 3, 4, 17, size, size + 5 })
  {
    int most = 0;
    const ink::SliceReader<float> read = [&](int first, int last)
    {
      most = std::max(most, last - first);
      // A copy, so that what is kept of earlier calls would show.
      static std::vector<float> slices;
      slices.assign(values.begin() + first * size * size, values.begin() + last * size * size);
      return std::span<const float>(slices);
    };
    const auto parts = ink::suggestIsoValue(read, cube, atOnce);
    ASSERT_TRUE(parts) << atOnce;
    EXPECT_EQ(parts->value, whole->value) << atOnce;
    EXPECT_EQ(parts->method, whole->method) << atOnce;
    EXPECT_LE(most, atOnce);
  }
}

TEST(IsoValue, RefusesSlicesOfAnotherSize)
{
  const std::vector<float> values(7);
  const ink::SliceReader<float> read = [&](int, int) { return std::span<const float>(values); };
  EXPECT_THROW(ink::suggestIsoValue(read, cube, 3), std::invalid_argument);
  EXPECT_THROW(ink::suggestIsoValue(read, cube, 2), std::invalid_argument);
}

} // namespace
