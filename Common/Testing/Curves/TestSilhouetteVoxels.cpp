// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticFields.h"
#include "HashNoise.h"
#include "SampledVolume.h"

#include "Curves/Contours/SilhouetteVoxels.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::EdgeVoxels;
using ink::Eye;
using ink::GridGeometry;
using ink::SilhouetteCriteria;

const Sphere Ball{ { 0.2, -0.3, 0.1 }, 12.0 };
const glm::dvec3 Smoothing(1.0);

/// What a scanner sees of a ball: 100 inside, 0 outside, blurred by a Gaussian of deviation 1.
template <class T>
Volume<T> scan(const GridGeometry& grid)
{
  return Volume<T>::from(
    grid, [](const glm::dvec3& p) { return 50.0 * std::erfc(Ball.distance(p) / std::sqrt(2.0)); });
}

const GridGeometry Grid({ 36, 36, 36 }, glm::dvec3(-17.5));
const Eye Aside = Eye::at({ 70.0, 40.0, 50.0 });

SilhouetteCriteria onEdges(float largestCosine)
{
  SilhouetteCriteria criteria;
  criteria.leastMagnitude = 10.0f;
  criteria.largestCosine = largestCosine;
  return criteria;
}

TEST(SilhouetteVoxels, EdgesAreWhereTheSurfaceIs)
{
  const auto volume = scan<float>(Grid);
  const EdgeVoxels voxels = ink::findEdgeVoxels(volume.field(), Smoothing, 10.0);
  ASSERT_GT(voxels.samples.size(), 1500u);
  for (std::size_t n = 0; n < voxels.samples.size(); ++n)
  {
    const glm::dvec3 p = voxels.positions[n];
    EXPECT_LT(std::abs(Ball.distance(p)), 0.95);
    EXPECT_EQ(p,
      Grid.toWorld(
        glm::dvec3(voxels.samples[n] % 36, voxels.samples[n] / 36 % 36, voxels.samples[n] / 1296)));
    EXPECT_EQ(voxels.values[n], volume.values[voxels.samples[n]]);
    EXPECT_GT(glm::dot(glm::normalize(glm::dvec3(voxels.gradients[n])), -Ball.gradient(p)), 0.99);
    EXPECT_TRUE(n == 0 || voxels.samples[n - 1] < voxels.samples[n]);
  }
  // No holes: every line of samples along x through the ball's middle enters and leaves it at an edge.
  for (int k = 8; k < 28; ++k)
  {
    for (int j = 12; j < 24; ++j)
    {
      const std::size_t row = Grid.offset({ 0, j, k });
      const auto count = std::count_if(voxels.samples.begin(), voxels.samples.end(),
        [row](std::size_t sample) { return sample >= row && sample < row + 36; });
      EXPECT_GE(count, 2);
    }
  }
}

TEST(SilhouetteVoxels, EachCriterionCounts)
{
  SilhouetteCriteria criteria;
  criteria.lowest = 10.0f;
  criteria.highest = 20.0f;
  criteria.leastMagnitude = 3.0f;
  criteria.largestCosine = 0.5f;
  const glm::vec3 gradient(0.0f, 0.0f, 4.0f);
  const glm::vec3 toEye(10.0f, 0.0f, 0.0f);
  EXPECT_TRUE(criteria.accept(15.0f, gradient, toEye));
  EXPECT_TRUE(criteria.accept(10.0f, gradient, toEye));
  EXPECT_TRUE(criteria.accept(20.0f, gradient, toEye));
  EXPECT_FALSE(criteria.accept(9.9f, gradient, toEye));
  EXPECT_FALSE(criteria.accept(20.1f, gradient, toEye));
  EXPECT_TRUE(criteria.accept(15.0f, 0.75f * gradient, toEye));
  EXPECT_FALSE(criteria.accept(15.0f, 0.7f * gradient, toEye));
  for (const float side : { -1.0f, 1.0f })
  {
    // tan 60 degrees is 1.732.
    EXPECT_TRUE(criteria.accept(15.0f, gradient, { 1.74f, 0.0f, side }));
    EXPECT_FALSE(criteria.accept(15.0f, gradient, { 1.72f, 0.0f, side }));
  }
  EXPECT_FALSE(criteria.accept(std::numeric_limits<float>::quiet_NaN(), gradient, toEye));
}

/// The distance from the circle in which an eye sees the ball.
double fromCircle(const glm::dvec3& p, const Eye& eye)
{
  const glm::dvec3 view = eye.from(Ball.center);
  const double share = Ball.radius / glm::length(view);
  const double along = glm::dot(p - Ball.center, glm::normalize(view)) - share * Ball.radius;
  const double across = glm::length(glm::cross(p - Ball.center, glm::normalize(view)));
  return std::hypot(along, across - Ball.radius * std::sqrt(1.0 - share * share));
}

TEST(SilhouetteVoxels, SegmentsAreTangentToTheContour)
{
  const auto volume = scan<float>(Grid);
  const EdgeVoxels voxels = ink::findEdgeVoxels(volume.field(), Smoothing, 10.0);
  std::size_t before = 0;
  for (const float cosine : { 0.02f, 0.06f, 0.15f })
  {
    const auto selected = ink::selectSilhouetteVoxels(voxels, onEdges(cosine), Aside);
    EXPECT_GT(selected.size(), before);
    before = selected.size();
    for (const std::uint32_t n : selected)
    {
      const glm::dvec3 p = voxels.positions[n];
      EXPECT_LT(fromCircle(p, Aside), 1.0 + 1.1 * cosine * Ball.radius);
      const auto ends = ink::silhouetteSegment(p, voxels.gradients[n], Aside.from(p), 1.5);
      EXPECT_NEAR(glm::distance(ends[0], ends[1]), 1.5, 1e-12);
      EXPECT_LT(glm::distance(0.5 * (ends[0] + ends[1]), p), 1e-12);
      const glm::dvec3 along = (ends[1] - ends[0]) / 1.5;
      const glm::dvec3 truth = glm::normalize(glm::cross(p - Ball.center, Aside.from(Ball.center)));
      EXPECT_GT(std::abs(glm::dot(along, truth)), 0.95);
    }
  }
  const auto none = ink::silhouetteSegment({ 1.0, 2.0, 3.0 }, { 0.0f, 0.0f, 2.0f }, { 0.0, 0.0, 5.0 }, 1.0);
  EXPECT_EQ(none[0], glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(none[1], none[0]);
}

TEST(SilhouetteVoxels, SegmentsAsContours)
{
  const auto volume = scan<float>(Grid);
  const EdgeVoxels voxels = ink::findEdgeVoxels(volume.field(), Smoothing, 10.0);
  const auto selected = ink::selectSilhouetteVoxels(voxels, onEdges(0.1f), Aside);
  const ink::Contours all = ink::silhouetteSegments(voxels, selected, Aside, 1.5, { true, true, true, true });
  ASSERT_EQ(all.chains.size(), selected.size());
  ASSERT_EQ(all.positions.size(), 2 * selected.size());
  for (std::size_t i = 0; i < selected.size(); ++i)
  {
    const std::uint32_t n = selected[i];
    const auto ends =
      ink::silhouetteSegment(voxels.positions[n], voxels.gradients[n], Aside.from(voxels.positions[n]), 1.5);
    EXPECT_EQ(all.chains.offsets[i + 1], 2 * (i + 1));
    EXPECT_EQ(all.chains.closed[i], 0);
    EXPECT_EQ(all.kinds[i], ink::ContourKind::Silhouette);
    for (std::size_t end = 0; end < 2; ++end)
    {
      EXPECT_EQ(all.positions[2 * i + end], ends[end]);
      EXPECT_GT(glm::dot(glm::dvec3(all.normals[2 * i + end]), Ball.gradient(voxels.positions[n])), 0.99);
      EXPECT_EQ(all.arcLength[2 * i + end], end == 0 ? 0.0 : 1.5);
      EXPECT_EQ(all.elements[2 * i + end], static_cast<std::int64_t>(voxels.samples[n]));
      EXPECT_EQ(all.radialCurvature[2 * i + end], 0.0f);
    }
  }
  const ink::Contours bare = ink::silhouetteSegments(voxels, selected, Aside, 1.5, {});
  EXPECT_EQ(bare.positions, all.positions);
  EXPECT_TRUE(bare.normals.empty() && bare.arcLength.empty() && bare.elements.empty());

  const EdgeVoxels again = ink::describeVoxels(volume.field(), voxels.samples);
  EXPECT_EQ(again.samples, voxels.samples);
  EXPECT_EQ(again.positions, voxels.positions);
  EXPECT_EQ(again.gradients, voxels.gradients);
  EXPECT_EQ(again.values, voxels.values);
}

TEST(SilhouetteVoxels, AsTheExhaustiveSearch)
{
  // "Virtually identical results": what one finds, the other finds in the same or the next voxel.
  const auto volume = scan<unsigned char>(Grid);
  const EdgeVoxels voxels = ink::findEdgeVoxels(volume.field(), Smoothing, 10.0);
  const auto selected = ink::selectSilhouetteVoxels(voxels, onEdges(0.12f), Aside);
  const auto searched = ink::searchSilhouetteVoxels(volume.field(), onEdges(0.12f), Aside);
  std::vector<glm::ivec3> a;
  std::vector<glm::ivec3> b;
  const auto sampleOf = [](std::size_t n)
  { return glm::ivec3(static_cast<int>(n % 36), static_cast<int>(n / 36 % 36), static_cast<int>(n / 1296)); };
  for (const std::uint32_t n : selected)
  {
    a.push_back(sampleOf(voxels.samples[n]));
  }
  for (const std::size_t n : searched)
  {
    b.push_back(sampleOf(n));
    EXPECT_LT(fromCircle(Grid.toWorld(b.back()), Aside), 2.5);
  }
  const auto shareFoundBy = [](const std::vector<glm::ivec3>& some, const std::vector<glm::ivec3>& others)
  {
    const auto found = std::count_if(some.begin(), some.end(),
      [&](const glm::ivec3& p)
      {
        return std::any_of(others.begin(), others.end(),
          [&](const glm::ivec3& q)
          {
            const glm::ivec3 apart = glm::abs(p - q);
            return std::max({ apart.x, apart.y, apart.z }) <= 1;
          });
      });
    return static_cast<double>(found) / static_cast<double>(some.size());
  };
  ASSERT_GT(a.size(), 100u);
  ASSERT_GT(b.size(), 100u);
  EXPECT_GT(shareFoundBy(a, b), 0.97);
  EXPECT_GT(shareFoundBy(b, a), 0.97);
}

TEST(SilhouetteVoxels, SameForAnyNumberOfThreadsAndSlabs)
{
  std::uint64_t index = 0;
  const auto noise = Volume<float>::from(
    GridGeometry({ 20, 15, 70 }), [&](const glm::dvec3&) { return hashNormal(1, index++); });
  SilhouetteCriteria criteria;
  const auto find = [&](const char* threads)
  {
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    const EdgeVoxels voxels = ink::findEdgeVoxels(noise.field(), Smoothing);
    EXPECT_GT(voxels.samples.size(), 3000u);
    const auto selected = ink::selectSilhouetteVoxels(voxels, criteria, Aside);
    EXPECT_GT(selected.size(), 100u);
    const auto searched = ink::searchSilhouetteVoxels(noise.field(), criteria, Aside);
    unsetenv("VTK_SMP_MAX_THREADS");
    return std::make_tuple(voxels.samples, voxels.gradients, selected, searched);
  };
  EXPECT_EQ(find("1"), find("2"));
}

TEST(SilhouetteVoxels, MissingSamplesAreNoEdges)
{
  auto volume = scan<float>(Grid);
  for (std::size_t n = 0; n < volume.values.size(); ++n)
  {
    if (n % 36 < 18)
    {
      volume.values[n] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  const EdgeVoxels voxels = ink::findEdgeVoxels(volume.field(), Smoothing, 10.0);
  EXPECT_GT(voxels.samples.size(), 500u);
  for (std::size_t n = 0; n < voxels.samples.size(); ++n)
  {
    EXPECT_GE(voxels.samples[n] % 36, 18u);
    EXPECT_LT(std::abs(Ball.distance(voxels.positions[n])), 1.5);
    EXPECT_TRUE(std::isfinite(glm::length(voxels.gradients[n])));
  }
}

TEST(SilhouetteVoxels, NothingToFind)
{
  const auto constant = Volume<short>(GridGeometry({ 9, 9, 9 }), short{ 7 });
  EXPECT_TRUE(ink::findEdgeVoxels(constant.field(), Smoothing).samples.empty());
  EXPECT_TRUE(ink::searchSilhouetteVoxels(constant.field(), {}, Aside).empty());
  for (const glm::ivec3& n : { glm::ivec3(0), glm::ivec3(0, 4, 4), glm::ivec3(1) })
  {
    const auto none = Volume<float>(GridGeometry(n), 1.0f);
    EXPECT_TRUE(ink::findEdgeVoxels(none.field(), Smoothing).samples.empty());
    EXPECT_TRUE(ink::searchSilhouetteVoxels(none.field(), {}, Aside).empty());
  }
  const auto volume = scan<float>(Grid);
  EXPECT_TRUE(
    ink::findEdgeVoxels(volume.field(), Smoothing, 0.0, [](double) { return false; }).samples.empty());
  EXPECT_THROW(ink::findEdgeVoxels(volume.field(), glm::dvec3(-1.0)), std::invalid_argument);
  EXPECT_THROW(
    ink::searchSilhouetteVoxels(volume.field(), {}, Eye::along(glm::dvec3(0.0))), std::invalid_argument);
  EXPECT_THROW(ink::selectSilhouetteVoxels({}, {}, Eye::along(glm::dvec3(0.0))), std::invalid_argument);
}

} // namespace
