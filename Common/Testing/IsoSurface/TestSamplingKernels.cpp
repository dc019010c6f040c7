// SPDX-License-Identifier: BSD-3-Clause
// The loops of iso-surface sampling: the same bits from every instruction set, single precision against
// double, and several surfaces in one pass against one after the other.

#include "AnalyticFields.h"
#include "BitHash.h"
#include "Fields/Grid/GridField.h"
#include "IsoSurface/MinMaxBricks.h"
#include "SampledVolume.h"
#include "UseKernels.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::Arithmetic;
using ink::CrossingRule;
using ink::GridGeometry;
using ink::NormalMethod;
using ink::SampleOptions;

constexpr NormalMethod Methods[] = { NormalMethod::Cell, NormalMethod::InterpolatedGradient,
  NormalMethod::InterpolatedNormal, NormalMethod::Regression };

/// Random bumps, with many samples at the same values, plateaus, and surfaces that run into every border.
template <class T>
Volume<T> bumps(const GridGeometry& geometry, unsigned seed)
{
  std::mt19937 random(seed);
  Volume<T> volume(geometry);
  for (T& value : volume.values)
  {
    value = static_cast<T>(random() % 100 < 30 ? 50 : random() % 101);
  }
  return volume;
}

const glm::dmat3 rotation(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, -2.0, 0.5)));

template <class T>
void expectSameBits(const ink::SamplingKernels& kernels)
{
  const GridGeometry grids[] = { GridGeometry({ 77, 8, 6 }),
    GridGeometry({ 33, 9, 7 }, { 1, 2, 3 }, { 0.5, 0.7, 2.5 }),
    GridGeometry({ 66, 6, 7 }, { 1, 2, 3 }, { 0.5, 1.0, 2.5 }, rotation) };
  for (const GridGeometry& grid : grids)
  {
    auto volume = bumps<T>(grid, 7);
    if constexpr (std::is_floating_point_v<T>)
    {
      volume.values[500] = std::numeric_limits<T>::quiet_NaN();
      volume.values[900] = std::numeric_limits<T>::infinity();
    }
    for (const CrossingRule rule : { CrossingRule::HalfOpen, CrossingRule::Strict })
    {
      for (const NormalMethod method : Methods)
      {
        for (const double isoValue : { 50.0, 73.25 })
        {
          const SampleOptions options{ rule, method, Arithmetic::Single };
          const auto sample = [&](const ink::SamplingKernels* with)
          {
            const UseKernels use(with);
            return std::pair(sampleIsoSurface<float>(volume.field(), isoValue, options),
              sampleIsoSurface<double>(volume.field(), isoValue, options));
          };
          const auto expected = sample(ink::samplingKernelsOf("baseline"));
          EXPECT_GT(expected.first.size(), 500u);
          // Not EXPECT_EQ, which would print them all.
          EXPECT_TRUE(sample(&kernels) == expected)
            << "iso-value " << isoValue << ", normal method " << static_cast<int>(method);
        }
      }
    }
  }
}

TEST(SamplingKernels, GiveTheSameBitsForEachInstructionSet)
{
  int found = 0;
  for (const char* name : { "avx2", "avx512" })
  {
    if (const ink::SamplingKernels* kernels = ink::samplingKernelsOf(name))
    {
      ++found;
      SCOPED_TRACE(name);
      EXPECT_STREQ(kernels->name, name);
      expectSameBits<unsigned char>(*kernels);
      expectSameBits<signed char>(*kernels);
      expectSameBits<unsigned short>(*kernels);
      expectSameBits<short>(*kernels);
      expectSameBits<int>(*kernels);
      expectSameBits<unsigned long long>(*kernels);
      expectSameBits<float>(*kernels);
      expectSameBits<double>(*kernels);
    }
  }
  EXPECT_EQ(ink::samplingKernelsOf("pentium"), nullptr);
  if (found == 0)
  {
    GTEST_SKIP() << "this machine, or this build, has the baseline only";
  }
}

TEST(SamplingKernels, GiveTheSameBitsOnEveryProcessor)
{
  // A rotation whose elements no library computes.
  const glm::dmat3 turned = glm::dmat3(2, -1, 2, 2, 2, -1, -1, 2, 2) / 3.0;
  const GridGeometry cubic({ 40, 9, 8 });
  const GridGeometry general({ 40, 9, 8 }, { 1, 2, 3 }, { 0.5, 1.0, 2.5 }, turned);
  const auto bytes = bumps<unsigned char>(cubic, 11);
  const auto shorts = bumps<short>(general, 12);
  const auto floats = bumps<float>(cubic, 13);
  std::vector<float> all;
  const auto add = [&](const auto& volume, const SampleOptions& options)
  {
    const auto samples = sampleIsoSurface<float>(volume.field(), 73.25, options);
    EXPECT_GT(samples.size(), 500u);
    all.insert(all.end(), samples.coordinates.begin(), samples.coordinates.end());
    all.insert(all.end(), samples.components.begin(), samples.components.end());
  };
  for (const NormalMethod method : Methods)
  {
    for (const Arithmetic arithmetic : { Arithmetic::Single, Arithmetic::Double })
    {
      const SampleOptions options{ CrossingRule::HalfOpen, method, arithmetic };
      add(bytes, options);
      add(shorts, options);
      add(floats, options);
    }
  }
  // What x86-64 gave.
  EXPECT_EQ(bitHash(all), 5073930552069591884u);
}

/// The largest differences of points, in voxels, and of normals, in radians, between single and double.
struct Differences
{
  double point = 0.0;
  double normal = 0.0;
};

template <class T>
Differences singleAgainstDouble(const ink::GridField<T>& field, double isoValue, NormalMethod method)
{
  const auto rough =
    sampleIsoSurface<float>(field, isoValue, { CrossingRule::HalfOpen, method, Arithmetic::Single });
  const auto exact =
    sampleIsoSurface<double>(field, isoValue, { CrossingRule::HalfOpen, method, Arithmetic::Double });
  Differences largest;
  EXPECT_EQ(rough.size(), exact.size());
  EXPECT_GT(exact.size(), 1000u);
  for (std::size_t n = 0; n < std::min(rough.size(), exact.size()); ++n)
  {
    largest.point = std::max(largest.point, glm::distance(rough.point(n), exact.point(n)));
    largest.normal = std::max(largest.normal, glm::length(glm::cross(rough.normal(n), exact.normal(n))));
  }
  return largest;
}

/// Bits and ranges of rows of every length against one sample after the other, with the bytes before and
/// after the rows out of reach of both.
template <class T>
void expectRowsOfAnyLength(const ink::TypedKernels<T>& kernels)
{
  constexpr int brick = ink::BrickLength<T>;
  std::mt19937 random(3);
  for (int length = 1; length <= 200; ++length)
  {
    for (int rows = 1; rows <= ink::BrickWidth; ++rows)
    {
      std::vector<T> samples(static_cast<std::size_t>(length) * rows);
      for (T& sample : samples)
      {
        sample = static_cast<T>(random() % 101);
      }
      const bool broken = std::is_floating_point_v<T> && length % 7 == 0;
      if (broken)
      {
        samples[samples.size() - 1] = std::numeric_limits<T>::quiet_NaN();
      }
      const T lowest = static_cast<T>(length % 3 == 0 ? 0 : 97);
      const std::ptrdiff_t reach = (length + 63) / 64 + 1;
      const int bricks = (length + brick - 1) / brick;
      const ink::RowBlock<T> block{ samples.data(), length, rows, length, 0 };
      std::vector<std::uint64_t> expected(static_cast<std::size_t>(reach) * rows);
      int flags = broken ? ink::MaybeMissing : 0;
      std::vector<T> lows(bricks, std::numeric_limits<T>::max());
      std::vector<T> highs(bricks, std::numeric_limits<T>::lowest());
      for (int r = 0; r < rows; ++r)
      {
        for (int i = 0; i < length; ++i)
        {
          const T sample = samples[static_cast<std::size_t>(r) * length + i];
          expected[r * reach + i / 64] |= std::uint64_t(sample >= lowest) << i % 64;
          flags |= sample >= lowest ? ink::SomeSet : ink::SomeClear;
          lows[i / brick] = std::min(lows[i / brick], sample);
          highs[i / brick] = std::max(highs[i / brick], sample);
        }
      }
      std::vector<std::uint64_t> words(expected.size());
      EXPECT_EQ(kernels.classify(block, lowest, words.data(), reach), flags) << length;
      EXPECT_EQ(words, expected) << length << " samples, " << rows << " rows";
      std::vector<T> low(bricks);
      std::vector<T> high(bricks);
      std::fill(words.begin(), words.end(), 0);
      EXPECT_EQ(
        kernels.classifyAndMeasure(block, lowest, words.data(), reach, low.data(), high.data()), flags);
      EXPECT_EQ(words, expected) << length << " samples, " << rows << " rows";
      for (int b = 0; b < bricks; ++b)
      {
        const bool unknown = broken && b == bricks - 1;
        EXPECT_TRUE(unknown ? low[b] != low[b] : low[b] == lows[b]) << length << ", brick " << b;
        EXPECT_TRUE(unknown ? high[b] != high[b] : high[b] == highs[b]) << length << ", brick " << b;
      }
      // All bricks mixed, as far as anyone knows.
      const std::vector<std::uint8_t> states(bricks, 2);
      std::fill(words.begin(), words.end(), 0);
      EXPECT_EQ(kernels.classifyMixed(block, lowest, states.data(), words.data(), reach), flags);
      EXPECT_EQ(words, expected) << length << " samples, " << rows << " rows";
    }
  }
}

TEST(SamplingKernels, TakeRowsOfAnyLength)
{
  for (const char* name : { "baseline", "avx2", "avx512" })
  {
    if (const ink::SamplingKernels* kernels = ink::samplingKernelsOf(name))
    {
      SCOPED_TRACE(name);
      expectRowsOfAnyLength(kernels->u8);
      expectRowsOfAnyLength(kernels->i16);
      expectRowsOfAnyLength(kernels->i32);
      expectRowsOfAnyLength(kernels->f32);
      expectRowsOfAnyLength(kernels->f64);
    }
  }
}

TEST(SamplingKernels, AreAsGoodInSinglePrecision)
{
  const Sphere sphere{ glm::dvec3(32.1, 31.7, 32.4), 25.0 };
  const Torus torus{ 20.0, 8.0 };
  const GridGeometry grid({ 64, 64, 64 });
  const GridGeometry centered({ 64, 64, 64 }, glm::dvec3(-31.5));
  for (const NormalMethod method : Methods)
  {
    SCOPED_TRACE(static_cast<int>(method));
    // Float's rounding of coordinates up to 64 is 4e-6, and the points' are twice rounded. Weights of normals
    // are known to 3e-5.
    const auto expectClose = [](const Differences& d)
    {
      EXPECT_LT(d.point, 1.5e-5);
      EXPECT_LT(d.normal, 1e-4);
    };
    expectClose(singleAgainstDouble(
      Volume<float>::from(grid, [&](auto p) { return sphere.value(p); }).field(), 0.0, method));
    expectClose(singleAgainstDouble(
      Volume<short>::from(grid, [&](auto p) { return 30000 + 100 * sphere.value(p); }).field(), 30000.3,
      method));
    expectClose(
      singleAgainstDouble(Volume<unsigned char>::from(centered,
                            [&](auto p) { return std::clamp(100 + 9 * torus.value(p), 0.0, 255.0); })
                            .field(),
        100.7, method));
  }
}

TEST(SamplingKernels, HoldForFloatsOfAnySize)
{
  // Gradients whose squares float cannot hold, in the same surface: the same points, the same normals.
  const Sphere sphere{ glm::dvec3(10.1, 9.7, 10.4), 7.0 };
  const auto scaled = [&](double scale)
  {
    const auto volume =
      Volume<float>::from(GridGeometry({ 20, 20, 20 }), [&](auto p) { return scale * sphere.value(p); });
    return sampleIsoSurface<float>(volume.field(), 0.0, SampleOptions{});
  };
  const auto expected = scaled(1.0);
  ASSERT_GT(expected.size(), 100u);
  for (const double scale : { 0x1p-120, 0x1p-80, 0x1p-60, 0x1p60, 0x1p100, 0x1p120 })
  {
    const auto samples = scaled(scale);
    ASSERT_EQ(samples.size(), expected.size()) << scale;
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      EXPECT_LT(glm::distance(samples.point(n), expected.point(n)), 1e-5) << scale;
      EXPECT_LT(glm::distance(samples.normal(n), expected.normal(n)), 1e-4) << scale;
    }
  }
}

/// Everything that sampleIsoSurfaces writes.
struct Written
{
  std::vector<float> points;
  std::vector<float> normals;
  std::vector<std::int8_t> bytes;
  std::vector<std::size_t> counts;

  bool operator==(const Written&) const = default;
};

template <class T>
Written sampleAll(const ink::GridField<T>& field, const std::vector<double>& isoValues, std::size_t expected,
  ink::MinMaxBricks* ranges = nullptr)
{
  Written written;
  const auto grow = [&](std::size_t count)
  {
    written.points.resize(std::max(written.points.size(), 3 * count));
    written.normals.resize(written.points.size());
    written.bytes.resize(written.points.size());
    return ink::SampleRoom{ written.points.data(), nullptr, written.normals.data(), nullptr,
      written.bytes.data(), written.points.size() / 3 };
  };
  EXPECT_TRUE(ink::sampleIsoSurfaces(field, isoValues, {}, {}, ranges, grow, expected, written.counts));
  std::size_t total = 0;
  for (const std::size_t count : written.counts)
  {
    total += count;
  }
  written.points.resize(3 * total);
  written.normals.resize(3 * total);
  written.bytes.resize(3 * total);
  return written;
}

TEST(SamplingKernels, SampleSeveralSurfacesAsOneByOne)
{
  const auto volume = bumps<unsigned char>(GridGeometry({ 70, 21, 37 }), 3);
  const std::vector<double> isoValues = { 30.0, 50.0, 90.5, 300.0, std::numeric_limits<double>::quiet_NaN(),
    50.0 };
  ink::MinMaxBricks ranges;
  const Written together = sampleAll(volume.field(), isoValues, 0, &ranges);
  EXPECT_TRUE(sampleAll(volume.field(), isoValues, 0, &ranges) == together);
  ASSERT_EQ(together.counts.size(), isoValues.size());
  Written oneByOne;
  for (const double isoValue : isoValues)
  {
    const Written one = sampleAll(volume.field(), { isoValue }, 1000000);
    oneByOne.points.insert(oneByOne.points.end(), one.points.begin(), one.points.end());
    oneByOne.normals.insert(oneByOne.normals.end(), one.normals.begin(), one.normals.end());
    oneByOne.bytes.insert(oneByOne.bytes.end(), one.bytes.begin(), one.bytes.end());
    oneByOne.counts.push_back(one.counts.front());
  }
  EXPECT_TRUE(together == oneByOne);
  EXPECT_GT(together.counts[1], 20000u);
  EXPECT_EQ(together.counts[1], together.counts[5]);
  EXPECT_EQ(together.counts[3] + together.counts[4], 0u);
  // And as in two passes.
  const auto twice = sampleIsoSurface<float>(volume.field(), 30.0);
  EXPECT_TRUE(std::equal(twice.coordinates.begin(), twice.coordinates.end(), together.points.begin()));
  EXPECT_TRUE(std::equal(twice.components.begin(), twice.components.end(), together.normals.begin()));
  for (std::size_t n = 0; n < together.normals.size(); ++n)
  {
    EXPECT_LE(std::abs(together.bytes[n] - 127.0f * together.normals[n]), 0.5001f);
  }
}

TEST(SamplingKernels, DependOnNeitherThreadsNorTheRoomThatWasExpected)
{
  const auto volume = bumps<short>(GridGeometry({ 50, 20, 90 }), 5);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const Written expected = sampleAll(volume.field(), { 40.0 }, 10000000);
  EXPECT_GT(expected.points.size(), 100000u);
  for (const char* threads : { "1", "2", "5" })
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    for (const std::size_t room : { std::size_t(0), std::size_t(20000), std::size_t(1000000) })
    {
      EXPECT_TRUE(sampleAll(volume.field(), { 40.0 }, room) == expected)
        << threads << " threads, room for " << room;
    }
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}

} // namespace
