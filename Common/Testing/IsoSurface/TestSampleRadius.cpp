// SPDX-License-Identifier: BSD-3-Clause
// Discs of isoSurfaceSampleRadius leave no holes: every point of a surface lies within the radius of a
// sample.

#include "AnalyticFields.h"
#include "SampledVolume.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace ink::testing;

const int n = 20;

/// The distance from p to the nearest sample, over the radius.
template <class Real>
double gap(const Samples<Real>& samples, const glm::dvec3& p, double radius)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    nearest = std::min(nearest, glm::distance(samples.point(s), p));
  }
  return nearest / radius;
}

const glm::dvec3 spacings[] = { glm::dvec3(1.0), glm::dvec3(1.0, 1.0, 3.0), glm::dvec3(0.2, 1.0, 1.0),
  glm::dvec3(1.0, 1.0, 1000.0) };

/// A plane crosses a cell in a share of its positions along its normal that is the width of the cell there.
TEST(SampleRadius, AreaIsACellsVolumeOverItsWidth)
{
  const glm::dmat3 cells[] = { glm::dmat3(1.0), glm::dmat3(2, 0, 0, 0, 3, 0, 0, 0, 5),
    glm::dmat3(1, 0, 0, 0.5, 2, 0, -1, 0.25, -3) };
  for (const glm::dmat3& cell : cells)
  {
    for (const glm::dvec3& direction : { glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(1, -2, 3) })
    {
      const glm::dvec3 normal = glm::normalize(direction);
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (int corner = 0; corner < 8; ++corner)
      {
        const double height = glm::dot(normal, cell * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2));
        low = std::min(low, height);
        high = std::max(high, height);
      }
      EXPECT_NEAR(
        ink::isoSurfaceSampleArea(cell, normal), std::abs(glm::determinant(cell)) / (high - low), 1e-12);
    }
  }
  EXPECT_DOUBLE_EQ(ink::isoSurfaceSampleArea(cells[1], { 0, 0, 1 }), 6.0);
}

TEST(SampleRadius, CoversPlanes)
{
  std::mt19937 random(7);
  const auto unit = [&] { return 2.0 * (random() / 4294967296.0) - 1.0; };
  double widest = 0.0;
  for (const glm::dvec3& spacing : spacings)
  {
    const ink::GridGeometry g({ n, n, n }, -0.5 * (n - 1) * spacing, spacing);
    const double radius = isoSurfaceSampleRadius(g);
    for (int turn = 0; turn < 25; ++turn)
    {
      // Normals spread over the directions that the cells see, along with the axes and their diagonals.
      glm::dvec3 normal(unit(), unit(), unit());
      normal = turn < 7 ? glm::dvec3((turn + 1) & 1, (turn + 1) >> 1 & 1, (turn + 1) >> 2 & 1) : normal;
      const Plane plane{ spacing * glm::dvec3(0.3 * unit()), glm::normalize(normal / spacing) };
      const auto samples =
        sampleIsoSurface(Volume<double>::from(g, [&](auto p) { return plane.value(p); }).field(), 0.0);
      ASSERT_GT(samples.size(), 0u);
      for (int i = 0; i < 200; ++i)
      {
        // Well inside, where no neighboring cell is cut off by the border.
        glm::dvec3 p = 0.25 * n * spacing * glm::dvec3(unit(), unit(), unit());
        p -= plane.distance(p) * plane.normal;
        const glm::dvec3 inside = glm::abs(p) / (spacing * (0.5 * n - 2.0));
        if (std::max({ inside.x, inside.y, inside.z }) < 1.0)
        {
          widest = std::max(widest, gap(samples, p, radius));
        }
      }
    }
  }
  EXPECT_LT(widest, 1.0);
  // Not much larger than needed either.
  EXPECT_GT(widest, 0.9);
}

/// Where planes follow two axes, samples stand in rows, which are as far apart as cells are long.
TEST(SampleRadius, ReachCoversPlanesAlongTheAxes)
{
  std::mt19937 random(5);
  const auto unit = [&] { return 2.0 * (random() / 4294967296.0) - 1.0; };
  for (const glm::dvec3& spacing : spacings)
  {
    const ink::GridGeometry g({ n, n, n }, -0.5 * (n - 1) * spacing, spacing);
    const double radius = isoSurfaceSampleRadius(g);
    const double reach = ink::isoSurfaceSampleReach(g.stepToWorld());
    double widest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 normal(0.0);
      normal[axis] = 1.0;
      const Plane plane{ 0.3 * spacing, normal };
      const auto samples =
        sampleIsoSurface(Volume<double>::from(g, [&](auto p) { return plane.value(p); }).field(), 0.0);
      for (int i = 0; i < 500; ++i)
      {
        glm::dvec3 p = 0.25 * n * spacing * glm::dvec3(unit(), unit(), unit());
        p[axis] = 0.3 * spacing[axis];
        widest = std::max(widest, gap(samples, p, radius));
      }
    }
    EXPECT_LT(widest, 1.001 * reach) << spacing.x << " " << spacing.y << " " << spacing.z;
    EXPECT_GT(widest, 0.9 * reach) << spacing.x << " " << spacing.y << " " << spacing.z;
  }
  EXPECT_DOUBLE_EQ(ink::isoSurfaceSampleReach(glm::dmat3(1.0)), std::sqrt(2.0 / 3.0));
  EXPECT_DOUBLE_EQ(ink::isoSurfaceSampleReach(glm::dmat3(0.0)), 0.0);
}

TEST(SampleRadius, CoversSpheres)
{
  std::mt19937 random(11);
  std::normal_distribution<double> gauss;
  const glm::dmat3 rotation(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, -2.0, 0.5)));
  for (const glm::dvec3& spacing : { glm::dvec3(1.0), glm::dvec3(1.0, 1.0, 2.0), glm::dvec3(0.5, 1.0, 1.0) })
  {
    const ink::GridGeometry g(
      { 2 * n, n, n }, -rotation * (spacing * glm::dvec3(n, 0.5 * n, 0.5 * n)), spacing, rotation);
    const Sphere sphere{ glm::dvec3(0.123), 0.4 * n * std::min({ spacing.x * 2, spacing.y, spacing.z }) };
    const auto samples =
      sampleIsoSurface(Volume<double>::from(g, [&](auto p) { return sphere.value(p); }).field(), 0.0);
    const double radius = isoSurfaceSampleRadius(g);
    double widest = 0.0;
    for (int i = 0; i < 4000; ++i)
    {
      const glm::dvec3 direction = glm::normalize(glm::dvec3(gauss(random), gauss(random), gauss(random)));
      widest = std::max(widest, gap(samples, sphere.center + sphere.radius * direction, radius));
    }
    EXPECT_LT(widest, 1.0) << spacing.x << " " << spacing.y << " " << spacing.z;
    EXPECT_GT(widest, 0.7);
  }
}

TEST(SampleRadius, IsHalfTheLongestDiagonal)
{
  const ink::GridGeometry straight({ 2, 2, 2 }, glm::dvec3(0), { 1, -2, 2 });
  EXPECT_DOUBLE_EQ(isoSurfaceSampleRadius(straight), 1.5);
  const ink::GridGeometry sheared({ 2, 2, 2 }, glm::dvec3(0), { 1, 1, 1 }, { 1, 0, 0, 1, 1, 0, 0, 0, 1 });
  EXPECT_DOUBLE_EQ(isoSurfaceSampleRadius(sheared), 0.5 * std::sqrt(4.0 + 1.0 + 1.0));
}

} // namespace
