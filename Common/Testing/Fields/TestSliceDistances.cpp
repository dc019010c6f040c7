// SPDX-License-Identifier: BSD-3-Clause
// Distances within slices against discs, and the surfaces that are interpolated of them against a slanted
// cylinder.

#include "AnalyticFields.h"
#include "Core/OtherAxes.h"
#include "Fields/Resampling/SliceDistances.h"
#include "HashNoise.h"
#include "IsoSurface/CutSamples.h"
#include "IsoSurface/ResampledSamples.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::GridGeometry;
using ink::ThickSlices;

GridGeometry centered(const glm::ivec3& n, const glm::dvec3& spacing)
{
  return GridGeometry(n, -0.5 * spacing * glm::dvec3(n - 1), spacing);
}

/// Blurred within slices, not across them.
double stepAt(double distance)
{
  return 0.5 * std::erfc(distance / 0.99);
}

template <class T>
std::vector<float> distancesOf(const Volume<T>& volume, double isoValue, bool ofMask = false)
{
  return ink::sliceDistances(
    volume.field(), isoValue, ofMask, ink::thickSlices(volume.geometry.spacing()).value());
}

TEST(SliceDistances, SlicesAreThickFromARatioOn)
{
  EXPECT_FALSE(ink::thickSlices({ 1.0, 1.0, 1.0 }));
  EXPECT_FALSE(ink::thickSlices({ 1.0, 1.7, 1.0 }));
  EXPECT_FALSE(ink::thickSlices({ 1.0, 4.0, 4.0 })) << "no slices";
  EXPECT_FALSE(ink::thickSlices({ 1.0, 2.5, 4.0 })) << "1.6 times the longer side";
  const auto slices = ink::thickSlices({ 0.5, -3.0, 1.0 });
  ASSERT_TRUE(slices);
  EXPECT_EQ(slices->axis, 1);
  EXPECT_EQ(slices->sides, glm::dvec2(1.0, 2.0));
  EXPECT_EQ(slices->distance, 6.0);
  EXPECT_EQ(slices->ratio(), 3.0);
  EXPECT_EQ(slices->reach, 9.0);
  EXPECT_EQ(slices->samples(), glm::ivec3(10, 0, 6));
  EXPECT_EQ(ink::thickSlices({ 1.0, 1.0, 100.0 })->reach, ThickSlices::largestReach);
  // Those next to a contour are within it, however long a sample is.
  EXPECT_EQ(ink::thickSlices({ 1.0, 100.0, 1000.0 })->reach, 200.0);
  EXPECT_EQ(ink::thickSlices({ 1.0, 100.0, 1000.0 })->samples(), glm::ivec3(201, 3, 0));
}

/// A disc that is another one in each slice.
TEST(SliceDistances, AreThoseFromDiscs)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [u, v] = ink::otherAxes(axis);
    glm::ivec3 size(61);
    size[v] = 49;
    size[axis] = 7;
    glm::dvec3 spacing(1.0);
    spacing[v] = 1.3;
    spacing[axis] = -5.0;
    const auto radiusAt = [&](const glm::dvec3& p) { return 12.0 + p[axis] / 3.0; };
    const auto volume = Volume<float>::from(centered(size, spacing),
      [&](const glm::dvec3& p) { return 1000.0 * stepAt(std::hypot(p[u], p[v]) - radiusAt(p)); });
    const std::vector<float> distances = distancesOf(volume, 500.0);
    const double reach = ink::thickSlices(spacing)->reach;
    ASSERT_EQ(distances.size(), volume.values.size());
    double most = 0.0;
    for (std::size_t n = 0; n < distances.size(); ++n)
    {
      const auto at = static_cast<int>(n);
      const glm::dvec3 p =
        volume.geometry.toWorld(glm::ivec3(at % size.x, at / size.x % size.y, at / size.x / size.y));
      const double expected = std::clamp(radiusAt(p) - std::hypot(p[u], p[v]), -reach, reach);
      most = std::max(most, std::abs(distances[n] - expected));
    }
    EXPECT_LT(most, 0.08) << "across axis " << axis;
  }
}

TEST(SliceDistances, AreExactFromLinesAndAroundSaddles)
{
  Volume<std::int64_t> line(GridGeometry({ 40, 5, 2 }, {}, { 1.0, 1.0, 2.0 }));
  for (int x = 0; x < 40; ++x)
  {
    for (int n = 0; n < 10; ++n)
    {
      line.at({ x, n % 5, n / 5 }) = 4 * x;
    }
  }
  const std::vector<float> fromLine = distancesOf(line, 30.0);
  for (int x = 0; x < 40; ++x)
  {
    EXPECT_FLOAT_EQ(fromLine[static_cast<std::size_t>(x)], std::clamp(x - 7.5F, -3.0F, 3.0F));
  }
  // As a mask, half way.
  EXPECT_FLOAT_EQ(distancesOf(line, 29.0, true)[8], 0.5F);

  // Two corners above, two below: the middle decides which of them are joined.
  for (const double opposite : { 0.0, 90.0 })
  {
    Volume<double> saddle(GridGeometry({ 2, 2, 2 }, {}, { 1.0, 1.0, 2.0 }));
    saddle.values = { 100.0, opposite, opposite, 100.0, 100.0, opposite, opposite, 100.0 };
    const std::vector<float> distances = distancesOf(saddle, 95.0);
    const bool joined = 0.5 * (100.0 + opposite) >= 95.0;
    // From the end of the side to the segment around the corner that is cut off.
    const double share = 5.0 / (100.0 - opposite);
    const double cornerCut = joined ? 1.0 - share : share;
    EXPECT_NEAR(std::abs(distances[joined ? 1 : 0]), cornerCut / std::sqrt(2.0), 1e-6);
    EXPECT_GT(distances[0], 0.0F);
    EXPECT_LT(distances[1], 0.0F);
  }
}

TEST(SliceDistances, ExtremesAndWhatIsMissing)
{
  const GridGeometry geometry({ 9, 9, 3 }, {}, { 1.0, 1.0, 3.0 });
  const double huge = std::numeric_limits<double>::max();
  const auto halves =
    Volume<double>::from(geometry, [&](const glm::dvec3& p) { return p.x < 4.5 ? huge : -huge; });
  const std::vector<float> ofHuge = distancesOf(halves, 0.0);
  EXPECT_FLOAT_EQ(ofHuge[4], 0.5F);
  EXPECT_FLOAT_EQ(ofHuge[5], -0.5F);

  const auto flat = Volume<float>::from(geometry, [](const glm::dvec3&) { return 3.0; });
  for (const float distance : distancesOf(flat, 3.0))
  {
    EXPECT_EQ(distance, 4.5F) << "as far as distances reach";
  }
  for (const float distance : distancesOf(flat, std::numeric_limits<double>::quiet_NaN()))
  {
    EXPECT_EQ(distance, -4.5F);
  }

  auto holes = Volume<float>::from(geometry, [](const glm::dvec3& p) { return p.x < 4.5 ? 1.0 : 0.0; });
  for (int y = 0; y < 9; ++y)
  {
    holes.at({ 5, y, 1 }) = std::numeric_limits<float>::quiet_NaN();
  }
  const std::vector<float> withHoles = distancesOf(holes, 0.5);
  EXPECT_TRUE(std::isnan(withHoles[geometry.offset({ 5, 4, 1 })]));
  EXPECT_EQ(withHoles[geometry.offset({ 4, 4, 1 })], 4.5F) << "no contour next to what is missing";
  EXPECT_FLOAT_EQ(withHoles[geometry.offset({ 4, 4, 0 })], 0.5F);
  EXPECT_TRUE(std::isnan(distancesOf(holes, 0.5, true)[geometry.offset({ 5, 4, 1 })]));

  EXPECT_TRUE(ink::sliceDistances(flat.field(), 0.0, false, *ink::thickSlices(geometry.spacing()),
    [](double) {
      return false;
    }).empty())
    << "stopped";
}

/// Of noise, which has contours everywhere.
TEST(SliceDistances, WindowsAreThoseOfTheWhole)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 spacing(1.0, 1.4, 1.2);
    spacing[axis] = 3.0;
    std::uint64_t n = 0;
    const auto whole = Volume<float>::from(
      GridGeometry({ 31, 29, 30 }, {}, spacing), [&](const glm::dvec3&) { return hashNormal(5, n++); });
    const ThickSlices slices = ink::thickSlices(spacing).value();
    const glm::ivec3 begin(7, 9, 5);
    const glm::ivec3 size(17, 15, 19);
    const Volume<float> window = whole.part(begin, begin + size - 1);
    for (const bool ofMask : { false, true })
    {
      const std::vector<float> all = distancesOf(whole, 1.2, ofMask);
      const std::vector<float> some = distancesOf(window, 1.2, ofMask);
      const glm::ivec3 margin = slices.samples();
      int compared = 0;
      for (int k = margin.z; k < size.z - margin.z; ++k)
      {
        for (int j = margin.y; j < size.y - margin.y; ++j)
        {
          for (int i = margin.x; i < size.x - margin.x; ++i, ++compared)
          {
            const glm::ivec3 sample(i, j, k);
            ASSERT_EQ(some[window.geometry.offset(sample)], all[whole.geometry.offset(begin + sample)]);
          }
        }
      }
      EXPECT_GT(compared, 100);
    }
  }
}

/// Axis along (slope, 0, 1), from which slices of 6 are sharp.
struct SlantedCylinder
{
  double slope = 0.8;
  double radius = 14.0;

  double distance(const glm::dvec3& p) const
  {
    return std::hypot(p.x - this->slope * p.z, p.y) - this->radius;
  }
  glm::dvec3 outward(const glm::dvec3& p) const
  {
    const double x = p.x - this->slope * p.z;
    return glm::normalize(glm::dvec3(x, p.y, -this->slope * x));
  }
};

struct Setting
{
  bool shapeBased = true;
  double smoothing = 1.0;
  ink::SmoothingTarget target = ink::SmoothingTarget::Surface;
  bool ofMask = false;
  bool borders = false;
  ink::CellSelection selection = {};
};

ink::IsoSurfaceResampling resamplingOf(const GridGeometry& geometry, const Setting& setting)
{
  auto resampling = ink::makeIsoSurfaceResampling(
    geometry, setting.smoothing, 1, setting.target, setting.ofMask, setting.shapeBased);
  resampling.borders = setting.borders;
  return resampling;
}

template <class T>
Samples<float> sample(const ink::GridField<T>& field, const std::vector<double>& isoValues,
  const Setting& setting = {}, std::vector<std::size_t>* perValue = nullptr)
{
  Samples<float> samples;
  std::vector<std::size_t> counts;
  ink::sampleResampledIsoSurfaces(
    field, isoValues, {}, setting.selection, resamplingOf(field.geometry(), setting), 0, nullptr,
    [&](std::size_t count) { return samples.grow(count); }, counts);
  if (perValue)
  {
    *perValue = counts;
  }
  return samples;
}

template <class T = float>
Volume<T> cylinderVolume(double step = 1.0)
{
  const SlantedCylinder cylinder;
  return Volume<T>::from(centered({ 80, 44, 9 }, { 1.0, 1.0, 6.0 }),
    [&](const glm::dvec3& p) { return step * stepAt(cylinder.distance(p)); });
}

/// Root mean square angle in radians.
double angleOf(const Samples<float>& samples)
{
  const SlantedCylinder cylinder;
  double sum = 0.0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const double cosine = glm::dot(samples.normal(n), cylinder.outward(samples.point(n)));
    sum += std::pow(std::acos(std::clamp(cosine, -1.0, 1.0)), 2);
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

/// The purpose: a surface that moves by 4.8 samples from one slice to the next.
TEST(SliceDistances, SlantedSurfacesHaveNoTerraces)
{
  const auto volume = cylinderVolume();
  for (const double isoValue : { 0.05, 0.5 })
  {
    const Samples<float> shapes = sample(volume.field(), { isoValue });
    const Samples<float> values = sample(volume.field(), { isoValue }, { .shapeBased = false });
    ASSERT_GT(shapes.size(), 1000u);
    EXPECT_LT(angleOf(shapes), 0.05) << isoValue;
    EXPECT_GT(angleOf(values), 0.2) << isoValue;
  }
  // Without smoothing and division, too.
  EXPECT_LT(angleOf(sample(volume.field(), { 0.5 }, { .smoothing = 0.0 })), 0.1);
  const Setting normals{ .smoothing = 1.5, .target = ink::SmoothingTarget::Normals };
  EXPECT_LT(angleOf(sample(volume.field(), { 0.5 }, normals)), 0.07);
}

TEST(SliceDistances, CubesStayAsTheyAre)
{
  const Sphere sphere{ { 0.0, 0.0, 0.0 }, 8.0 };
  const auto volume = Volume<float>::from(
    centered(glm::ivec3(24), glm::dvec3(1.0)), [&](const glm::dvec3& p) { return -sphere.value(p); });
  EXPECT_TRUE(sample(volume.field(), { 0.0 }) == sample(volume.field(), { 0.0 }, { .shapeBased = false }));
  EXPECT_TRUE(ink::makeIsoSurfaceResampling(volume.geometry, 0.0, 1, {}, false, true).isIdentity());
  EXPECT_FALSE(
    ink::makeIsoSurfaceResampling(cylinderVolume().geometry, 0.0, 1, {}, false, true).isIdentity());
}

TEST(SliceDistances, EachIsoValueHasItsOwn)
{
  const auto volume = cylinderVolume();
  std::vector<std::size_t> counts;
  const Samples<float> both = sample(volume.field(), { 0.2, 0.7 }, {}, &counts);
  const Samples<float> first = sample(volume.field(), { 0.2 });
  const Samples<float> second = sample(volume.field(), { 0.7 });
  ASSERT_EQ(counts, (std::vector<std::size_t>{ first.size(), second.size() }));
  ASSERT_EQ(both.size(), first.size() + second.size());
  EXPECT_EQ(both.point(0), first.point(0));
  EXPECT_EQ(both.point(first.size()), second.point(0));
  EXPECT_EQ(both.normal(both.size() - 1), second.normal(second.size() - 1));
}

/// Whatever the ids, and with grooves between them.
TEST(SliceDistances, LabelsHaveShapesAndBorders)
{
  const SlantedCylinder cylinder;
  const auto labels = [&](int front, int back)
  {
    return Volume<std::int16_t>::from(cylinderVolume().geometry,
      [&](const glm::dvec3& p) { return cylinder.distance(p) > 0.0 ? 0
                                   : p.y > 0.3                     ? front
                                                                   : back; });
  };
  const auto ones = labels(1, 1);
  const auto ids = labels(7, 300);
  const Setting masks{ .smoothing = 2.0, .ofMask = true };
  const Samples<float> ofOnes = sample(ones.field(), { 0.5 }, masks);
  EXPECT_LT(angleOf(ofOnes), 0.08);
  EXPECT_TRUE(sample(ids.field(), { 0.5 }, masks) == ofOnes);
  Setting borders = masks;
  borders.borders = true;
  EXPECT_TRUE(sample(ones.field(), { 0.5 }, borders) == ofOnes);
  const Samples<float> grooves = sample(ids.field(), { 0.5 }, borders);
  ASSERT_EQ(grooves.size(), ofOnes.size());
  double most = 1.0;
  for (std::size_t n = 0; n < grooves.size(); ++n)
  {
    EXPECT_EQ(grooves.point(n), ofOnes.point(n));
    most = std::min(most, glm::dot(grooves.normal(n), ofOnes.normal(n)));
  }
  EXPECT_LT(most, std::cos(glm::radians(30.0)));
}

TEST(SliceDistances, PartsAndThreadsMakeNoDifference)
{
  const auto whole = cylinderVolume<std::int16_t>(1000.0);
  const Setting setting{ .smoothing = 0.7 };
  const Samples<float> expected = sample(whole.field(), { 400.0 }, setting);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  EXPECT_TRUE(sample(whole.field(), { 400.0 }, setting) == expected) << "one thread";
  unsetenv("VTK_SMP_MAX_THREADS");

  const glm::ivec3 reach =
    ink::isoSurfaceResamplingReach(setting.smoothing, 1, ink::thickSlices(whole.geometry.spacing()));
  EXPECT_LT(reach.z, 8);
  EXPECT_GE(reach.x, 10);
  const glm::ivec3 cells = whole.geometry.dimensions() - 1;
  std::size_t found = 0;
  for (int part = 0; part < 8; ++part)
  {
    const glm::ivec3 upper(part & 1, part >> 1 & 1, part >> 2);
    const glm::ivec3 cut(41, 20, 4);
    const glm::ivec3 begin = upper * cut;
    const glm::ivec3 end = upper * cells + (1 - upper) * cut;
    const glm::ivec3 first = glm::max(begin - reach, glm::ivec3(0));
    const glm::ivec3 last = glm::min(end + reach, cells);
    const Volume<std::int16_t> piece = whole.part(first, last);
    Setting own = setting;
    own.selection = { begin - first, end - first, {} };
    const Samples<float> some = sample(piece.field(), { 400.0 }, own);
    found += some.size();
    for (std::size_t n = 0; n < some.size(); n += 7)
    {
      std::size_t same = 0;
      while (same < expected.size() && expected.point(same) != some.point(n))
      {
        ++same;
      }
      ASSERT_LT(same, expected.size());
      EXPECT_EQ(some.normal(n), expected.normal(same));
    }
  }
  EXPECT_EQ(found, expected.size());
}

/// The rim lies on the surface.
TEST(SliceDistances, CutsAreThoseOfTheSameSurface)
{
  const auto volume = cylinderVolume();
  const ink::CutSamples rim = ink::sampleCut(volume.field(), 0.5, ink::CutSurface::Rim, glm::ivec3(0),
    volume.geometry.dimensions() - 1, {}, resamplingOf(volume.geometry, { .smoothing = 0.0 }));
  ASSERT_GT(rim.points.size(), 60u);
  const SlantedCylinder cylinder;
  double most = 0.0;
  for (const glm::dvec3& point : rim.points)
  {
    most = std::max(most, std::abs(cylinder.distance(point)));
  }
  EXPECT_LT(most, 0.1);
}

} // namespace
