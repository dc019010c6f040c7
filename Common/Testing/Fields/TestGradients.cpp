// SPDX-License-Identifier: BSD-3-Clause
#include "EstimatedGradients.h"
#include "SampledVolume.h"

#include "AnalyticFields.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"
#include "HashNoise.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace
{

using namespace ink::testing;
const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -0.5))));
const glm::dmat3 sheared(1.0, 0.0, 0.0, 0.3, 1.0, 0.0, -0.2, 0.4, 1.0);

/// Straight, anisotropic, oriented, mirrored and sheared grids.
std::vector<ink::GridGeometry> geometries()
{
  const glm::ivec3 n(9, 8, 7);
  return { ink::GridGeometry(n), ink::GridGeometry(n, { 5, -3, 2 }, { 0.5, 0.25, 2.0 }),
    ink::GridGeometry(n, { 1, 2, 3 }, { 1.0, 0.7, 3.0 }, turned),
    ink::GridGeometry(n, { 1, 2, 3 }, { -1.0, 0.7, 1.0 }, turned),
    ink::GridGeometry(n, { 0, 0, 0 }, { 1.0, 1.5, 0.5 }, sheared) };
}

template <class Body>
void forEachCase(const Body& body)
{
  int number = 0;
  for (const ink::GridGeometry& geometry : geometries())
  {
    for (const ink::GradientOptions& options : allGradientOptions())
    {
      SCOPED_TRACE(nameOf(options) + ", geometry " + std::to_string(number));
      body(geometry, options);
    }
    ++number;
  }
}

TEST(Gradients, AreExactForPlanesUpToTheBorder)
{
  const Plane plane{ { 1, 2, 3 }, { 0.5, -1.25, 2.0 } };
  forEachCase(
    [&](const ink::GridGeometry& g, const ink::GradientOptions& options)
    {
      const auto volume = Volume<double>::from(g, [&](const glm::dvec3& p) { return plane.value(p); });
      const auto result = gradientsOf(volume.field(), options);
      forEachSample(result.box,
        [&](const glm::ivec3& s)
        {
          ASSERT_LT(glm::distance(result.gradient(s), plane.normal), 1e-11)
            << s.x << " " << s.y << " " << s.z;
          ASSERT_NEAR(result.magnitude(s), glm::length(plane.normal), 1e-11);
          ASSERT_NEAR(result.value(s), plane.value(g.toWorld(s)), 1e-11);
        });
    });
}

TEST(Gradients, AreExactForQuadraticsInside)
{
  const auto quadratic = [](const glm::dvec3& p)
  {
    return 1.0 + 2.0 * p.x - p.y + 0.5 * p.z + p.x * p.x - 0.5 * p.y * p.y + 0.25 * p.z * p.z +
      0.75 * p.x * p.y - 0.5 * p.y * p.z + 1.5 * p.x * p.z;
  };
  const auto slope = [](const glm::dvec3& p)
  {
    return glm::dvec3(2.0 + 2.0 * p.x + 0.75 * p.y + 1.5 * p.z, -1.0 - p.y + 0.75 * p.x - 0.5 * p.z,
      0.5 + 0.5 * p.z - 0.5 * p.y + 1.5 * p.x);
  };
  forEachCase(
    [&](const ink::GridGeometry& g, const ink::GradientOptions& options)
    {
      const auto volume = Volume<double>::from(g, quadratic);
      const auto result = gradientsOf(volume.field(), options);
      forEachSample(inside(g, options.radius),
        [&](const glm::ivec3& s)
        { ASSERT_LT(glm::distance(result.gradient(s), slope(g.toWorld(s))), 1e-10); });
    });
}

TEST(Gradients, OfConstantsAreExactlyZero)
{
  forEachCase(
    [&](const ink::GridGeometry& g, const ink::GradientOptions& options)
    {
      const auto result = gradientsOf<float>(Volume<float>(g, 1234.567f).field(), options);
      forEachSample(result.box,
        [&](const glm::ivec3& s)
        {
          ASSERT_EQ(result.gradient(s), glm::dvec3(0.0));
          ASSERT_EQ(result.magnitude(s), 0.0);
          ASSERT_NEAR(result.value(s), 1234.567f, 2e-4);
        });
    });
}

/// Mean angle in degrees to the true gradient of a sphere's distance field, with noise of a share of the
/// field's range.
double sphereError(const ink::GradientOptions& options, const glm::dvec3& spacing, double noise)
{
  const glm::ivec3 n = glm::ivec3(40.0 / spacing);
  const ink::GridGeometry g(n, -0.5 * glm::dvec3(n - 1) * spacing, spacing);
  const Sphere sphere{ glm::dvec3(0.0), 12.0 };
  std::uint64_t index = 0;
  // 1 inside, 0 outside, with a ramp of 10 between: the noise is a share of that.
  const auto volume = Volume<float>::from(g,
    [&](const glm::dvec3& p)
    { return glm::clamp(0.5 - 0.1 * sphere.value(p), 0.0, 1.0) + noise * hashNormal(7, index++); });
  const auto result = gradientsOf<float>(volume.field(), options);
  double sum = 0.0;
  int count = 0;
  forEachSample(inside(g, 2),
    [&](const glm::ivec3& s)
    {
      const glm::dvec3 p = g.toWorld(s);
      if (std::abs(sphere.value(p)) < 2.0)
      {
        sum += angleBetween(result.gradient(s), -sphere.gradient(p));
        ++count;
      }
    });
  return sum / count;
}

TEST(Gradients, OfARegressionKeepTheirDirectionInNoise)
{
  const std::vector<ink::GradientOptions> all = allGradientOptions();
  const double central = sphereError(all[0], glm::dvec3(1.0), 0.05);
  const double uniform = sphereError(all[1], glm::dvec3(1.0), 0.05);
  const double uniform5 = sphereError(all[2], glm::dvec3(1.0), 0.05);
  const double inverse = sphereError(all[3], glm::dvec3(1.0), 0.05);
  EXPECT_GT(central, 10.0);
  // Nine differences per axis in place of one: a third of the noise, and next to no systematic error here.
  EXPECT_LT(uniform, 0.36 * central);
  EXPECT_LT(inverse, 0.42 * central);
  EXPECT_LT(uniform, inverse);
  EXPECT_LT(uniform5, 0.13 * central);
}

TEST(Gradients, OfASphereAreGoodWithoutNoise)
{
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    SCOPED_TRACE(nameOf(options));
    EXPECT_LT(sphereError(options, glm::dvec3(1.0), 0.0), options.radius == 1 ? 0.2 : 0.5);
    EXPECT_LT(sphereError(options, { 1.0, 1.0, 2.5 }, 0.0), options.radius == 1 ? 1.0 : 3.0);
  }
}

TEST(Gradients, OfMarschnerAndLobbConverge)
{
  const MarschnerLobb signal;
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    SCOPED_TRACE(nameOf(options));
    std::vector<double> errors;
    for (const int n : { 40, 80, 160 })
    {
      // A slab is enough: the signal's wave is the same in all.
      const double h = 2.0 / (n - 1);
      const ink::GridGeometry g({ n, n, 5 }, { -1, -1, -2 * h }, glm::dvec3(h));
      const auto volume = Volume<float>::from(g, [&](const glm::dvec3& p) { return signal.value(p); });
      const auto result = gradientsOf<float>(volume.field(), options);
      double sum = 0.0;
      const ink::SampleBox box = inside(g, 2);
      forEachSample(box,
        [&](const glm::ivec3& s)
        {
          const glm::dvec3 d = result.gradient(s) - signal.gradient(g.toWorld(s));
          sum += glm::dot(d, d);
        });
      errors.push_back(std::sqrt(sum / box.count()));
    }
    // Second order, once the wave is resolved; a wider neighborhood needs more samples for that.
    const bool narrow = gradientReach(options) == 1;
    EXPECT_LT(errors[1], (narrow ? 0.5 : 0.85) * errors[0]);
    EXPECT_LT(errors[2], (narrow ? 0.35 : 0.4) * errors[1]);
  }
}

TEST(Gradients, FitTheNeighborsThatThereAre)
{
  const ink::GridGeometry g({ 12, 11, 10 }, { 0, 0, 0 }, { 1.0, 0.5, 2.0 }, turned);
  const Plane plane{ { 0, 0, 0 }, { 0.5, -1.0, 2.0 } };
  const auto whole = Volume<double>::from(g, [&](const glm::dvec3& p) { return plane.value(p); });
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    SCOPED_TRACE(nameOf(options));
    auto volume = whole;
    const std::vector<glm::ivec3> holes{ { 5, 5, 5 }, { 6, 5, 5 }, { 0, 0, 0 }, { 11, 10, 9 }, { 3, 0, 4 } };
    for (const glm::ivec3& hole : holes)
    {
      volume.at(hole) = hole.x % 2 ? nan : -infinity;
    }
    std::vector<std::uint8_t> marks(g.sampleCount(), 1);
    const glm::ivec3 hidden(8, 8, 3);
    marks[g.offset(hidden)] = 3;
    volume.at(hidden) = 1e30;
    const auto result = gradientsOf(volume.field({ marks, 2 }), options);
    EXPECT_TRUE(result.allFinite());
    forEachSample(result.box,
      [&](const glm::ivec3& s)
      {
        const bool missing = s == hidden || std::find(holes.begin(), holes.end(), s) != holes.end();
        const glm::dvec3 expected = missing ? glm::dvec3(0.0) : plane.normal;
        ASSERT_LT(glm::distance(result.gradient(s), expected), 1e-10) << s.x << " " << s.y << " " << s.z;
        ASSERT_NEAR(result.value(s), missing ? 0.0 : plane.value(g.toWorld(s)), 1e-10);
      });
  }
}

TEST(Gradients, AreZeroAlongDirectionsWithoutNeighbors)
{
  const Plane plane{ { 0, 0, 0 }, { 0.5, -1.0, 2.0 } };
  for (const glm::ivec3& n : { glm::ivec3(5, 6, 1), glm::ivec3(1, 6, 5), glm::ivec3(7, 1, 1),
         glm::ivec3(1, 1, 1), glm::ivec3(2, 3, 2), glm::ivec3(5, 1, 5) })
  {
    const ink::GridGeometry g(n);
    const auto volume = Volume<double>::from(g, [&](const glm::dvec3& p) { return plane.value(p); });
    const glm::dvec3 expected(
      n.x > 1 ? plane.normal.x : 0, n.y > 1 ? plane.normal.y : 0, n.z > 1 ? plane.normal.z : 0);
    for (const ink::GradientOptions& options : allGradientOptions())
    {
      SCOPED_TRACE(nameOf(options) + " " + std::to_string(n.x) + " " + std::to_string(n.y));
      const auto result = gradientsOf(volume.field(), options);
      forEachSample(result.box,
        [&](const glm::ivec3& s) { ASSERT_LT(glm::distance(result.gradient(s), expected), 1e-11); });
    }
  }
  // A sample with nothing but missing ones around it.
  ink::testing::Volume<float> lone(ink::GridGeometry({ 5, 5, 5 }), std::numeric_limits<float>::quiet_NaN());
  lone.at({ 2, 2, 2 }) = 3.0f;
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    const auto result = gradientsOf<float>(lone.field(), options);
    EXPECT_TRUE(result.allFinite());
    EXPECT_EQ(result.gradient({ 2, 2, 2 }), glm::dvec3(0.0));
    EXPECT_EQ(result.value({ 2, 2, 2 }), 3.0);
  }
}

TEST(Gradients, HoldForTinyHugeAndVeryUnevenSpacing)
{
  const glm::dvec3 slope(1.0, -2.0, 0.5);
  for (const glm::dvec3& spacing : { glm::dvec3(1e-9), glm::dvec3(1e9), glm::dvec3(1, 1, 1000),
         glm::dvec3(1000, 1, 1), glm::dvec3(1e-9, 1, 1e9), glm::dvec3(1e-30), glm::dvec3(1e30) })
  {
    const ink::GridGeometry g({ 8, 7, 9 }, { 0, 0, 0 }, spacing, turned);
    // One value per step along each axis, whatever the step.
    const glm::dvec3 world = g.gradientToWorld(slope);
    Volume<float> volume(g);
    forEachSample({ { 0, 0, 0 }, g.dimensions() },
      [&](const glm::ivec3& s) { volume.at(s) = static_cast<float>(glm::dot(slope, glm::dvec3(s))); });
    for (const ink::GradientOptions& options : allGradientOptions())
    {
      SCOPED_TRACE(
        nameOf(options) + ", spacing " + std::to_string(spacing.x) + " " + std::to_string(spacing.z));
      const auto floats = gradientsOf<float>(volume.field(), options);
      const auto doubles = gradientsOf<double>(volume.field(), options);
      forEachSample(floats.box,
        [&](const glm::ivec3& s)
        {
          ASSERT_LT(glm::distance(floats.gradient(s), world), 1e-5 * glm::length(world));
          ASSERT_LT(glm::distance(doubles.gradient(s), world), 1e-11 * glm::length(world));
          ASSERT_NEAR(floats.magnitude(s) / glm::length(world), 1.0, 1e-5);
          ASSERT_NEAR(doubles.magnitude(s) / glm::length(world), 1.0, 1e-11);
        });
    }
  }
}

template <class T>
void expectLimits()
{
  using Limits = std::numeric_limits<T>;
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    SCOPED_TRACE(nameOf(options));
    // Steps from the lowest value to the highest.
    Volume<T> steep(ink::GridGeometry({ 9, 8, 8 }), Limits::lowest());
    forEachSample({ { 4, 0, 0 }, { 9, 8, 8 } }, [&](const glm::ivec3& s) { steep.at(s) = Limits::max(); });
    const auto single = gradientsOf<float>(steep.field(), options);
    EXPECT_TRUE(single.allFinite());
    const auto result = gradientsOf<double>(steep.field(), options);
    EXPECT_TRUE(result.allFinite());
    const double range =
      0.5 * static_cast<double>(Limits::max()) - 0.5 * static_cast<double>(Limits::lowest());
    // Half of the whole step, or with two samples on either side 3/5; more when the nearer ones count more.
    const bool inverse = options.weighting == ink::RegressionWeighting::InverseDistance;
    const double expected = options.radius == 1 ? 1.0 : inverse ? 0.63 : 0.6;
    EXPECT_NEAR(result.gradient({ 4, 3, 3 }).x / range, expected, inverse ? 0.01 : 1e-6);
    EXPECT_NEAR(result.gradient({ 4, 0, 7 }).x / range, expected, inverse ? 0.01 : 1e-6);
    EXPECT_NEAR(result.gradient({ 4, 3, 3 }).y / range, 0.0, 1e-15);
    if constexpr (Limits::is_integer)
    {
      // One apart at the upper end, where a 64-bit integer is no double.
      Volume<T> fine(ink::GridGeometry({ 9, 5, 5 }));
      forEachSample({ { 0, 0, 0 }, { 9, 5, 5 } },
        [&](const glm::ivec3& s) { fine.at(s) = static_cast<T>(Limits::max() - static_cast<T>(8 - s.x)); });
      const auto one = gradientsOf<double>(fine.field(), options);
      forEachSample(one.box,
        [&](const glm::ivec3& s)
        { ASSERT_LT(glm::distance(one.gradient(s), glm::dvec3(1, 0, 0)), sizeof(T) == 8 ? 1e-12 : 1e-6); });
    }
  }
}

TEST(Gradients, HoldAtTheLimitsOfEveryType)
{
#define EXPECT_FOR(T)                                                                                        \
  {                                                                                                          \
    SCOPED_TRACE(#T);                                                                                        \
    expectLimits<T>();                                                                                       \
  }
  INK_FOR_EACH_SCALAR(EXPECT_FOR)
#undef EXPECT_FOR
}

/// Values without any pattern; some are missing.
template <class T>
Volume<T> roughVolume(const glm::ivec3& n)
{
  Volume<T> volume(ink::GridGeometry(n, { 0, 0, 0 }, { 1.0, 0.8, 1.7 }, turned));
  for (std::size_t s = 0; s < volume.values.size(); ++s)
  {
    volume.values[s] = static_cast<T>(200.0 * hashUniform(1, s));
    if (std::is_floating_point_v<T> && hashUniform(2, s) < 0.0005)
    {
      volume.values[s] = static_cast<T>(nan);
    }
  }
  return volume;
}

TEST(Gradients, OfABoxAreThoseOfTheWhole)
{
  const auto volume = roughVolume<float>({ 37, 70, 23 });
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    SCOPED_TRACE(nameOf(options));
    const auto whole = gradientsOf<float>(volume.field(), options);
    for (const ink::SampleBox& box : { ink::SampleBox{ { 0, 0, 0 }, { 37, 70, 11 } },
           ink::SampleBox{ { 5, 3, 7 }, { 29, 68, 22 } }, ink::SampleBox{ { 1, 1, 1 }, { 2, 2, 2 } },
           ink::SampleBox{ { 36, 0, 22 }, { 37, 70, 23 } }, ink::SampleBox{ { 0, 69, 0 }, { 37, 70, 23 } } })
    {
      const auto part = gradientsOf<float>(volume.field(), options, box);
      forEachSample(box,
        [&](const glm::ivec3& s)
        {
          ASSERT_EQ(part.gradient(s), whole.gradient(s)) << s.x << " " << s.y << " " << s.z;
          ASSERT_EQ(part.magnitude(s), whole.magnitude(s));
          ASSERT_EQ(part.value(s), whole.value(s));
        });
    }
    // The same samples as a grid of their own, with the neighbors that they need: what a piece has.
    const glm::ivec3 first(4, 6, 3);
    Volume<float> piece(
      ink::GridGeometry({ 25, 50, 14 }, { 0, 0, 0 }, volume.geometry.spacing(), turned, first));
    forEachSample({ { 0, 0, 0 }, piece.geometry.dimensions() },
      [&](const glm::ivec3& s) { piece.at(s) = volume.values[volume.geometry.offset(s + first)]; });
    const ink::SampleBox own = inside(piece.geometry, 2);
    const auto ofPiece = gradientsOf<float>(piece.field(), options, own);
    forEachSample(
      own, [&](const glm::ivec3& s) { ASSERT_EQ(ofPiece.gradient(s), whole.gradient(s + first)); });
  }
}

TEST(Gradients, AreTheSameOnAnyNumberOfThreads)
{
  const auto volume = roughVolume<float>({ 60, 75, 50 });
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    const auto one = gradientsOf<float>(volume.field(), options);
    setenv("VTK_SMP_MAX_THREADS", "2", 1);
    const auto two = gradientsOf<float>(volume.field(), options);
    unsetenv("VTK_SMP_MAX_THREADS");
    EXPECT_TRUE(one == two) << nameOf(options);
  }
}

TEST(Gradients, ComputeWhatIsAskedForAlone)
{
  const auto volume = roughVolume<short>({ 20, 19, 18 });
  const ink::SampleBox box{ { 0, 0, 0 }, { 20, 19, 18 } };
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    const auto all = gradientsOf<float>(volume.field(), options);
    std::vector<float> alone(box.count());
    ink::estimateGradients<short, float>(volume.field(), box, options, { {}, alone, {} });
    EXPECT_EQ(alone, all.magnitudes) << nameOf(options);
    ink::estimateGradients<short, float>(volume.field(), box, options, { {}, {}, alone });
    EXPECT_EQ(alone, all.values) << nameOf(options);
    std::vector<float> gradients(3 * box.count());
    ink::estimateGradients<short, float>(volume.field(), box, options, { gradients, {}, {} });
    EXPECT_EQ(gradients, all.components) << nameOf(options);
  }
}

TEST(Gradients, OfFloatsNeedNoDoubles)
{
  const auto volume = roughVolume<unsigned short>({ 40, 30, 20 });
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    const auto single = gradientsOf<float>(volume.field(), options);
    const auto twice = gradientsOf<double>(volume.field(), options);
    forEachSample(single.box,
      [&](const glm::ivec3& s)
      {
        ASSERT_LT(glm::distance(single.gradient(s), twice.gradient(s)), 2e-4);
        ASSERT_NEAR(single.value(s), twice.value(s), 3e-4);
      });
  }
}

TEST(Gradients, ReadInterleavedComponents)
{
  const ink::GridGeometry g({ 9, 8, 7 });
  std::vector<short> values(2 * g.sampleCount());
  for (std::size_t s = 0; s < g.sampleCount(); ++s)
  {
    values[2 * s + 1] = static_cast<short>(3 * (s % 9));
  }
  const ink::GridField<short> field(g, std::span<const short>(values).subspan(1), 2);
  for (const ink::GradientOptions& options : allGradientOptions())
  {
    const auto result = gradientsOf(field, options);
    forEachSample(result.box,
      [&](const glm::ivec3& s) { ASSERT_LT(glm::distance(result.gradient(s), glm::dvec3(3, 0, 0)), 1e-12); });
  }
}

TEST(Gradients, StopWhenAsked)
{
  const Volume<float> volume(ink::GridGeometry({ 64, 64, 300 }));
  const ink::SampleBox box{ { 0, 0, 0 }, { 64, 64, 300 } };
  std::vector<float> magnitudes(box.count());
  const auto run = [&](const ink::Progress& progress) {
    return ink::estimateGradients<float, float>(volume.field(), box, {}, { {}, magnitudes, {} }, progress);
  };
  double last = 0.0;
  EXPECT_TRUE(run(
    [&](double share)
    {
      EXPECT_GT(share, last);
      last = share;
      return true;
    }));
  EXPECT_GT(last, 0.5);
  EXPECT_FALSE(run([](double) { return false; }));
}

TEST(Gradients, RejectWhatDoesNotFit)
{
  const Volume<float> volume(ink::GridGeometry({ 4, 4, 4 }));
  const ink::SampleBox box{ { 0, 0, 0 }, { 4, 4, 4 } };
  std::vector<float> some(63);
  std::vector<float> enough(192);
  const auto run = [&](const ink::SampleBox& b, int radius, std::span<float> gradient)
  {
    ink::GradientOptions options;
    options.radius = radius;
    return ink::estimateGradients<float, float>(volume.field(), b, options, { gradient, {}, {} });
  };
  EXPECT_THROW(run(box, 1, some), std::invalid_argument);
  EXPECT_THROW(run(box, 0, enough), std::invalid_argument);
  EXPECT_THROW(run(box, 3, enough), std::invalid_argument);
  EXPECT_THROW(run({ { 1, 0, 0 }, { 5, 4, 4 } }, 1, enough), std::invalid_argument);
  EXPECT_THROW(run({ { -1, 0, 0 }, { 3, 4, 4 } }, 1, enough), std::invalid_argument);
  EXPECT_TRUE(run({ { 2, 0, 0 }, { 2, 4, 4 } }, 1, {}));
}

} // namespace
