// SPDX-License-Identifier: BSD-3-Clause
// Grooves between labels that meet on a surface.

#include "IsoSurface/ResampledSamples.h"
#include "SampledVolume.h"
#include "Statistics/NoiseEstimate.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::GridGeometry;
using ink::SmoothingTarget;

constexpr double smoothing = 2.0;
/// Of the kernel.
const double reach = std::sqrt(7.0) * smoothing;

struct Way
{
  bool borders = true;
  SmoothingTarget target = SmoothingTarget::Normals;
  int subdivision = 1;
};

template <class T>
Samples<float> sampleLabels(
  const ink::GridField<T>& field, const Way& way = {}, const ink::CellSelection& selection = {})
{
  Samples<float> samples;
  const auto grow = [&](std::size_t count) { return samples.grow(count); };
  std::vector<std::size_t> counts;
  auto resampling =
    ink::makeIsoSurfaceResampling(field.geometry(), smoothing, way.subdivision, way.target, true);
  resampling.borders = way.borders;
  const double isoValue = 0.5;
  ink::sampleResampledIsoSurfaces(
    field, { &isoValue, 1 }, {}, selection, resampling, 0, nullptr, grow, counts);
  return samples;
}

/// What lies below z = .4 has labels by x and y.
template <class T, class Label>
Volume<T> floorOf(const Label& label, const glm::dvec3& spacing = glm::dvec3(1.0))
{
  const glm::ivec3 n(glm::dvec3(40.0) / spacing + 1.0);
  const GridGeometry geometry(n, -0.5 * spacing * glm::dvec3(n - 1), spacing);
  return Volume<T>::from(geometry, [&](const glm::dvec3& p) { return p.z < 0.4 ? label(p) : 0; });
}

double turnOf(const Samples<float>& samples, std::size_t n)
{
  return glm::degrees(std::acos(std::clamp(samples.normal(n).z, -1.0, 1.0)));
}

/// Two halves, that meet between the samples at 0 and -1.
int halves(const glm::dvec3& p)
{
  return p.x < -0.5 ? 1 : 2;
}

TEST(LabelBorders, AreGroovesOf45Degrees)
{
  for (const Way& way : { Way{}, Way{ .target = SmoothingTarget::Surface }, Way{ .subdivision = 2 } })
  {
    for (const glm::dvec3& spacing : { glm::dvec3(1.0), glm::dvec3(1.0, 1.0, 2.0) })
    {
      const Samples<float> samples = sampleLabels(floorOf<std::uint8_t>(halves, spacing).field(), way);
      ASSERT_GT(samples.size(), 1000u);
      double nearest = reach;
      double turn = 0.0;
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        const double distance = samples.point(n).x + 0.5;
        const glm::dvec3 normal = samples.normal(n);
        EXPECT_NEAR(normal.y, 0.0, 1e-6) << "also at the ends of the grid";
        if (std::abs(distance) > reach)
        {
          EXPECT_NEAR(normal.z, 1.0, 1e-6);
          continue;
        }
        // Towards the border, from both sides.
        EXPECT_LT(normal.x * distance, 1e-9);
        EXPECT_LT(turnOf(samples, n), 45.5);
        if (std::abs(distance) < nearest)
        {
          nearest = std::abs(distance);
          turn = turnOf(samples, n);
        }
      }
      EXPECT_LT(nearest, 0.6);
      EXPECT_GT(turn, 36.0);
    }
  }
}

TEST(LabelBorders, PointsStayAndOneLabelHasNone)
{
  const auto one = floorOf<std::uint8_t>([](const glm::dvec3&) { return 3; });
  const Samples<float> smooth = sampleLabels(one.field(), { .borders = false });
  EXPECT_TRUE(sampleLabels(one.field()) == smooth);
  const auto two = floorOf<std::uint8_t>(halves);
  const Samples<float> grooved = sampleLabels(two.field());
  EXPECT_EQ(grooved.coordinates, smooth.coordinates);
  EXPECT_NE(grooved.components, smooth.components);
  EXPECT_TRUE(sampleLabels(two.field(), { .borders = false }) == smooth);
}

TEST(LabelBorders, IdsDoNotMatter)
{
  // But for their order, where two have the same share.
  const auto by = [](int low, int high)
  { return [=](const glm::dvec3& p) { return halves(p) == 1 ? low : high; }; };
  const Samples<float> expected = sampleLabels(floorOf<std::uint8_t>(by(1, 2)).field());
  EXPECT_TRUE(sampleLabels(floorOf<std::uint8_t>(by(7, 200)).field()) == expected);
  EXPECT_TRUE(sampleLabels(floorOf<std::int16_t>(by(1000, 30000)).field()) == expected);
  EXPECT_TRUE(sampleLabels(floorOf<float>(by(2, 1000000)).field()) == expected);
}

TEST(LabelBorders, SingleVoxelsAndThinLayersHaveNone)
{
  const auto greatestTurn = [](const auto& label)
  {
    const Samples<float> samples = sampleLabels(floorOf<std::uint8_t>(label).field());
    double greatest = 0.0;
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      greatest = std::max(greatest, turnOf(samples, n));
    }
    return greatest;
  };
  EXPECT_GT(greatestTurn(halves), 36.0);
  EXPECT_LT(greatestTurn([](const glm::dvec3& p) { return glm::length(p) < 0.5 ? 2 : 1; }), 5.0);
  EXPECT_LT(greatestTurn([](const glm::dvec3& p) { return p.z > -0.5 ? 2 : 1; }), 1e-3);
}

TEST(LabelBorders, MeasuredValuesAreNoLabels)
{
  const auto scan = floorOf<std::int16_t>(
    [](const glm::dvec3& p) { return 1000 + static_cast<int>(20.0 * p.x + 7.0 * p.y - 300.0 * p.z); });
  EXPECT_TRUE(sampleLabels(scan.field()) == sampleLabels(scan.field(), { .borders = false }));
}

TEST(LabelBorders, BordersOfStepsAreSmooth)
{
  // Along a diagonal: all turns are within the plane across it.
  const Samples<float> samples =
    sampleLabels(floorOf<std::uint8_t>([](const glm::dvec3& p) { return p.x + p.y < -0.5 ? 1 : 2; }).field());
  const glm::dvec3 along = glm::normalize(glm::dvec3(1.0, -1.0, 0.0));
  std::size_t turned = 0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const glm::dvec3 p = samples.point(n);
    if (std::max(std::abs(p.x), std::abs(p.y)) < 20.0 - reach)
    {
      EXPECT_LT(std::abs(glm::dot(samples.normal(n), along)), 0.1);
      turned += turnOf(samples, n) > 20.0;
    }
  }
  EXPECT_GT(turned, 50u);
}

TEST(LabelBorders, BeginWithoutAStep)
{
  // Of a ball, where normals of the mask's Gaussian and of the kernel are not quite the same.
  const GridGeometry geometry({ 48, 48, 48 }, glm::dvec3(-23.3));
  const auto ball = [&](int other)
  {
    return Volume<std::uint8_t>::from(
      geometry, [&](const glm::dvec3& p) { return glm::length(p) < 18.0 ? (p.x < -0.5 ? 1 : other) : 0; });
  };
  const Samples<float> smooth = sampleLabels(ball(1).field());
  const Samples<float> grooved = sampleLabels(ball(2).field());
  ASSERT_EQ(grooved.coordinates, smooth.coordinates);
  std::size_t begun = 0;
  for (std::size_t n = 0; n < smooth.size(); ++n)
  {
    const double cosine = std::clamp(glm::dot(smooth.normal(n), grooved.normal(n)), -1.0, 1.0);
    const double distance = std::abs(smooth.point(n).x + 0.5);
    if (distance > 0.85 * reach)
    {
      // Measured: .43; without a weight that begins at 0 up to 2.1 (.7 to 1 as a mean).
      EXPECT_LT(glm::degrees(std::acos(cosine)), 0.6) << distance;
      begun += distance < reach && cosine < 1.0;
    }
  }
  EXPECT_GT(begun, 20u);
}

TEST(LabelBorders, PartsAreThoseOfTheWhole)
{
  const auto volume =
    floorOf<std::int16_t>([](const glm::dvec3& p) { return 1 + (p.x > 3.0) + 2 * (p.y + 0.3 * p.x > -2.0); });
  const Samples<float> whole = sampleLabels(volume.field());
  const int margin = ink::isoSurfaceResamplingReach(smoothing, 1).x;
  const glm::ivec3 begin(3, 2, 0);
  const glm::ivec3 end(38, 39, 41);
  const Volume<std::int16_t> part = volume.part(begin, end - 1);
  const ink::CellSelection selection = { glm::ivec3(margin, margin, 0),
    end - begin - 1 - glm::ivec3(margin, margin, 0), {} };
  const Samples<float> some = sampleLabels(part.field(), {}, selection);
  ASSERT_GT(some.size(), 20u);
  for (std::size_t n = 0; n < some.size(); ++n)
  {
    std::size_t same = 0;
    while (same < whole.size() && whole.point(same) != some.point(n))
    {
      ++same;
    }
    ASSERT_LT(same, whole.size());
    EXPECT_EQ(whole.normal(same), some.normal(n));
  }
}

TEST(LabelBorders, MissingSamplesHaveNoLabel)
{
  auto labels = floorOf<float>(halves);
  const Samples<float> expected = sampleLabels(labels.field());
  // Out of the surface's reach, but not of what is read; a missing sample would be one of a third label.
  labels.at({ 20, 20, 2 }) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(sampleLabels(labels.field()) == expected);
  labels.at({ 20, 20, 20 }) = std::numeric_limits<float>::quiet_NaN();
  const Samples<float> found = sampleLabels(labels.field());
  ASSERT_LT(found.size(), expected.size());
  for (std::size_t n = 0; n < found.size(); ++n)
  {
    EXPECT_NEAR(glm::length(found.normal(n)), 1.0, 1e-5);
    EXPECT_LT(turnOf(found, n), 60.0);
  }
}

/// What is suggested for a ball with labels.
ink::NoiseEstimate estimateOf(const std::function<int(const glm::dvec3&)>& label)
{
  const GridGeometry geometry({ 48, 48, 48 }, glm::dvec3(-23.5));
  const auto ball = Volume<std::int16_t>::from(
    geometry, [&](const glm::dvec3& p) { return glm::length(p) < 20.0 ? label(p) : 0; });
  return ink::estimateNoise(ball.field(), 0.5);
}

TEST(LabelBorders, AreClearUnlessTheyAreNoise)
{
  const auto isClear = [](const ink::NoiseEstimate& estimate)
  { return ink::suggestSmoothings(estimate, glm::dvec3(1.0)).clearBorders; };
  const ink::NoiseEstimate octants =
    estimateOf([](const glm::dvec3& p) { return 1 + (p.x > 0.0) + 2 * (p.y > 0.0) + 4 * (p.z > 0.0); });
  EXPECT_LT(octants.raggedBorders, 0.05);
  EXPECT_TRUE(isClear(octants));
  const ink::NoiseEstimate one = estimateOf([](const glm::dvec3&) { return 5; });
  EXPECT_EQ(one.raggedBorders, 0.0);
  EXPECT_TRUE(isClear(one));
  // A quarter of the voxels, here and there, have another label.
  const ink::NoiseEstimate speckled = estimateOf(
    [](const glm::dvec3& p)
    {
      const double hash = std::sin(p.x * 12.9898 + p.y * 78.233 + p.z * 37.719) * 43758.5453;
      return hash - std::floor(hash) < 0.25 ? 2 : 1;
    });
  EXPECT_GT(speckled.raggedBorders, 0.15);
  EXPECT_FALSE(isClear(speckled));
  // A rind of what is smoothed with air, whatever the ids.
  const auto rindOf = [](int outer, int inner)
  { return estimateOf([=](const glm::dvec3& p) { return glm::length(p) > 19.2 ? outer : inner; }); };
  const ink::NoiseEstimate rind = rindOf(2, 1);
  EXPECT_GT(rind.raggedBorders, 0.3);
  EXPECT_EQ(rindOf(1, 2).raggedBorders, rind.raggedBorders);
  EXPECT_EQ(rindOf(1, 1000).raggedBorders, rind.raggedBorders);
  EXPECT_FALSE(isClear(rind));
  ink::SuggestedSmoothing both = ink::suggestSmoothings(octants, glm::dvec3(1.0));
  both.add(ink::suggestSmoothings(rind, glm::dvec3(1.0)));
  EXPECT_FALSE(both.clearBorders);
}

} // namespace
