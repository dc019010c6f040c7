// SPDX-License-Identifier: BSD-3-Clause
#include "IsoValueVolumes.h"
#include "Statistics/IsoValue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink::testing::iso;
using Boundary = ink::IsoSuggestion::Boundary;

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
  EXPECT_EQ(suggestion->boundary, Boundary::Outermost);
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
  expectBetween(suggest(values), Boundary::Outermost, 10.0, 38.0);
}

TEST(IsoValue, ListsThreeNestedSurfacesAndWhatTheyKeep)
{
  const auto values = volume<float>(
    [](double d, std::size_t i) {
      return 40 * blurredSphere(d, 20) + 100 * blurredSphere(d, 14) + 200 * blurredSphere(d, 8) + noise(i);
    });
  const auto all = suggestAll(values);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].boundary, Boundary::Outermost);
  EXPECT_NEAR(all[0].value, 20.0, 6.0);
  for (const ink::IsoSuggestion& one : all)
  {
    const bool densest = one.boundary == Boundary::Densest;
    const double radius = one.boundary == Boundary::Outermost ? 20.0 : densest ? 8.0 : 14.0;
    EXPECT_NEAR(one.value, radius == 20.0 ? 20.0 : densest ? 240.0 : 90.0, 20.0);
    const double kept = 4.0 / 3.0 * 3.14159265 * std::pow(radius, 3) / std::pow(size, 3);
    EXPECT_NEAR(one.keptShare / kept, 1.0, 0.15) << one.value;
  }
  EXPECT_NE(all[1].boundary, all[2].boundary);
}

TEST(IsoValue, LiesHalfWayAlsoWhereADenserMaterialTouchesTheSurface)
{
  // Inside of the ball a dense part reaches its surface.
  const auto values = volume<float>(
    [](double d, std::size_t i)
    {
      const double dense = i % size > 2 * size / 3 ? 1.0 : 0.0;
      return (100 + 100 * dense) * blurredSphere(d, 18) + noise(i);
    });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::Outermost);
  EXPECT_NEAR(suggestion->value, 50.0, 2.0);
}

/// A head in Hounsfield units: skin with fat, soft tissue, a skull that varies from spongy to dense, as bone
/// does, a headrest beside it, and air.
double headInHounsfield(std::size_t index)
{
  const double c = (size - 1) / 2.0;
  const double x = static_cast<double>(index % size) - c;
  const double y = static_cast<double>(index / size % size) - c;
  const double z = static_cast<double>(index / size / size) - c;
  const double d = std::hypot(x, y, z);
  const double skull = 300 + 900 * (0.5 + 0.5 * std::sin(0.4 * x) * std::cos(0.3 * y + 0.5 * z));
  const double headrest = blurredSphere(std::abs(y - 22), 1.0) * (std::abs(x) < 20 ? 1.0 : 0.0);
  return -1000 + 900 * blurredSphere(d, 20) + 140 * blurredSphere(d, 18) +
    skull * (blurredSphere(d, 15) - blurredSphere(d, 11)) + 600 * headrest * (1 - blurredSphere(d, 20)) +
    25 * noise(index);
}

TEST(IsoValue, ListsSkinAndBoneOfAHead)
{
  const auto all = suggestAll(volume<short>([](double, std::size_t i) { return headInHounsfield(i); }));
  ASSERT_GE(all.size(), 2U);
  EXPECT_GT(all[0].value, -800.0);
  EXPECT_LT(all[0].value, -200.0);
  const bool bone = std::any_of(
    all.begin(), all.end(), [](const ink::IsoSuggestion& one) { return one.value > 130 && one.value < 600; });
  EXPECT_TRUE(bone) << all[1].value;
}

TEST(IsoValue, PrefersABoundaryToTheEdgeOfAMask)
{
  // Gray and white matter without their skull: all around is zero.
  const auto values = volume<short>(
    [](double d, std::size_t i) { return d > 17 ? 0.0 : 500 + 300 * blurredSphere(d, 10) + 20 * noise(i); });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_NEAR(suggestion->value, 650.0, 60.0);
}

TEST(IsoValue, TakesTheEdgeOfAMaskIfThereIsNothingElse)
{
  const auto values =
    volume<short>([](double d, std::size_t i) { return d > 17 ? 0.0 : 500 + 20 * noise(i); });
  expectBetween(suggest(values), Boundary::Outermost, 50.0, 480.0);
}

TEST(IsoValue, TakesTheEdgeOfAMaskAroundWhatIsSmall)
{
  // As a tumor that contrast shows in a brain without its skull; it comes next.
  const auto all = suggestAll(volume<short>(
    [](double d, std::size_t i) { return d > 17 ? 0.0 : 500 + 900 * blurredSphere(d, 7) + 120 * noise(i); }));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_GT(all[0].value, 50.0);
  EXPECT_LT(all[0].value, 480.0);
  EXPECT_NEAR(all[1].value, 950.0, 150.0);
  // Not of air around something in a padded field of view.
  for (const double amount : { 3.0, 10.0, 30.0, 60.0 })
  {
    const auto scanned = suggest(volume<short>([amount](double d, std::size_t i)
      { return d > 18 ? -3024.0 : -1000 + 1000 * blurredSphere(d, 7) + 2 * amount * noise(i); }));
    ASSERT_TRUE(scanned);
    EXPECT_NEAR(scanned->value, -500.0, 200.0) << amount;
  }
  // Not around nothing, as where something was looked for within a mask.
  const auto found = suggest(volume<short>([](double d, std::size_t i)
    { return d > 17 ? -1.0 : (1 + 0.05 * noise(i)) * 600 * blurredSphere(d, 6); }));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, 300.0, 100.0);
}

TEST(IsoValue, LeavesOutFragments)
{
  // A filling: some hundred voxels, with more than enough edges to be a boundary.
  const auto withNugget = [](double radius)
  {
    return volume<short>(
      [radius](double d, std::size_t i)
      {
        const double c = (size - 1) / 2.0;
        const auto x = static_cast<double>(i % size);
        const double nugget = std::hypot(
          x - c - 8, static_cast<double>(i / size % size) - c, static_cast<double>(i / size / size) - c);
        return 100 * blurredSphere(d, 20) + 900 * blurredSphere(nugget, radius) + 3 * noise(i);
      });
  };
  const auto reaches = [](const std::vector<ink::IsoSuggestion>& all)
  { return std::any_of(all.begin(), all.end(), [](const auto& one) { return one.value > 300; }); };
  EXPECT_FALSE(reaches(suggestAll(withNugget(3.8))));
  EXPECT_TRUE(reaches(suggestAll(withNugget(6))));
}

TEST(IsoValue, IsNotAPeakOfASmoothField)
{
  // The electron density of a molecule: it is steepest where most atoms overlap.
  const auto atoms = [](double, std::size_t i)
  {
    double sum = 0.0;
    for (std::uint64_t atom = 0; atom < 14; ++atom)
    {
      const auto from = [&](std::uint64_t axis, std::size_t index)
      { return static_cast<double>(index) - 0.5 * size - 14.0 * noise(3 * atom + axis); };
      const double d = std::hypot(from(0, i % size), from(1, i / size % size), from(2, i / size / size));
      sum += std::exp(-d * d / 14.0);
    }
    return sum;
  };
  const auto suggestion = suggest(volume<float>(atoms));
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::None);
  EXPECT_GT(suggestion->keptShare, 0.02);
  EXPECT_LT(suggestion->keptShare, 0.2);
}

TEST(IsoValue, IsTheBoundaryOfASmallBodyInASmoothField)
{
  const auto warm = [](double d, std::size_t i)
  {
    const double along =
      std::sin(static_cast<double>(i % size) / 12) + static_cast<double>(i / size % size) / 48;
    return 40 * along + 500 * blurredSphere(d, 5);
  };
  const auto suggestion = suggest(volume<float>(warm));
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::Outermost);
  EXPECT_NEAR(suggestion->value, 275.0, 60.0);
}

TEST(IsoValue, KeepsVaryingBoneWhole)
{
  // The densest bone makes the sharpest surface, which is full of holes.
  const auto values = volume<short>(
    [](double d, std::size_t i)
    {
      const double along = static_cast<double>(i % size) / (size - 1.0);
      return (300 + 1200 * along) * (blurredSphere(d, 18) - blurredSphere(d, 10)) + 8 * noise(i);
    });
  const auto suggestion = suggest(values);
  ASSERT_TRUE(suggestion);
  EXPECT_GT(suggestion->value, 50.0);
  EXPECT_LT(suggestion->value, 450.0);
}

TEST(IsoValue, FindsThinVesselsThatBreakUpAtHigherValues)
{
  // Nine tubes along z that taper from six voxels to one, less than two percent of the volume: where they are
  // thinner than the blur, they do not reach the full value.
  std::size_t i = 0;
  std::vector<float> values;
  for (int z = 0; z < size; ++z)
  {
    const double radius = 3.0 - 2.5 * z / (size - 1);
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const double d = std::hypot(x % 16 - 7.5, y % 16 - 7.5);
        const double height = 1.0 - std::exp(-radius * radius);
        values.push_back(static_cast<float>(100 * height * blurredSphere(d, radius) + 8 * noise(i++)));
      }
    }
  }
  expectBetween(suggest(values), Boundary::Outermost, 20.0, 60.0);
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
  EXPECT_TRUE(ink::suggestIsoValues<float>({}, { 0, 4, 4 }).empty());
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

TEST(IsoValue, SkipsFillValues)
{
  // A sixth of the volume is land, around and within the sphere; smoothing must not spread it.
  const auto isLand = [](std::size_t i) { return i % size < size / 6; };
  for (const double spread : { 2.0, 15.0 })
  {
    const auto with = [&](double fill)
    {
      return volume<float>([&](double d, std::size_t i)
        { return isLand(i) ? fill : 100 * blurredSphere(d, 14) + spread * noise(i); });
    };
    const auto expected = suggest(with(std::nan("")));
    ASSERT_TRUE(expected);
    for (const double fill : { 1e20, -9999.0 })
    {
      const auto found = suggest(with(fill));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->value, expected->value) << fill << ' ' << spread;
      EXPECT_EQ(found->keptShare, expected->keptShare) << fill << ' ' << spread;
    }
    // Near the others it is a value, as that of a bright thing.
    EXPECT_NE(suggest(with(700.0))->keptShare, expected->keptShare);
  }
  // Few values are labels, wherever they lie.
  const auto labels =
    suggest(volume<float>([&](double d, std::size_t i) { return isLand(i) ? 1e6
                                                           : d < 14       ? 1.0
                                                                          : 0.0; }));
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->value, 0.5);
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
  const auto suggestion = suggest(volume<float>([](double, std::size_t i) { return 3.0 + noise(i); }));
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::None);
  EXPECT_NEAR(suggestion->value, 3.0, 0.05);
}

TEST(IsoValue, IsWhereASignedDistanceChangesItsSign)
{
  for (const double unit : { 1.0, 300.0 })
  {
    const auto distances = suggestAll(
      volume<float>([unit](double d, std::size_t i) { return unit * (18.0 - d + 0.1 * noise(i)); }));
    ASSERT_FALSE(distances.empty());
    EXPECT_EQ(distances.front().boundary, Boundary::Sign);
    EXPECT_EQ(distances.front().value, 0.0);
    // The ball's share of the cube.
    EXPECT_NEAR(distances.front().keptShare, 4.0 / 3.0 * M_PI * 18 * 18 * 18 / (48.0 * 48 * 48), 0.01);
    EXPECT_EQ(distances.back().boundary, Boundary::None);
  }
}

TEST(IsoValue, IsWhereASignedDistanceToLittleChangesItsSign)
{
  // .06 % of the voxels are within the ball.
  const auto distances =
    suggestAll(volume<float>([](double d, std::size_t i) { return 2.5 - d + 0.1 * noise(i); }));
  ASSERT_FALSE(distances.empty());
  EXPECT_EQ(distances.front().boundary, Boundary::Sign);
  EXPECT_EQ(distances.front().value, 0.0);
  // Of integers, which scans have, 0 is no surface.
  const auto scan =
    suggest(volume<short>([](double d, std::size_t i) { return 300.0 * (2.5 - d) + 30.0 * noise(i); }));
  ASSERT_TRUE(scan);
  EXPECT_NE(scan->boundary, Boundary::Sign);
  // Values that fall a little below 0 on the way.
  for (const ink::IsoSuggestion& one :
    suggestAll(volume<float>([](double d, std::size_t) { return 0.01 * (d - 6.0) * (d - 6.0) - 0.002; })))
  {
    EXPECT_NE(one.boundary, Boundary::Sign);
  }
}

TEST(IsoValue, IsNotWhereAnOrbitalChangesItsSign)
{
  // Of the lobes of p and d orbitals; 2 voxels at the center are 1.
  const auto across = [](std::size_t i) { return (static_cast<double>(i % size) - (size - 1) / 2.0) / 2.0; };
  const auto along = [](std::size_t i)
  { return (static_cast<double>(i / size % size) - (size - 1) / 2.0) / 2.0; };
  const std::function<double(double, std::size_t)> orbitals[] = { [&](double d, std::size_t i)
    { return across(i) * std::exp(-0.5 * d); },
    [&](double d, std::size_t i) { return across(i) * along(i) * std::exp(-0.5 * d); } };
  for (const auto& orbital : orbitals)
  {
    for (const ink::IsoSuggestion& one : suggestAll(volume<float>(orbital)))
    {
      EXPECT_NE(one.boundary, Boundary::Sign);
      EXPECT_TRUE(one.isLobe);
      EXPECT_GT(one.value, 0.02);
      EXPECT_GT(one.keptShare, 0.001);
      EXPECT_LT(one.keptShare, 0.1);
    }
  }
}

TEST(IsoValue, IsAClearBoundaryRatherThanWhereTheSignChanges)
{
  // As a CT's air, fat and water.
  const auto suggestion = suggest(
    volume<float>([](double d, std::size_t i) { return 1040 * blurredSphere(d, 18) - 1000 + 2 * noise(i); }));
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::Outermost);
  EXPECT_NEAR(suggestion->value, -480.0, 100.0);
}

TEST(IsoValue, WorksOnOneSliceAndOneRow)
{
  const std::vector<float> row{ 0, 0, 0, 0, 8, 8, 8, 8 };
  const auto ofRow = ink::suggestIsoValues<float>(row, { 8, 1, 1 });
  ASSERT_EQ(ofRow.size(), 1U);
  EXPECT_NEAR(ofRow[0].value, 4.0, 0.1);
  const auto ofSlice = ink::suggestIsoValues<float>(row, { 4, 2, 1 });
  ASSERT_EQ(ofSlice.size(), 1U);
  EXPECT_NEAR(ofSlice[0].value, 4.0, 0.1);
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
  EXPECT_THROW(ink::suggestIsoValues<float>(std::vector<float>(7), { 2, 2, 2 }), std::invalid_argument);
}

TEST(IsoValue, IsTheSameFromAFewSlicesAtATime)
{
  auto values = volume<float>(
    [](double distance, std::size_t index) { return 100 * blurredSphere(distance, 15) + 5 * noise(index); });
  values[1000] = std::numeric_limits<float>::quiet_NaN();
  const auto whole = suggestAll(values);
  ASSERT_FALSE(whole.empty());
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
    const auto parts = ink::suggestIsoValues(read, cube, atOnce);
    ASSERT_EQ(parts.size(), whole.size()) << atOnce;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      EXPECT_EQ(parts[i].value, whole[i].value) << atOnce;
      EXPECT_EQ(parts[i].boundary, whole[i].boundary) << atOnce;
      EXPECT_EQ(parts[i].keptShare, whole[i].keptShare) << atOnce;
    }
    EXPECT_LE(most, atOnce);
  }
}

TEST(IsoStatistics, OfSomeSlicesHaveTheSharesAndMeanStepsOfAll)
{
  const auto values = volume<short>([](double distance, std::size_t index)
    { return 1000 * blurredSphere(distance, 15) + 20 * noise(index); });
  int reads = 0;
  const ink::SliceReader<short> read = [&](int first, int last)
  {
    ++reads;
    return std::span(values).subspan(first * size * size, (last - first) * size * size);
  };
  const auto all = ink::makeIsoStatistics(read, cube, size);
  ASSERT_TRUE(all);
  const auto sum = [](const std::vector<std::int64_t>& counts)
  { return std::accumulate(counts.begin(), counts.end(), std::int64_t{ 0 }); };
  EXPECT_EQ(sum(all->voxels), size * size * size);
  const std::size_t middle = all->voxels.size() / 2;
  // As often as 32 slices that count at least allow: two of three voxels may be left out, and none are.
  const auto least = ink::makeIsoStatistics(read, cube, size, 1);
  ASSERT_TRUE(least);
  EXPECT_EQ(least->voxels, all->voxels);

  const std::array<int, 3> twice{ size, size / 4, 4 * size };
  const auto every = ink::makeIsoStatistics(
    ink::SliceReader<short>([&](int first, int last)
      { return std::span(values).subspan(first * size * size / 4, (last - first) * size * size / 4); }),
    twice, 4 * size);
  ASSERT_TRUE(every);
  for (const int atOnce : { 3, 7, 4 * size })
  {
    const auto some = ink::makeIsoStatistics(
      ink::SliceReader<short>([&](int first, int last)
        { return std::span(values).subspan(first * size * size / 4, (last - first) * size * size / 4); }),
      twice, atOnce, size * size * size / 5);
    ASSERT_TRUE(some);
    EXPECT_EQ(some->bins.low, every->bins.low);
    EXPECT_EQ(some->bins.count, every->bins.count);
    const std::int64_t counted = sum(some->voxels);
    // Every fifth of 192 slices, from the third on.
    EXPECT_EQ(counted, 38 * size * size / 4) << atOnce;
    const double share = static_cast<double>(counted) / (size * size * size);
    EXPECT_NEAR(some->edges[middle] / share / every->edges[middle], 1.0, 0.1) << atOnce;
    const auto meanStep = [middle](const ink::IsoStatistics& statistics)
    { return static_cast<double>(statistics.steps[middle]) / static_cast<double>(statistics.edges[middle]); };
    EXPECT_NEAR(meanStep(*some) / meanStep(*every), 1.0, 0.05) << atOnce;
  }
}

TEST(IsoValue, RefusesSlicesOfAnotherSize)
{
  const std::vector<float> values(7);
  const ink::SliceReader<float> read = [&](int, int) { return std::span<const float>(values); };
  EXPECT_THROW(ink::suggestIsoValues(read, cube, 3), std::invalid_argument);
  EXPECT_THROW(ink::suggestIsoValues(read, cube, 2), std::invalid_argument);
}

} // namespace
