// SPDX-License-Identifier: BSD-3-Clause
// The samples of iso-surfaces against the analytic surfaces that they stand for.

#include "AnalyticFields.h"
#include "Fields/ScalarDifference.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace
{

using namespace ink::testing;
using ink::CrossingRule;
using ink::GridGeometry;

const glm::dmat3 rotation(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, -2.0, 0.5)));
const glm::dmat3 mirror(-1, 0, 0, 0, 1, 0, 0, 0, 1);

/// The largest distance from the surface and the largest angle to its normal, in radians.
struct Errors
{
  double distance = 0.0;
  double angle = 0.0;
};

template <class Shape, class Real>
Errors errorsOf(const Samples<Real>& samples, const Shape& shape)
{
  Errors errors;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 p = samples.point(n);
    const glm::dvec3 inward = -glm::normalize(shape.gradient(p));
    EXPECT_NEAR(glm::length(samples.normal(n)), 1.0, 1e-6) << "sample " << n;
    errors.distance = std::max(errors.distance, std::abs(shape.distance(p)));
    errors.angle = std::max(errors.angle, glm::length(glm::cross(samples.normal(n), inward)));
    EXPECT_GT(glm::dot(samples.normal(n), inward), 0.0) << "sample " << n;
  }
  return errors;
}

/// A grid of n^3 samples around the origin.
GridGeometry centered(int n, const glm::dvec3& spacing, const glm::dmat3& direction = glm::dmat3(1.0),
  const glm::dvec3& center = glm::dvec3(0.0))
{
  return GridGeometry({ n, n, n }, center - direction * (spacing * (0.5 * (n - 1))), spacing, direction);
}

TEST(IsoSurfaceSamples, LieOnASphere)
{
  // Linear interpolation along an edge is off by h^2 / 8R at most, and the mean of points around a facet by
  // the sagitta of a half diagonal, 3/8 h^2 / R. The gradient's error is of the second order in h / R too.
  for (const double radius : { 5.3, 10.0, 20.7 })
  {
    const Sphere sphere{ { 0.1, -0.2, 0.3 }, radius };
    const int n = 2 * static_cast<int>(radius) + 6;
    const auto volume =
      Volume<double>::from(centered(n, glm::dvec3(1.0)), [&](auto p) { return sphere.value(p); });
    const auto samples = sampleIsoSurface(volume.field(), 0.0);
    const Errors errors = errorsOf(samples, sphere);
    EXPECT_LT(errors.distance, 0.5 / radius) << radius;
    EXPECT_LT(errors.angle, 0.5 / (radius * radius)) << radius;
    // About one sample for each unit of area, and half as many again where the surface is oblique.
    const double area = 4 * M_PI * radius * radius;
    EXPECT_GT(static_cast<double>(samples.size()), area);
    EXPECT_LT(static_cast<double>(samples.size()), 2 * area);
  }
}

TEST(IsoSurfaceSamples, LieOnATorus)
{
  const Torus torus{ 14.0, 6.0 };
  const auto volume =
    Volume<float>::from(centered(44, glm::dvec3(1.0)), [&](auto p) { return torus.value(p); });
  const Errors errors = errorsOf(sampleIsoSurface(volume.field(), 0.0), torus);
  EXPECT_LT(errors.distance, 0.5 / torus.minor);
  EXPECT_LT(errors.angle, 0.5 / (torus.minor * torus.minor));
}

TEST(IsoSurfaceSamples, LieOnAPlaneExactly)
{
  // Every step of the algorithm is linear, so nothing but rounding is left, border cells included.
  for (const glm::dvec3& normal : { glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1), glm::dvec3(0.3, -0.7, 0.2) })
  {
    for (const glm::dmat3& direction : { glm::dmat3(1.0), rotation, rotation * mirror })
    {
      for (const glm::dvec3& spacing :
        { glm::dvec3(1), glm::dvec3(1, 1, 1000), glm::dvec3(0.5, -2, 3), glm::dvec3(1e-9), glm::dvec3(1e9) })
      {
        const Plane plane{ glm::dvec3(0.123) * glm::abs(spacing), normal };
        const auto volume =
          Volume<double>::from(centered(9, spacing, direction), [&](auto p) { return plane.value(p); });
        const auto samples = sampleIsoSurface(volume.field(), 0.0);
        ASSERT_GT(samples.size(), 0u);
        const Errors errors = errorsOf(samples, plane);
        const glm::dvec3 size = glm::abs(spacing);
        EXPECT_LT(errors.distance, 1e-12 * std::max({ size.x, size.y, size.z }));
        EXPECT_LT(errors.angle, 1e-6);
      }
    }
  }
}

TEST(IsoSurfaceSamples, FollowAnisotropicOrientedGrids)
{
  // Samples of the same sphere, in world units, through grids that see it differently. Errors are bounded by
  // the largest spacing.
  const Sphere sphere{ { 3, 4, 5 }, 20.0 };
  for (const glm::dmat3& direction : { glm::dmat3(1.0), rotation, rotation * mirror })
  {
    const GridGeometry g({ 90, 46, 24 }, sphere.center - direction * glm::dvec3(22.25, 22.5, 23.0),
      { 0.5, 1.0, 2.0 }, direction);
    const auto volume = Volume<double>::from(g, [&](auto p) { return sphere.value(p); });
    const Errors errors = errorsOf(sampleIsoSurface(volume.field(), 0.0), sphere);
    EXPECT_LT(errors.distance, 0.5 * 4.0 / sphere.radius);
    EXPECT_LT(errors.angle, 0.5 * 4.0 / (sphere.radius * sphere.radius));
  }
}

TEST(IsoSurfaceSamples, HoldFarFromTheOrigin)
{
  const Sphere sphere{ glm::dvec3(1e7), 10.0 };
  const auto volume = Volume<double>::from(
    centered(26, glm::dvec3(1.0), glm::dmat3(1.0), sphere.center), [&](auto p) { return sphere.value(p); });
  EXPECT_LT(errorsOf(sampleIsoSurface(volume.field(), 0.0), sphere).distance, 0.05);
}

template <class T>
void expectSphereInType()
{
  // A ramp through the type's middle, steep enough that rounding to integers stays well below a voxel.
  const Sphere sphere{ glm::dvec3(0.1), 8.0 };
  const double low = static_cast<double>(std::numeric_limits<T>::lowest());
  const double high = static_cast<double>(std::numeric_limits<T>::max());
  const double middle = 0.5 * low + 0.5 * high;
  const double steepness = (0.5 * high - 0.5 * low) / 12.0;
  const auto volume = Volume<T>::from(centered(22, glm::dvec3(1.0)),
    [&](auto p) { return middle + steepness * std::clamp(sphere.value(p), -11.0, 11.0); });
  const Errors errors = errorsOf(sampleIsoSurface(volume.field(), middle), sphere);
  const double rounding = std::is_integral_v<T> ? 1.0 / steepness : 0.0;
  EXPECT_LT(errors.distance, 0.5 / sphere.radius + rounding);
  EXPECT_LT(errors.angle, 0.5 / (sphere.radius * sphere.radius) + rounding);
}

TEST(IsoSurfaceSamples, HoldForEveryType){
#define EXPECT_FOR(T)                                                                                        \
  {                                                                                                          \
    SCOPED_TRACE(#T);                                                                                        \
    expectSphereInType<T>();                                                                                 \
  }
  INK_FOR_EACH_SCALAR(EXPECT_FOR)
#undef EXPECT_FOR
}

TEST(IsoSurfaceSamples, TellNeighboringLargeIntegersApart)
{
  // 2^62 and its successors are one double.
  const long long base = 1LL << 62;
  auto volume = Volume<long long>::from(GridGeometry({ 4, 4, 4 }), [](auto p) { return p.x; });
  for (long long& value : volume.values)
  {
    value += base;
  }
  const auto samples = sampleIsoSurface(volume.field(), static_cast<double>(base));
  EXPECT_EQ(samples.size(), 0u);
  for (long long& value : volume.values)
  {
    value -= 1;
  }
  const auto moved = sampleIsoSurface(volume.field(), static_cast<double>(base));
  ASSERT_EQ(moved.size(), 9u);
  for (std::size_t n = 0; n < moved.size(); ++n)
  {
    EXPECT_EQ(moved.point(n).x, 1.0);
    EXPECT_EQ(moved.normal(n), glm::dvec3(-1, 0, 0));
  }
}

/// Both rules; some iso-values in, at and beyond the type's range.
template <class T>
void expectFiniteAtTheLimits()
{
  using Limits = std::numeric_limits<T>;
  const double low = static_cast<double>(Limits::lowest());
  const double high = static_cast<double>(Limits::max());
  auto volume = Volume<T>(GridGeometry({ 4, 4, 4 }), Limits::lowest());
  for (int n = 0; n < 64; n += 3)
  {
    volume.values[n] = n % 2 ? Limits::max() : T(0);
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const CrossingRule rule : { CrossingRule::HalfOpen, CrossingRule::Strict })
  {
    for (const double isoValue :
      { low, std::nextafter(low, 0.0), 0.5 * low, 0.0, 0.5, 0.5 * high, std::nextafter(high, 0.0), high,
        2.0 * high, 2.0 * low, infinity, -infinity, std::numeric_limits<double>::quiet_NaN() })
    {
      const auto samples = sampleIsoSurface(volume.field(), isoValue, rule);
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        const glm::dvec3 p = samples.point(n);
        EXPECT_TRUE(p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= 3 && p.y <= 3 && p.z <= 3) << isoValue;
        EXPECT_NEAR(glm::length(samples.normal(n)), 1.0, 1e-6) << isoValue;
      }
      const bool outside = !(isoValue >= low && isoValue <= high);
      EXPECT_TRUE(samples.size() == 0 || !outside) << isoValue;
    }
  }
}

TEST(IsoSurfaceSamples, StayFiniteAtTheLimitsOfEveryType){
#define EXPECT_FOR(T)                                                                                        \
  {                                                                                                          \
    SCOPED_TRACE(#T);                                                                                        \
    expectFiniteAtTheLimits<T>();                                                                            \
  }
  INK_FOR_EACH_SCALAR(EXPECT_FOR)
#undef EXPECT_FOR
}

TEST(IsoSurfaceSamples, StayFiniteForTheSmallestDoubles)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  auto volume = Volume<double>(GridGeometry({ 3, 3, 3 }), -tiny);
  volume.at({ 1, 1, 1 }) = tiny;
  const auto samples = sampleIsoSurface(volume.field(), 0.0);
  ASSERT_EQ(samples.size(), 8u);
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    EXPECT_LT(glm::distance(samples.point(n), glm::dvec3(1.0)), 1.0);
    EXPECT_NEAR(glm::length(samples.normal(n)), 1.0, 1e-6);
  }
}

TEST(IsoSurfaceSamples, AreNoneWhereThereIsNoSurface)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const glm::ivec3& n : { glm::ivec3(0), glm::ivec3(1), glm::ivec3(9, 9, 1), glm::ivec3(1, 9, 9) })
  {
    const auto volume = Volume<float>::from(GridGeometry(n), [](auto p) { return p.x - p.y + p.z - 0.5; });
    EXPECT_EQ(sampleIsoSurface(volume.field(), 0.0).size(), 0u);
  }
  for (const double value : { 0.0, 7.0, nan, infinity, -infinity })
  {
    const Volume<double> constant(GridGeometry({ 5, 5, 5 }), value);
    EXPECT_EQ(sampleIsoSurface(constant.field(), 3.0).size(), 0u) << value;
    EXPECT_EQ(sampleIsoSurface(constant.field(), value).size(), 0u) << value;
  }
}

TEST(IsoSurfaceSamples, SkipCellsWithMissingCorners)
{
  const auto plane = [](const glm::dvec3& p) { return p.z - 2.5; };
  const auto whole = Volume<float>::from(GridGeometry({ 8, 8, 6 }), plane);
  const auto all = sampleIsoSurface(whole.field(), 0.0);
  ASSERT_EQ(all.size(), 49u);
  for (const float broken : { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
         -std::numeric_limits<float>::infinity() })
  {
    auto volume = whole;
    volume.at({ 3, 4, 2 }) = broken;
    const auto samples = sampleIsoSurface(volume.field(), 0.0);
    EXPECT_EQ(samples.size(), 45u);
    // The normals beside the hole do not feel it.
    EXPECT_LT(errorsOf(samples, Plane{ { 0, 0, 2.5 }, { 0, 0, 1 } }).angle, 1e-6);
    // Neither does anything feel a value two samples away.
    volume = whole;
    volume.at({ 3, 4, 4 }) = broken;
    EXPECT_EQ(sampleIsoSurface(volume.field(), 0.0), all);
  }
  std::vector<std::uint8_t> marks(whole.values.size(), 0);
  marks[whole.geometry.offset({ 3, 4, 2 })] = 2;
  marks[whole.geometry.offset({ 6, 6, 2 })] = 1;
  EXPECT_EQ(sampleIsoSurface(whole.field({ marks, 2 }), 0.0).size(), 45u);
}

TEST(IsoSurfaceSamples, KeepToTheSelection)
{
  const auto volume =
    Volume<float>::from(GridGeometry({ 150, 8, 6 }), [](const glm::dvec3& p) { return p.z - 2.5; });
  const auto all = sampleIsoSurface(volume.field(), 0.0);
  ASSERT_EQ(all.size(), 149u * 7u);
  ink::CellSelection box;
  box.begin = { 60, 2, -4 };
  box.end = { 131, 5, 100 };
  const auto samples = sampleIsoSurface(volume.field(), 0.0, CrossingRule::HalfOpen, box);
  ASSERT_EQ(samples.size(), 71u * 3u);
  EXPECT_EQ(samples.point(0), glm::dvec3(60.5, 2.5, 2.5));
  EXPECT_EQ(samples.point(samples.size() - 1), glm::dvec3(130.5, 4.5, 2.5));

  std::vector<std::uint8_t> marks(149 * 7 * 5, 0);
  marks[100 + 149 * (3 + 7 * 2)] = 32;
  marks[101 + 149 * (3 + 7 * 2)] = 4;
  box.skipped = { std::span<const std::uint8_t>(marks).first(marks.size() - 1), 32 };
  EXPECT_THROW(findActiveCells(volume.field(), 0.0, CrossingRule::HalfOpen, box), std::invalid_argument);
  box.skipped = { marks, 32 };
  const auto fewer = sampleIsoSurface(volume.field(), 0.0, CrossingRule::HalfOpen, box);
  EXPECT_EQ(fewer.size(), samples.size() - 1);
  for (std::size_t n = 0; n < fewer.size(); ++n)
  {
    EXPECT_NE(fewer.point(n), glm::dvec3(100.5, 3.5, 2.5));
  }
}

TEST(IsoSurfaceSamples, HaveNoHolesAtIntegerValues)
{
  // The surface runs through samples that have exactly the iso-value.
  const auto volume = Volume<unsigned char>::from(GridGeometry({ 9, 9, 9 }), [](auto p) { return 10 + p.z; });
  const auto halfOpen = sampleIsoSurface(volume.field(), 14.0);
  EXPECT_EQ(halfOpen.size(), 64u);
  for (std::size_t n = 0; n < halfOpen.size(); ++n)
  {
    EXPECT_EQ(halfOpen.point(n).z, 4.0);
  }
}

TEST(IsoSurfaceSamples, DoubleOrVanishUnderTheStrictRule)
{
  // A flat surface at sample values is found from both sides: f1 = f2 = f0 on edges that two layers share.
  const auto flat = Volume<unsigned char>::from(GridGeometry({ 9, 9, 9 }), [](auto p) { return 10 + p.z; });
  const auto twice = sampleIsoSurface(flat.field(), 14.0, CrossingRule::Strict);
  EXPECT_EQ(twice.size(), 128u);
  // An oblique one passes through corners only, which intersects no edge: holes where the other rule has
  // samples.
  const auto oblique =
    Volume<unsigned char>::from(GridGeometry({ 9, 9, 9 }), [](auto p) { return 2 * p.x + p.y + 4 * p.z; });
  const auto strict = sampleIsoSurface(oblique.field(), 28.0, CrossingRule::Strict);
  const auto halfOpen = sampleIsoSurface(oblique.field(), 28.0);
  EXPECT_LT(strict.size(), halfOpen.size());
  // Between sample values the rules agree.
  EXPECT_EQ(
    sampleIsoSurface(oblique.field(), 28.5, CrossingRule::Strict), sampleIsoSurface(oblique.field(), 28.5));
}

TEST(IsoSurfaceSamples, AreTheSameOnAnyNumberOfThreads)
{
  const Torus torus{ 30.0, 12.0 };
  const auto volume =
    Volume<short>::from(centered(90, glm::dvec3(1.0)), [&](auto p) { return 100 * torus.value(p); });
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const auto one = sampleIsoSurface<float>(volume.field(), 3.0);
  EXPECT_GT(one.size(), 10000u);
  for (const char* threads : { "2", "5" })
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    EXPECT_EQ(sampleIsoSurface<float>(volume.field(), 3.0), one) << threads << " threads";
  }
  unsetenv("VTK_SMP_MAX_THREADS");
}

TEST(IsoSurfaceSamples, StopWhenAsked)
{
  const auto volume =
    Volume<float>::from(GridGeometry({ 9, 9, 99 }), [](const glm::dvec3& p) { return p.x - 2.5; });
  const auto stop = [](double) { return false; };
  const auto cells = findActiveCells(volume.field(), 0.0, CrossingRule::HalfOpen);
  std::vector<float> points(3 * cells.count);
  EXPECT_EQ(findActiveCells(volume.field(), 0.0, CrossingRule::HalfOpen, {}, stop).count, 0u);
  EXPECT_FALSE(placeIsoSurfaceSamples(
    volume.field(), 0.0, {}, cells, std::span<float>(points), std::span<float>(), stop));
  points.resize(points.size() - 1);
  EXPECT_THROW(
    placeIsoSurfaceSamples(volume.field(), 0.0, {}, cells, std::span<float>(points), std::span<float>()),
    std::invalid_argument);
}

} // namespace
