// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/IsoSurfaceSamples.h"
#include "PointSampling/DiscSamples.h"
#include "PointSampling/PoissonDisk.h"
#include "PointSampling/ProgressiveBlueNoise.h"
#include "SampledMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace
{

using namespace ink::test;

struct Discs
{
  std::vector<glm::vec3> centers;
  std::vector<glm::vec3> normals;
  std::vector<float> radii;

  ink::SurfaceDiscs view() const { return { this->centers, this->normals, this->radii }; }
  void add(const glm::vec3& center, const glm::vec3& normal, float radius)
  {
    this->centers.push_back(center);
    this->normals.push_back(normal);
    this->radii.push_back(radius);
  }
};

/// The radius of discs around the points of a grid of squares that leave no holes, as an iso-surface's
/// samples have it.
constexpr float coverOfGrid = 0.5f * std::numbers::sqrt3_v<float>;

/// A unit square, as points of a regular grid.
Discs discsOfSquare(int cells, float height = 0.0f, float up = 1.0f)
{
  Discs discs;
  const float step = 1.0f / static_cast<float>(cells);
  for (int y = 0; y < cells; ++y)
  {
    for (int x = 0; x < cells; ++x)
    {
      discs.add({ (static_cast<float>(x) + 0.5f) * step - 0.5f, (static_cast<float>(y) + 0.5f) * step - 0.5f,
                  height },
        { 0, 0, up }, coverOfGrid * step);
    }
  }
  return discs;
}

/// The vertices of a sphere of radius 1 in about equal distances.
Discs ball(int count)
{
  Discs discs;
  const float step = std::sqrt(4.0f * std::numbers::pi_v<float> / static_cast<float>(count));
  for (int i = 0; i < count; ++i)
  {
    const float z = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float angle = std::numbers::pi_v<float> * (3.0f - std::sqrt(5.0f)) * static_cast<float>(i);
    const float r = std::sqrt(1.0f - z * z);
    const glm::vec3 normal(r * std::cos(angle), r * std::sin(angle), z);
    discs.add(normal, normal, coverOfGrid * step);
  }
  return discs;
}

std::vector<glm::dvec3> positions(
  const Discs& discs, double spacing, std::uint64_t seed = 1, double candidates = ink::defaultCandidates)
{
  std::vector<glm::dvec3> found;
  for (const ink::DiscSample& sample : ink::sampleDiscs(discs.view(), spacing, candidates, seed))
  {
    found.emplace_back(sample.position);
  }
  return found;
}

/// Those in the middle of the square, which the discs overhang.
std::vector<glm::dvec3> inside(const std::vector<glm::dvec3>& all)
{
  std::vector<glm::dvec3> kept;
  std::copy_if(all.begin(), all.end(), std::back_inserter(kept),
    [](const glm::dvec3& p) { return std::max(std::abs(p.x), std::abs(p.y)) < 0.45; });
  return kept;
}

} // namespace

/// Four times as dense as the points, and with a fifth of them: the same pattern.
TEST(DiscSamples, EveryBeginningIsBlueNoiseWhateverThePoints)
{
  const double spacing = 0.012;
  for (const int cells : { 25, 50, 200 })
  {
    const auto all = positions(discsOfSquare(cells), spacing);
    EXPECT_GE(leastDistance(all, all.size()), 0.999 * spacing) << cells;
    const auto middle = inside(all);
    const double expected = 0.81 / ink::areaPerSample(spacing, ink::defaultCandidates);
    EXPECT_NEAR(static_cast<double>(middle.size()), expected, 0.06 * expected) << cells;
    for (const double share : { 0.05, 0.2, 0.5 })
    {
      const auto count = static_cast<std::size_t>(share * static_cast<double>(all.size()));
      const double area =
        static_cast<double>(all.size()) * ink::areaPerSample(spacing, ink::defaultCandidates);
      EXPECT_GT(leastDistance(all, count), 0.6 * ink::hexagonalDistance(area, static_cast<double>(count)))
        << cells << ' ' << share;
    }
  }
}

/// Of cells that are three times as long as wide, at several positions within them: rows do not show.
TEST(DiscSamples, RowsOfLongCellsLeaveNoGaps)
{
  constexpr float length = 0.06f;
  constexpr float width = length / 3.0f;
  const glm::dmat3 cell(width, 0, 0, 0, width, 0, 0, 0, length);
  Discs discs;
  for (int row = 0; row < 16; ++row)
  {
    for (int column = 0; column < 50; ++column)
    {
      const glm::vec2 p = glm::vec2(static_cast<float>(column) * width, static_cast<float>(row) * length);
      discs.add({ p - 0.5f, 0.0f }, { 0, 0, 1 }, static_cast<float>(ink::isoSurfaceSampleRadius(cell)));
    }
  }
  const std::vector<float> areas(discs.centers.size(), width * length);
  const auto rowsOf = [&](float reach)
  {
    const ink::SurfaceDiscs surface{ discs.centers, discs.normals, discs.radii, areas, reach };
    std::array<double, 11> counts{}; // one in the middle between two rows
    std::vector<glm::dvec3> found;
    for (const ink::DiscSample& sample : ink::sampleDiscs(surface, 0.2 * width, ink::defaultCandidates, 1))
    {
      found.emplace_back(sample.position);
    }
    for (const glm::dvec3& p : inside(found))
    {
      const double along = (p.y + 0.5) / length;
      ++counts[static_cast<std::size_t>(11.0 * (along - std::floor(along)))];
    }
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    return *least / *most;
  };
  EXPECT_GT(rowsOf(static_cast<float>(ink::isoSurfaceSampleReach(cell))), 0.8);
  EXPECT_LT(rowsOf(ink::reachOfCubes), 0.5) << "gaps where the reach is that of cubes";
}

TEST(DiscSamples, NumberFollowsTheArea)
{
  for (const double spacing : { 0.02, 0.05 })
  {
    const auto all = positions(ball(20000), spacing);
    const double expected = 4.0 * std::numbers::pi / ink::areaPerSample(spacing, ink::defaultCandidates);
    EXPECT_NEAR(static_cast<double>(all.size()), expected, 0.06 * expected);
    for (const glm::dvec3& p : all)
    {
      EXPECT_NEAR(glm::length(p), 1.0, 1e-3);
    }
  }
}

/// As the samples of cells that measure 1:1:3 have them on a face along the longest edge.
TEST(DiscSamples, NumberFollowsAreasThatAreGiven)
{
  Discs discs;
  constexpr int cells = 99;
  constexpr float step = 1.0f / cells;
  for (int y = 0; y < cells / 3; ++y)
  {
    for (int x = 0; x < cells; ++x)
    {
      discs.add({ (static_cast<float>(x) + 0.5f) * step - 0.5f,
                  3.0f * (static_cast<float>(y) + 0.5f) * step - 0.5f, 0.0f },
        { 0, 0, 1 }, 0.5f * std::sqrt(11.0f) * step);
    }
  }
  const std::vector<float> areas(discs.centers.size(), 3.0f * step * step);
  ink::SurfaceDiscs view = discs.view();
  EXPECT_NEAR(ink::areaOf(view), 11.0 / 12.0, 1e-4);
  view.areas = areas;
  EXPECT_NEAR(ink::areaOf(view), 1.0, 1e-4);
  constexpr double spacing = 0.02;
  std::vector<glm::dvec3> all;
  for (const ink::DiscSample& sample : ink::sampleDiscs(view, spacing, ink::defaultCandidates, 1))
  {
    all.emplace_back(sample.position);
  }
  const double expected = 0.81 / ink::areaPerSample(spacing, ink::defaultCandidates);
  EXPECT_NEAR(static_cast<double>(inside(all).size()), expected, 0.03 * expected);
}

TEST(DiscSamples, OfASurfaceThatChangesALittleMostStay)
{
  const Discs before = ball(20000);
  Discs after;
  for (std::size_t i = 0; i < before.centers.size(); ++i)
  {
    if (i % 2000 != 7)
    {
      after.add(
        before.centers[i] * (1.0f + 1e-7f * static_cast<float>(i % 5)), before.normals[i], before.radii[i]);
    }
  }
  for (const double spacing : { 0.02, 0.04 })
  {
    const auto first = positions(before, spacing);
    std::size_t kept = 0;
    for (const glm::dvec3& p : positions(after, spacing))
    {
      kept += std::any_of(first.begin(), first.end(),
                [&](const glm::dvec3& q) { return glm::distance(p, q) < 0.01 * spacing; })
        ? 1
        : 0;
    }
    EXPECT_GT(static_cast<double>(kept), 0.97 * static_cast<double>(first.size())) << spacing;
  }
}

TEST(DiscSamples, SidesOfASheetDoNotStarveEachOther)
{
  Discs sheet = discsOfSquare(50);
  const Discs back = discsOfSquare(50, -1e-3f, -1.0f);
  for (std::size_t i = 0; i < back.centers.size(); ++i)
  {
    sheet.add(back.centers[i], back.normals[i], back.radii[i]);
  }
  const auto all = positions(sheet, 0.02);
  const auto above = std::count_if(all.begin(), all.end(), [](const glm::dvec3& p) { return p.z > -5e-4; });
  const double half = 0.5 * static_cast<double>(all.size());
  EXPECT_NEAR(static_cast<double>(above), half, 0.03 * half);
  EXPECT_NEAR(half, static_cast<double>(positions(discsOfSquare(50), 0.02).size()), 0.03 * half);
}

TEST(DiscSamples, DoesNotDependOnThreadsOrTheOrderOfDiscs)
{
  const Discs discs = ball(5000);
  const auto run = [&] { return positions(discs, 0.03); };
  const auto one = onThreads(1, run);
  EXPECT_EQ(one, onThreads(2, run));
  EXPECT_NE(one, positions(discs, 0.03, 2));
  Discs turned;
  for (std::size_t i = discs.centers.size(); i-- > 0;)
  {
    turned.add(discs.centers[i], discs.normals[i], discs.radii[i]);
  }
  EXPECT_EQ(one, positions(turned, 0.03));
}

TEST(DiscSamples, LieOnTheDiscTheyName)
{
  const Discs discs = ball(500);
  for (const ink::DiscSample& sample : ink::sampleDiscs(discs.view(), 0.05, ink::defaultCandidates, 1))
  {
    ASSERT_LT(sample.disc, discs.centers.size());
    const glm::vec3 offset = sample.position - discs.centers[sample.disc];
    EXPECT_LT(glm::length(offset), discs.radii[sample.disc]);
    EXPECT_NEAR(glm::dot(offset, discs.normals[sample.disc]), 0.0f, 1e-5f);
  }
}

TEST(DiscSamples, OfExtremes)
{
  EXPECT_TRUE(positions({}, 0.1).empty());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Discs none;
  none.add({ nan, 0, 0 }, { 0, 0, 1 }, 1.0f);
  none.add({ 0, 0, 0 }, { 0, 0, 0 }, 1.0f);
  none.add({ 0, 0, 0 }, { 0, nan, 1 }, 1.0f);
  for (const float radius : { 0.0f, -1.0f, nan, infinity })
  {
    none.add({ 0, 0, 0 }, { 0, 0, 1 }, radius);
  }
  EXPECT_TRUE(positions(none, 0.1).empty());
  Discs one = none;
  one.add({ 5, 5, 5 }, { 0, 0, 2 }, 1.0f);
  for (const glm::dvec3& p : positions(one, 0.1))
  {
    EXPECT_LT(glm::distance(p, glm::dvec3(5.0)), 1.0);
  }
  EXPECT_EQ(positions(one, 10.0).size(), 1u);
  EXPECT_THROW(positions(one, 1e-8), std::invalid_argument);
  for (const float scale : { 1e-9f, 1e9f })
  {
    Discs scaled = ball(1000);
    for (std::size_t i = 0; i < scaled.centers.size(); ++i)
    {
      scaled.centers[i] *= scale;
      scaled.radii[i] *= scale;
    }
    EXPECT_NEAR(static_cast<double>(positions(scaled, 0.1 * static_cast<double>(scale)).size()),
      static_cast<double>(positions(ball(1000), 0.1).size()), 40.0);
  }
}

TEST(DiscSamples, StopsWhenAsked)
{
  const Discs discs = ball(5000);
  double last = 0.0;
  const auto all = ink::sampleDiscs(discs.view(), 0.03, ink::defaultCandidates, 1,
    [&](double done)
    {
      EXPECT_GE(done, last);
      last = done;
      return true;
    });
  EXPECT_FALSE(all.empty());
  EXPECT_DOUBLE_EQ(last, 1.0);
  EXPECT_TRUE(ink::sampleDiscs(discs.view(), 0.03, ink::defaultCandidates, 1,
    [](double done) {
      return done < 0.3;
    }).empty());
}
