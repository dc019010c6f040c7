// SPDX-License-Identifier: BSD-3-Clause
// Slices that others were interpolated between: found however far apart they are, where they were; nothing
// where none were.
#include "Statistics/InterpolatedSlices.h"

#include "Fields/Grid/GridField.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace
{

template <class T>
struct Grid
{
  glm::ivec3 size;
  std::vector<T> values;

  template <class Of>
  Grid(const glm::ivec3& dimensions, const Of& of)
    : size(dimensions)
  {
    for (int z = 0; z < this->size.z; ++z)
    {
      for (int y = 0; y < this->size.y; ++y)
      {
        for (int x = 0; x < this->size.x; ++x)
        {
          this->values.push_back(static_cast<T>(of(glm::ivec3(x, y, z))));
        }
      }
    }
  }

  T at(const glm::ivec3& p) const
  {
    return this->values[static_cast<std::size_t>(p.x + this->size.x * (p.y + this->size.y * p.z))];
  }
  std::array<ink::OriginalSamples, 3> find(const glm::dvec3& spacing = glm::dvec3(1.0)) const
  {
    return ink::findInterpolatedSlices(
      ink::GridField<T>({ this->size, glm::dvec3(0.0), spacing }, this->values));
  }
};

/// A lump with bays and bumps, bright on dark, with a gradual edge of about a sample; noise is added where
/// it is scanned.
double valueOfLump(const glm::dvec3& p, const glm::dvec3& size)
{
  const glm::dvec3 away = 2.2 * (p / size - 0.5);
  const double bumps = 0.08 * std::sin(9.0 * away.x) * std::sin(8.0 * away.y + 1.0) * std::cos(7.0 * away.z);
  const double radius = glm::length(away) + bumps;
  return 1000.0 / (1.0 + std::exp(0.4 * size.x * (radius - 0.8)));
}

/// From -17 to 17, the same each time.
double noiseAt(const glm::ivec3& place)
{
  std::uint32_t bits = static_cast<std::uint32_t>(place.x) * 73856093U ^
    static_cast<std::uint32_t>(place.y) * 19349663U ^ static_cast<std::uint32_t>(place.z) * 83492791U;
  bits = (bits ^ (bits >> 16)) * 0x45d9f3bU;
  bits ^= bits >> 16;
  return 34.0 * (bits & 0xffffU) / 0xffff - 17.0;
}

/// The lump as a scan has it in slices `step` apart, the first at `first`, brought to all samples along an
/// axis by linear interpolation, or by cubic one.
/// @param slope by how much slices rise towards the next samples of the following axis
template <class T>
Grid<T> makeInterpolated(
  const glm::ivec3& size, int axis, double step, double first, double slope = 0.0, bool cubic = false)
{
  const auto scanned = [&](glm::ivec3 place, int slice)
  {
    glm::dvec3 p(place);
    const double rise = slope * (p[(axis + 1) % 3] - 0.5 * size[(axis + 1) % 3]);
    p[axis] = first + slice * step + rise;
    place[axis] = slice;
    return valueOfLump(p, size) + noiseAt(place);
  };
  return Grid<T>(size,
    [&](const glm::ivec3& p)
    {
      const double rise = slope * (p[(axis + 1) % 3] - 0.5 * size[(axis + 1) % 3]);
      const double place = (p[axis] - first - rise) / step;
      const int below = static_cast<int>(std::floor(place));
      const double t = place - below;
      if (!cubic)
      {
        return (1.0 - t) * scanned(p, below) + t * scanned(p, below + 1);
      }
      const std::array weights = { t * (-0.5 + t * (1.0 - 0.5 * t)), 1.0 + t * t * (-2.5 + 1.5 * t),
        t * (0.5 + t * (2.0 - 1.5 * t)), t * t * (-0.5 + 0.5 * t) };
      double sum = 0.0;
      for (int i = 0; i < 4; ++i)
      {
        sum += weights[static_cast<std::size_t>(i)] * scanned(p, below - 1 + i);
      }
      return sum;
    });
}

template <class T>
void expectNothing(const Grid<T>& grid, const char* what, const glm::dvec3& spacing = glm::dvec3(1.0))
{
  const std::array found = grid.find(spacing);
  for (int axis = 0; axis < 3; ++axis)
  {
    const ink::OriginalSamples& one = found[static_cast<std::size_t>(axis)];
    EXPECT_EQ(one.step, 1.0) << what << ", axis " << axis;
    EXPECT_EQ(one.first, 0.0) << what << ", axis " << axis;
    EXPECT_EQ(one.count, grid.size[axis]) << what << ", axis " << axis;
  }
}

} // namespace

TEST(InterpolatedSlices, AreFoundAlongEachAxis)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::ivec3 size(72);
    size[axis] = 96;
    const std::array found = makeInterpolated<std::int16_t>(size, axis, 5.0, 2.0).find();
    for (int other = 0; other < 3; ++other)
    {
      const ink::OriginalSamples& one = found[static_cast<std::size_t>(other)];
      EXPECT_NEAR(one.step, other == axis ? 5.0 : 1.0, 0.02) << axis << other;
      EXPECT_EQ(one.count, other == axis ? 19 : 72) << axis << other;
    }
    // They are the slices themselves.
    const std::vector<int> indices = found[static_cast<std::size_t>(axis)].indices(96);
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      EXPECT_EQ(indices[i], 2 + 5 * static_cast<int>(i)) << axis;
    }
  }
}

TEST(InterpolatedSlices, StepsNeedNotBeWhole)
{
  for (const double step : { 2.25, 7.0 / 3.0, 2.5, 2.6, 3.0, 10.0 / 3.0, 3.5, 4.5, 5.27, 7.0, 8.0 })
  {
    for (const bool cubic : { false, true })
    {
      const double first = 0.3 * step;
      const ink::OriginalSamples found =
        makeInterpolated<float>({ 48, 48, 130 }, 2, step, first, 0.0, cubic).find()[2];
      EXPECT_NEAR(found.step, step, 0.02 * step) << cubic;
      // Half a slice is as far off as it could be.
      const double off = (found.first - first) / step;
      EXPECT_NEAR(off, std::round(off), 0.2) << step << cubic;
      for (const int index : found.indices(130))
      {
        EXPECT_GE(index, 0);
        EXPECT_LT(index, 130);
      }
      const double last = found.first + (found.count - 1) * found.step;
      EXPECT_GT(last, 129.0 - 0.76 * step);
      EXPECT_LT(last, 129.0 + 0.26 * step);
      EXPECT_GT(found.first, -0.26 * step);
      EXPECT_LT(found.first, 0.76 * step);
    }
  }
}

TEST(InterpolatedSlices, MayBeOblique)
{
  for (const double degrees : { 1.0, 3.0, 5.0 })
  {
    const double slope = std::tan(degrees * glm::pi<double>() / 180.0);
    const ink::OriginalSamples found = makeInterpolated<float>({ 72, 72, 130 }, 2, 5.0, 0.0, slope).find()[2];
    EXPECT_NEAR(found.step, 5.0, 0.1) << degrees;
  }
}

TEST(InterpolatedSlices, OfAnyType)
{
  const glm::ivec3 size(64, 64, 80);
  EXPECT_NEAR(makeInterpolated<std::int16_t>(size, 2, 4.0, 0.0).find()[2].step, 4.0, 0.02);
  EXPECT_NEAR(makeInterpolated<std::int64_t>(size, 2, 4.0, 0.0).find()[2].step, 4.0, 0.02);
  EXPECT_NEAR(makeInterpolated<double>(size, 2, 4.0, 0.0).find()[2].step, 4.0, 0.02);
}

TEST(InterpolatedSlices, BehindAMask)
{
  Grid<float> grid = makeInterpolated<float>({ 80, 80, 120 }, 2, 5.0, 1.0);
  // One that was made on the fine grid, whose edge is sharp; what is missing is none, either.
  for (int z = 0; z < 120; ++z)
  {
    for (int y = 0; y < 80; ++y)
    {
      for (int x = 0; x < 80; ++x)
      {
        const double radius = std::hypot((x - 40) / 30.0, (y - 40) / 30.0, (z - 60) / 45.0);
        float& value = grid.values[static_cast<std::size_t>(x + 80 * (y + 80 * z))];
        value = radius > 1.2 ? std::numeric_limits<float>::quiet_NaN() : radius > 1.0 ? -500.0F : value;
      }
    }
  }
  EXPECT_NEAR(grid.find()[2].step, 5.0, 0.05);
}

TEST(InterpolatedSlices, AreNoneOfOthers)
{
  const glm::ivec3 size(80, 80, 120);
  std::minstd_rand random;
  std::normal_distribution<double> noise(0.0, 10.0);
  const auto radiusOf = [](const glm::ivec3& p) { return std::hypot(p.x - 39.5, p.y - 39.5); };
  const auto insideOf = [](double distance) { return 1000.0 / (1.0 + std::exp(-1.5 * distance)); };
  expectNothing(Grid<float>(size, [&](const glm::ivec3& p) { return valueOfLump(p, size) + noise(random); }),
    "a scan without them");
  expectNothing(Grid<float>(size, [&](const glm::ivec3&) { return noise(random); }), "noise");
  expectNothing(Grid<float>(size, [&](const glm::ivec3&) { return 3.0; }), "one value");
  expectNothing(
    Grid<float>(size, [&](const glm::ivec3& p) { return insideOf(25.0 - radiusOf(p)) + noise(random); }),
    "a rod");
  expectNothing(Grid<float>(size, [&](const glm::ivec3& p) { return insideOf(25.0 - radiusOf(p)); }),
    "a rod without noise");
  expectNothing(Grid<float>(size,
                  [&](const glm::ivec3& p)
                  {
                    const double angle = std::atan2(p.y - 39.5, p.x - 39.5);
                    return insideOf(25.0 + 1.5 * std::sin(p.z + angle) - radiusOf(p)) + noise(random);
                  }),
    "a screw whose thread rises by 6.3 samples");
  expectNothing(Grid<float>(size,
                  [&](const glm::ivec3& p)
                  { return insideOf(25.0 + std::sin(0.9 * p.z) - radiusOf(p)) + noise(random); }),
    "a hose with rings every 7 samples");
  expectNothing(Grid<float>(size,
                  [&](const glm::ivec3& p) { return 500.0 + 100.0 * std::cos(1.2 * p.z) + noise(random); }),
    "layers");
  expectNothing(Grid<std::uint8_t>(
                  size, [&](const glm::ivec3& p) { return valueOfLump(p, size) > 500.0 ? 1 + p.z / 40 : 0; }),
    "labels");
  expectNothing(Grid<std::uint8_t>(size,
                  [&](glm::ivec3 p)
                  {
                    p.z = p.z / 5 * 5;
                    return valueOfLump(p, size) / 4.0;
                  }),
    "slices that are repeated");
}

TEST(InterpolatedSlices, ThatAreNotThickStay)
{
  const Grid<float> grid = makeInterpolated<float>({ 64, 64, 120 }, 2, 4.0, 0.0);
  EXPECT_GT(grid.find({ 1.0, 1.0, 0.5 })[2].step, 3.9);
  expectNothing(grid, "slices as far apart as samples", { 1.0, 1.0, 0.25 });
  EXPECT_GT(grid.find({ 1.0, -1.0, -1.0 })[2].step, 3.9) << "mirrored";
}

TEST(InterpolatedSlices, SmallGridsHaveNone)
{
  for (const int side : { 1, 2, 3, 5, 20 })
  {
    expectNothing(makeInterpolated<float>(glm::ivec3(side), 2, 3.0, 0.0), "a small grid");
    expectNothing(makeInterpolated<float>({ 64, 64, side }, 2, 3.0, 0.0), "few slices");
    expectNothing(makeInterpolated<float>({ side, 64, 64 }, 0, 3.0, 0.0), "few columns");
  }
  expectNothing(Grid<float>(glm::ivec3(30), [](const glm::ivec3&) { return std::nan(""); }), "missing");
  expectNothing(Grid<double>(glm::ivec3(30),
                  [](const glm::ivec3& p)
                  { return (p.x + p.y + p.z) % 2 ? std::numeric_limits<double>::max() : -1e308; }),
    "values too large to subtract");
}
