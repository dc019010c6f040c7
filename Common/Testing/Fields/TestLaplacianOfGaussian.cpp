// SPDX-License-Identifier: BSD-3-Clause
#include "SampledVolume.h"

#include "AnalyticFields.h"
#include "EstimatedGradients.h"
#include "Fields/Derivatives/LaplacianOfGaussian.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"
#include "HashNoise.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace
{

using namespace ink::testing;
using ink::ScaleUnit;
const double nan = std::numeric_limits<double>::quiet_NaN();
const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -0.5))));
const glm::dmat3 sheared(1.0, 0.0, 0.0, 0.3, 1.0, 0.0, -0.2, 0.4, 1.0);

template <class Real = double, class T>
std::vector<Real> laplacianOf(
  const ink::GridField<T>& field, double scale, ScaleUnit unit, const ink::SampleBox& box)
{
  std::vector<Real> result(box.count());
  ink::laplacianOfGaussian<T, Real>(
    field, box, ink::gaussianInSamples(field.geometry(), scale, unit), result);
  return result;
}

template <class Real = double, class T>
std::vector<Real> laplacianOf(
  const ink::GridField<T>& field, double scale, ScaleUnit unit = ScaleUnit::Samples)
{
  return laplacianOf<Real>(field, scale, unit, { glm::ivec3(0), field.geometry().dimensions() });
}

double quadratic(const glm::dvec3& p)
{
  return 1.0 + 2.0 * p.x - p.y + 0.5 * p.z + p.x * p.x - 0.5 * p.y * p.y + 0.25 * p.z * p.z +
    0.75 * p.x * p.y - 0.5 * p.y * p.z + 1.5 * p.x * p.z;
}
constexpr double quadraticLaplacian = 2.0 - 1.0 + 0.5;

TEST(LaplacianOfGaussian, RoundsWideIntegersToDoubles)
{
  for (const std::int64_t base : { std::int64_t(1) << 52, std::int64_t(1) << 60, -(std::int64_t(1) << 60) })
  {
    std::uint64_t index = 0;
    auto volume = Volume<std::int64_t>::from(ink::GridGeometry({ 9, 9, 9 }),
      [&](const glm::dvec3&) { return base + static_cast<std::int64_t>(hashNormal(3, index++) * 100.0); });
    const std::vector<double> laplacian = laplacianOf(volume.field(), 0.0);
    double largest = 0.0;
    for (int k = 1; k < 8; ++k)
    {
      for (int j = 1; j < 8; ++j)
      {
        for (int i = 1; i < 8; ++i)
        {
          const auto at = [&](int x, int y, int z) { return volume.at({ x, y, z }) - base; };
          const std::int64_t exact = at(i - 1, j, k) + at(i + 1, j, k) + at(i, j - 1, k) + at(i, j + 1, k) +
            at(i, j, k - 1) + at(i, j, k + 1) - 6 * at(i, j, k);
          largest = std::max(largest, std::abs(laplacian[i + 9 * (j + 9 * k)] - static_cast<double>(exact)));
        }
      }
    }
    const double size = std::abs(static_cast<double>(base));
    EXPECT_LE(largest, size < 0x1p53 ? 0.0 : 12.0 * size * 0x1p-53) << base;
    EXPECT_TRUE(size < 0x1p53 || largest > 0.0) << base;
  }
}

TEST(LaplacianOfGaussian, IsExactForQuadraticsUpToTheBorder)
{
  const glm::ivec3 n(14, 13, 12);
  for (const ink::GridGeometry& g :
    { ink::GridGeometry(n), ink::GridGeometry(n, { 5, -3, 2 }, { 0.5, 0.25, 2.0 }),
      ink::GridGeometry(n, { 1, 2, 3 }, { -1.0, 0.7, 3.0 }, turned),
      ink::GridGeometry(n, { 0, 0, 0 }, { 1.0, 1.5, 0.5 }, sheared) })
  {
    const auto volume = Volume<double>::from(g, quadratic);
    for (const double scale : { 0.0, 0.3, 0.5, 1.0, 2.0, 16.0 })
    {
      for (const ScaleUnit unit : { ScaleUnit::Samples, ScaleUnit::World })
      {
        for (const double value : laplacianOf(volume.field(), scale, unit))
        {
          ASSERT_NEAR(value, quadraticLaplacian, 1e-6) << "scale " << scale;
        }
      }
    }
  }
}

TEST(LaplacianOfGaussian, OfConstantsAndPlanesIsZero)
{
  const ink::GridGeometry g({ 20, 18, 17 }, { 0, 0, 0 }, { 1.0, 0.7, 2.0 }, turned);
  for (const double value : laplacianOf<float>(Volume<float>(g, 1234.567f).field(), 1.3))
  {
    ASSERT_NEAR(value, 0.0, 1e-11);
  }
  const auto plane = Volume<double>::from(g, [](const glm::dvec3& p) { return p.x - 2 * p.y + p.z; });
  for (const double value : laplacianOf(plane.field(), 1.0))
  {
    ASSERT_NEAR(value, 0.0, 1e-10);
  }
}

TEST(LaplacianOfGaussian, IsThatOfTheSmoothedField)
{
  // A Gaussian blob smoothed by a Gaussian is a wider one: variances add up, and its Laplacian is known.
  const double own = 3.0;
  for (const glm::dvec3& spacing : { glm::dvec3(1.0), glm::dvec3(0.5, 1.0, 1.25) })
  {
    const glm::ivec3 n = glm::ivec3(32.0 / spacing);
    const ink::GridGeometry g(n, turned * (-0.5 * glm::dvec3(n - 1) * spacing), spacing, turned);
    const auto volume = Volume<double>::from(
      g, [&](const glm::dvec3& p) { return std::exp(-glm::dot(p, p) / (2 * own * own)); });
    for (const double scale : { 1.0, 1.5, 2.0 })
    {
      const auto result = laplacianOf(volume.field(), scale, ScaleUnit::World);
      const double variance = own * own + scale * scale;
      const double peak = std::pow(own * own / variance, 1.5);
      const double strongest = 3.0 * peak / variance;
      const ink::SampleBox box = inside(g, 8);
      forEachSample(box,
        [&](const glm::ivec3& s)
        {
          const glm::dvec3 p = g.toWorld(s);
          const double square = glm::dot(p, p);
          const double expected =
            peak * std::exp(-square / (2 * variance)) * (square / variance - 3.0) / variance;
          ASSERT_NEAR(result[g.offset(s)], expected, 0.01 * strongest) << "scale " << scale;
        });
    }
  }
}

TEST(LaplacianOfGaussian, CrossesZeroOnAnEdgeInNoise)
{
  // 2 / r is the Laplacian of a sphere's distance; across a blurred edge it changes its sign.
  const Sphere sphere{ glm::dvec3(0.0), 12.0 };
  const ink::GridGeometry g({ 40, 40, 40 }, glm::dvec3(-19.5));
  std::uint64_t index = 0;
  const auto volume = Volume<float>::from(
    g, [&](const glm::dvec3& p) { return (sphere.value(p) < 0.0) + 0.05 * hashNormal(3, index++); });
  const auto share = [&](double scale)
  {
    const auto result = laplacianOf<float>(volume.field(), scale);
    int right = 0;
    int count = 0;
    forEachSample(inside(g, 1),
      [&](const glm::ivec3& s)
      {
        const double d = sphere.value(g.toWorld(s));
        if (std::abs(d) > 0.7 && std::abs(d) < 2.5)
        {
          right += (result[g.offset(s)] > 0.0f) == (d > 0.0);
          ++count;
        }
      });
    return static_cast<double>(right) / count;
  };
  EXPECT_LT(share(0.0), 0.9);
  EXPECT_GT(share(1.5), 0.99);
}

TEST(LaplacianOfGaussian, UsesTheSamplesThatThereAre)
{
  const ink::GridGeometry g({ 15, 14, 13 }, { 0, 0, 0 }, { 1.0, 0.5, 2.0 }, turned);
  auto volume = Volume<double>::from(g, quadratic);
  const std::vector<glm::ivec3> holes{ { 5, 5, 5 }, { 6, 5, 5 }, { 0, 0, 0 }, { 14, 13, 12 }, { 3, 0, 4 } };
  for (const glm::ivec3& hole : holes)
  {
    volume.at(hole) = nan;
  }
  // A whole row, so that results along x are missing.
  for (int i = 0; i < 15; ++i)
  {
    volume.at({ i, 9, 9 }) = std::numeric_limits<double>::infinity();
  }
  std::vector<std::uint8_t> marks(g.sampleCount(), 1);
  const glm::ivec3 hidden(8, 8, 3);
  marks[g.offset(hidden)] = 3;
  volume.at(hidden) = 1e30;
  for (const double scale : { 0.0, 0.6, 1.0, 2.0 })
  {
    const auto result = laplacianOf(volume.field({ marks, 2 }), scale);
    forEachSample({ { 0, 0, 0 }, g.dimensions() },
      [&](const glm::ivec3& s)
      {
        const bool missing = !std::isfinite(volume.at(s)) || s == hidden;
        const double value = result[g.offset(s)];
        ASSERT_TRUE(std::isfinite(value));
        if (missing)
        {
          ASSERT_EQ(value, 0.0);
        }
        else if (scale == 0.0)
        {
          // Unsmoothed, a parabola through any three samples along an axis is exact.
          ASSERT_NEAR(value, quadraticLaplacian, 1e-8) << s.x << " " << s.y << " " << s.z;
        }
      });
  }
  // Far from the holes they do not matter.
  const auto clean = laplacianOf(Volume<double>::from(g, quadratic).field(), 0.5);
  const auto broken = laplacianOf(volume.field({ marks, 2 }), 0.5);
  EXPECT_EQ(clean[g.offset({ 11, 3, 3 })], broken[g.offset({ 11, 3, 3 })]);
}

TEST(LaplacianOfGaussian, LeavesOutAxesThatHaveNoSecondDerivative)
{
  for (const glm::ivec3& n :
    { glm::ivec3(9, 8, 1), glm::ivec3(9, 8, 2), glm::ivec3(1, 1, 1), glm::ivec3(9, 1, 2) })
  {
    const ink::GridGeometry g(n);
    const auto volume = Volume<double>::from(g, quadratic);
    const double expected = (n.x > 2 ? 2.0 : 0.0) - (n.y > 2 ? 1.0 : 0.0);
    for (const double value : laplacianOf(volume.field(), 0.0))
    {
      ASSERT_NEAR(value, expected, 1e-10);
    }
  }
}

TEST(LaplacianOfGaussian, HoldsForTinyHugeAndVeryUnevenSpacing)
{
  for (const glm::dvec3& spacing :
    { glm::dvec3(1e-9), glm::dvec3(1e9), glm::dvec3(1, 1, 1000), glm::dvec3(1000, 1, 1) })
  {
    const ink::GridGeometry g({ 10, 9, 8 }, { 0, 0, 0 }, spacing);
    Volume<float> volume(g);
    forEachSample(
      { { 0, 0, 0 }, g.dimensions() }, [&](const glm::ivec3& s) { volume.at(s) = s.x * s.x + s.z * s.z; });
    const double expected = 2.0 / spacing.x / spacing.x + 2.0 / spacing.z / spacing.z;
    for (const double scale : { 0.0, 1.0 })
    {
      for (const float value : laplacianOf<float>(volume.field(), scale))
      {
        ASSERT_NEAR(value / expected, 1.0, 1e-5);
      }
      // World units: a Gaussian as wide as the smallest spacing, and one far wider than the grid.
      const double smallest = std::min({ spacing.x, spacing.y, spacing.z });
      for (const double width : { smallest, 1e6 * smallest })
      {
        for (const float value : laplacianOf<float>(volume.field(), width, ScaleUnit::World))
        {
          ASSERT_NEAR(value / expected, 1.0, 1e-5);
        }
      }
    }
  }
}

template <class T>
void expectLimits()
{
  using Limits = std::numeric_limits<T>;
  Volume<T> volume(ink::GridGeometry({ 9, 8, 8 }), Limits::lowest());
  forEachSample({ { 4, 0, 0 }, { 9, 8, 8 } }, [&](const glm::ivec3& s) { volume.at(s) = Limits::max(); });
  const double range = 0.5 * static_cast<double>(Limits::max()) - 0.5 * static_cast<double>(Limits::lowest());
  for (const double scale : { 0.0, 1.0 })
  {
    for (const float value : laplacianOf<float>(volume.field(), scale))
    {
      ASSERT_TRUE(std::isfinite(value));
    }
    const auto result = laplacianOf(volume.field(), scale);
    for (const double value : result)
    {
      ASSERT_TRUE(std::isfinite(value));
    }
    const std::size_t below = volume.geometry.offset({ 3, 4, 4 });
    if (scale == 0.0)
    {
      EXPECT_NEAR(std::min(result[below] / 2.0 / range, 1.0), range > 1e300 ? 0.5 : 1.0, 0.51);
    }
    EXPECT_GT(result[below], 0.0);
    EXPECT_LT(result[below + 1], 0.0);
  }
}

TEST(LaplacianOfGaussian, HoldsAtTheLimitsOfEveryType){
#define EXPECT_FOR(T)                                                                                        \
  {                                                                                                          \
    SCOPED_TRACE(#T);                                                                                        \
    expectLimits<T>();                                                                                       \
  }
  INK_FOR_EACH_SCALAR(EXPECT_FOR)
#undef EXPECT_FOR
}

TEST(LaplacianOfGaussian, OfABoxIsThatOfTheWholeOnAnyNumberOfThreads)
{
  Volume<float> volume(ink::GridGeometry({ 33, 50, 40 }, { 0, 0, 0 }, { 1.0, 0.8, 1.7 }, sheared));
  for (std::size_t n = 0; n < volume.values.size(); ++n)
  {
    volume.values[n] =
      hashUniform(2, n) < 0.0005 ? static_cast<float>(nan) : static_cast<float>(hashUniform(1, n));
  }
  for (const double scale : { 0.0, 1.0 })
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    const auto whole = laplacianOf<float>(volume.field(), scale);
    setenv("VTK_SMP_MAX_THREADS", "2", 1);
    EXPECT_EQ(whole, laplacianOf<float>(volume.field(), scale));
    unsetenv("VTK_SMP_MAX_THREADS");
    for (const ink::SampleBox& box : { ink::SampleBox{ { 0, 0, 0 }, { 33, 50, 19 } },
           ink::SampleBox{ { 5, 3, 7 }, { 29, 48, 39 } }, ink::SampleBox{ { 32, 0, 39 }, { 33, 50, 40 } } })
    {
      const auto part = laplacianOf<float>(volume.field(), scale, ScaleUnit::Samples, box);
      std::size_t n = 0;
      forEachSample(box,
        [&](const glm::ivec3& s)
        { ASSERT_EQ(part[n++], whole[volume.geometry.offset(s)]) << s.x << " " << s.y; });
    }
  }
}

TEST(LaplacianOfGaussian, StopsWhenAsked)
{
  const Volume<float> volume(ink::GridGeometry({ 40, 40, 200 }));
  const ink::SampleBox box{ { 0, 0, 0 }, { 40, 40, 200 } };
  std::vector<float> result(box.count());
  EXPECT_FALSE((ink::laplacianOfGaussian<float, float>(
    volume.field(), box, glm::dvec3(0.5), result, [](double) { return false; })));
}

TEST(LaplacianOfGaussian, RejectsWhatDoesNotFit)
{
  const Volume<float> volume(ink::GridGeometry({ 4, 4, 4 }));
  const ink::SampleBox box{ { 0, 0, 0 }, { 4, 4, 4 } };
  std::vector<float> result(64);
  const auto run = [&](const ink::SampleBox& b, double deviation, std::span<float> to)
  { return ink::laplacianOfGaussian<float, float>(volume.field(), b, glm::dvec3(deviation), to); };
  EXPECT_TRUE(run(box, 1.0, result));
  EXPECT_THROW(run(box, -1.0, result), std::invalid_argument);
  EXPECT_THROW(run(box, 17.0, result), std::invalid_argument);
  EXPECT_THROW(run(box, nan, result), std::invalid_argument);
  EXPECT_THROW(run(box, 1.0, std::span<float>(result).first(63)), std::invalid_argument);
  EXPECT_THROW(run({ { 1, 0, 0 }, { 5, 4, 4 } }, 1.0, result), std::invalid_argument);
}

} // namespace
