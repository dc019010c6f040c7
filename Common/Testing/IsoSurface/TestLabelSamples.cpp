// SPDX-License-Identifier: BSD-3-Clause
// Samples of the surface around labels: those of their mask, whatever their ids are.

#include "AnalyticFields.h"
#include "IsoSurface/CutSamples.h"
#include "IsoSurface/ResampledSamples.h"
#include "SampledVolume.h"
#include "Statistics/NoiseEstimate.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::GridGeometry;
using ink::SmoothingTarget;

constexpr double radius = 24.0;

GridGeometry around(const glm::dvec3& spacing = glm::dvec3(1.0))
{
  const glm::ivec3 n(glm::dvec3(61.0) / spacing + 1.0);
  return GridGeometry(n, -0.5 * spacing * glm::dvec3(n - 1) + glm::dvec3(0.31, 0.17, 0.43), spacing);
}

/// A ball of labels from 1 to 90 in its octants.
template <class T>
Volume<T> octants(const GridGeometry& geometry)
{
  return Volume<T>::from(geometry,
    [](const glm::dvec3& p)
    {
      constexpr int ids[] = { 1, 90, 7, 45, 2, 60, 33, 18 };
      return glm::length(p) < radius ? ids[(p.x > 0.0) + 2 * (p.y > 0.0) + 4 * (p.z > 0.0)] : 0;
    });
}

Volume<std::uint8_t> ball(const GridGeometry& geometry, std::uint8_t inside = 1)
{
  return Volume<std::uint8_t>::from(
    geometry, [=](const glm::dvec3& p) { return glm::length(p) < radius ? inside : 0; });
}

struct Setting
{
  bool ofMask = true;
  double smoothing = 2.0;
  SmoothingTarget target = SmoothingTarget::Normals;
  int subdivision = 1;
};

template <class T>
Samples<float> sample(const ink::GridField<T>& field, const std::vector<double>& isoValues,
  const Setting& setting = {}, const ink::CellSelection& selection = {})
{
  Samples<float> samples;
  const auto grow = [&](std::size_t count) { return samples.grow(count); };
  std::vector<std::size_t> counts;
  ink::sampleResampledIsoSurfaces(field, isoValues, {}, selection,
    ink::makeIsoSurfaceResampling(
      field.geometry(), setting.smoothing, setting.subdivision, setting.target, setting.ofMask),
    0, nullptr, grow, counts);
  EXPECT_EQ(counts.size(), isoValues.size());
  return samples;
}

struct Errors
{
  double angle = 0.0;    ///< of normals, root mean square, degrees
  double distance = 0.0; ///< mean
};

Errors errorsOf(const Samples<float>& samples)
{
  Errors errors;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const double distance = glm::length(samples.point(n));
    const double cosine = glm::dot(samples.normal(n), samples.point(n)) / distance;
    errors.angle += std::pow(std::acos(std::clamp(cosine, -1.0, 1.0)), 2);
    errors.distance += distance - radius;
  }
  const auto count = static_cast<double>(samples.size());
  return { std::sqrt(errors.angle / count) * 180.0 / std::acos(-1.0), errors.distance / count };
}

TEST(LabelSamples, AreThoseOfAMaskWhateverTheIds)
{
  const GridGeometry geometry = around();
  const auto mask = ball(geometry);
  const auto bright = ball(geometry, 255);
  for (const Setting& setting : { Setting{}, Setting{ .smoothing = 0.0 }, Setting{ .subdivision = 2 },
         Setting{ .target = SmoothingTarget::Surface } })
  {
    const Samples<float> expected = sample(mask.field(), { 0.5 }, setting);
    ASSERT_GT(expected.size(), 5000u);
    EXPECT_EQ(sample(octants<std::uint8_t>(geometry).field(), { 0.5 }, setting), expected);
    EXPECT_EQ(sample(octants<std::int16_t>(geometry).field(), { 1.0 }, setting), expected);
    EXPECT_EQ(sample(octants<float>(geometry).field(), { 0.5 }, setting), expected);
    EXPECT_EQ(sample(bright.field(), { 0.5 }, setting), expected) << "not half way from 0 to 255";
    EXPECT_EQ(sample(bright.field(), { 127.5 }, setting), expected);
  }
  // A smoothed mask of 0 and 1 needs no threshold.
  EXPECT_EQ(sample(mask.field(), { 0.5 }, { .ofMask = false }), sample(mask.field(), { 0.5 }));
  // Without it, ids show.
  const auto labels = octants<std::uint8_t>(geometry);
  EXPECT_GT(std::abs(errorsOf(sample(labels.field(), { 0.5 }, { .ofMask = false })).distance), 0.3);
}

TEST(LabelSamples, LieOnASphereWithItsNormals)
{
  const auto errors = [](const glm::dvec3& spacing, const Setting& setting)
  { return errorsOf(sample(octants<std::uint8_t>(around(spacing)).field(), { 0.5 }, setting)); };
  const glm::dvec3 cubes(1.0);
  // Measured: 12.1 degrees without smoothing, 3.4 with 1 and .98 with 2; .015 of distance.
  EXPECT_GT(errors(cubes, { .smoothing = 0.0 }).angle, 8.0);
  EXPECT_LT(errors(cubes, { .smoothing = 1.0 }).angle, 5.0);
  const Errors ofDefault = errors(cubes, {});
  EXPECT_LT(ofDefault.angle, 1.5);
  EXPECT_LT(std::abs(ofDefault.distance), 0.04);
  EXPECT_LT(std::abs(errors(cubes, { .target = SmoothingTarget::Surface }).distance), 0.25);
  // Slices of three voxels' width: 19.9 degrees and 1.5.
  const glm::dvec3 slices(1.0, 1.0, 3.0);
  EXPECT_GT(errors(slices, { .smoothing = 0.0 }).angle, 12.0);
  const Errors ofSlices = errors(slices, { .smoothing = 3.0 });
  EXPECT_LT(ofSlices.angle, 2.5);
  EXPECT_LT(std::abs(ofSlices.distance), 0.1);
}

TEST(LabelSamples, EachIsoValueHasAMaskOfItsOwn)
{
  const auto labels = octants<std::uint8_t>(around());
  const Samples<float> low = sample(labels.field(), { 0.5 });
  const Samples<float> high = sample(labels.field(), { 45.5 });
  ASSERT_GT(high.size(), 1000u);
  ASSERT_NE(high.size(), low.size());
  Samples<float> both = low;
  both.coordinates.insert(both.coordinates.end(), high.coordinates.begin(), high.coordinates.end());
  both.components.insert(both.components.end(), high.components.begin(), high.components.end());
  EXPECT_EQ(sample(labels.field(), { 0.5, 45.5 }), both);
  EXPECT_EQ(sample(labels.field(), { 200.0, 0.5, -3.0, std::numeric_limits<double>::quiet_NaN() }), low);
}

TEST(LabelSamples, MissingSamplesHaveNoSide)
{
  const GridGeometry geometry = around();
  auto labels = octants<float>(geometry);
  auto mask =
    Volume<float>::from(geometry, [](const glm::dvec3& p) { return glm::length(p) < radius ? 1 : 0; });
  for (const glm::ivec3& sample : { glm::ivec3(30, 30, 6), glm::ivec3(30, 54, 30), glm::ivec3(2, 2, 2) })
  {
    labels.at(sample) = mask.at(sample) = std::numeric_limits<float>::quiet_NaN();
  }
  // Also where the value of a missing sample, 0, would be inside.
  for (float& label : labels.values)
  {
    label -= 10.0f;
  }
  const Samples<float> expected = sample(mask.field(), { 0.5 }, { .ofMask = false });
  ASSERT_GT(expected.size(), 5000u);
  EXPECT_EQ(sample(labels.field(), { -9.5 }), expected);
}

TEST(LabelSamples, CutsAreThoseOfAMask)
{
  // Half of a ball.
  const GridGeometry geometry({ 61, 61, 31 }, { -30.2, -30.4, 0.1 }, glm::dvec3(1.0));
  const auto cut = [&](const auto& volume, double isoValue, bool ofMask)
  {
    return ink::sampleCut(volume.field(), isoValue, ink::CutSurface::Cap, glm::ivec3(0),
      geometry.dimensions() - 1, {},
      ink::makeIsoSurfaceResampling(geometry, 2.0, 1, SmoothingTarget::Normals, ofMask));
  };
  const ink::CutSamples expected = cut(ball(geometry), 0.5, false);
  const ink::CutSamples found = cut(octants<std::uint8_t>(geometry), 0.5, true);
  ASSERT_GT(expected.points.size(), 1000u);
  ASSERT_EQ(found.points.size(), expected.points.size());
  for (std::size_t n = 0; n < found.points.size(); ++n)
  {
    ASSERT_LT(glm::distance(found.points[n], expected.points[n]), 1e-9) << n;
    ASSERT_LT(glm::distance(found.normals[n], expected.normals[n]), 1e-9) << n;
  }
}

TEST(LabelSamples, SmoothingIsSuggestedForLabelsAndMasks)
{
  const auto suggest = [](const auto& volume, double isoValue)
  { return ink::suggestSmoothings(ink::estimateNoise(volume.field(), isoValue), volume.geometry.spacing()); };
  const GridGeometry geometry = around();
  for (const ink::SuggestedSmoothing& one : { suggest(ball(geometry), 0.5), suggest(ball(geometry, 255), 1.0),
         suggest(octants<float>(geometry), 0.5), suggest(octants<std::int16_t>(geometry), 45.5) })
  {
    EXPECT_TRUE(one.labels);
    EXPECT_EQ(one.byValues.ofLabels, 2.0);
  }
  EXPECT_FALSE(suggest(Volume<float>(geometry, 1.0f), 0.5).labels);
  EXPECT_EQ(suggest(octants<float>(geometry), 95.0).byValues.ofLabels, 0.0) << "no surface";
  EXPECT_EQ(suggest(ball(around({ 1.0, 1.0, 3.0 })), 0.5).byValues.ofLabels, 3.0);
  EXPECT_EQ(suggest(ball(around({ 1.0, 1.0, 6.0 })), 0.5).byValues.ofLabels, 4.0);
  // A scan: edges are blurred.
  const auto scan = Volume<std::int16_t>::from(
    geometry, [](const glm::dvec3& p) { return 500.0 * std::erfc((glm::length(p) - radius) / 0.99); });
  EXPECT_FALSE(suggest(scan, 500.0).labels);
}

TEST(LabelSamples, SmoothingIsThatOfTheSurfacesOwnEdge)
{
  const auto isMask = [](const auto& volume, double isoValue)
  { return ink::suggestSmoothings(ink::estimateNoise(volume.field(), isoValue), glm::dvec3(1.0)).labels; };
  // A brain that was cut out of a scan: folds within it, nothing around it.
  const auto brain = Volume<std::uint8_t>::from(around(),
    [](const glm::dvec3& p)
    { return glm::length(p) < radius ? 90.0 + 30.0 * std::sin(0.5 * p.x) * std::sin(0.4 * p.y) : 0.0; });
  EXPECT_TRUE(isMask(brain, 14.0));
  EXPECT_FALSE(isMask(brain, 105.0));
  // Labels differ more from each other than from what is around them.
  EXPECT_TRUE(isMask(octants<std::int16_t>(around()), 0.5));
  const auto layers = Volume<std::int16_t>::from(around(),
    [](const glm::dvec3& p) {
      return glm::length(p) > radius ? 0 : glm::length(p) > radius - 1.2 ? 5 : 1000;
    });
  EXPECT_TRUE(isMask(layers, 0.5));
  // What rises slowly from a constant, as distances and clipped fields do.
  const auto slope =
    Volume<float>::from(around(), [](const glm::dvec3& p) { return std::max(radius - glm::length(p), 0.0); });
  EXPECT_FALSE(isMask(slope, 0.1));
  EXPECT_FALSE(isMask(slope, 8.0));
}

} // namespace
