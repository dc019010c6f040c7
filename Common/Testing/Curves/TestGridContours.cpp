// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyticFields.h"
#include "HashNoise.h"
#include "SampledVolume.h"

#include "Curves/Contours/FieldContours.h"
#include "Curves/Contours/GridContours.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace ink::testing;
using ink::ContourArrays;
using ink::Contours;
using ink::Eye;
using ink::GridContourOptions;
using ink::GridContours;
using ink::GridGeometry;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double pi = std::acos(-1.0);
const ContourArrays all{ true, true, true, true };

glm::dvec3 randomDirection(std::uint64_t seed)
{
  return glm::normalize(glm::dvec3(hashNormal(seed, 0), hashNormal(seed, 1), hashNormal(seed, 2)));
}

/// Dense inside.
template <class T, class Shape>
Volume<T> sampled(const GridGeometry& grid, const Shape& shape, double scale = 1.0, double inside = 0.0)
{
  return Volume<T>::from(grid, [&](const glm::dvec3& p) { return inside - scale * shape.distance(p); });
}

GridGeometry cube(int samples, double width)
{
  return GridGeometry(
    glm::ivec3(samples), glm::dvec3(-0.5 * width), glm::dvec3(width / static_cast<double>(samples - 1)));
}

void expectSame(const Contours& a, const Contours& b)
{
  EXPECT_EQ(a.chains.offsets, b.chains.offsets);
  EXPECT_EQ(a.chains.closed, b.chains.closed);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.radialCurvature, b.radialCurvature);
  EXPECT_EQ(a.arcLength, b.arcLength);
  EXPECT_EQ(a.elements, b.elements);
}

/// The circle in which an eye sees a sphere.
struct Circle
{
  glm::dvec3 center;
  glm::dvec3 axis;
  double radius;

  static Circle of(const Sphere& sphere, const Eye& eye)
  {
    const glm::dvec3 view = eye.from(sphere.center);
    if (eye.parallel)
    {
      return { sphere.center, glm::normalize(view), sphere.radius };
    }
    const double share = sphere.radius / glm::length(view);
    return { sphere.center + share * share * view, glm::normalize(view),
      sphere.radius * std::sqrt(1.0 - share * share) };
  }
  double distance(const glm::dvec3& p) const
  {
    const double along = glm::dot(p - this->center, this->axis);
    return std::hypot(along, glm::length(p - this->center - along * this->axis) - this->radius);
  }
};

double greatestDistance(const Circle& circle, const Contours& contours)
{
  double greatest = 0.0;
  for (const glm::dvec3& p : contours.positions)
  {
    greatest = std::max(greatest, circle.distance(p));
  }
  return greatest;
}

const Sphere Ball{ { 0.03, -0.02, 0.05 }, 1.0 };
const std::array<Eye, 3> BallEyes{ Eye::at({ 3.0, 4.0, 5.0 }), Eye::at({ -1.5, 0.2, 0.1 }),
  Eye::along({ 1.0, 2.0, -20.0 }) };

TEST(GridContours, SphereIsSeenAsACircle)
{
  for (const Eye& eye : BallEyes)
  {
    const Circle circle = Circle::of(Ball, eye);
    double before = 0.0;
    for (const int samples : { 17, 33, 65 })
    {
      SCOPED_TRACE(samples);
      const auto volume = sampled<float>(cube(samples, 2.5), Ball);
      const GridContours<float> finder(volume.field(), 0.0);
      const Contours contours = finder.find(eye, all);
      ASSERT_EQ(contours.chains.size(), 1u);
      EXPECT_TRUE(contours.chains.closed[0]);
      EXPECT_EQ(contours.kinds[0], ink::ContourKind::Silhouette);
      // Second order.
      const double distance = greatestDistance(circle, contours);
      EXPECT_LT(distance, before == 0.0 ? 0.05 : before / 3.0);
      before = distance;

      GridContourOptions projected;
      projected.projectionSteps = 8;
      EXPECT_LT(greatestDistance(circle, finder.find(eye, {}, projected)), distance);
    }
  }
}

TEST(GridContours, ArraysDescribeTheSurface)
{
  const auto volume = sampled<double>(cube(65, 2.5), Ball);
  for (const Eye& eye : BallEyes)
  {
    const Contours contours = GridContours<double>(volume.field(), 0.0).find(eye, all);
    const std::size_t count = contours.positions.size();
    ASSERT_EQ(contours.normals.size(), count);
    ASSERT_EQ(contours.radialCurvature.size(), count);
    ASSERT_EQ(contours.arcLength.size(), count);
    ASSERT_EQ(contours.elements.size(), count);
    for (std::size_t n = 0; n < count; ++n)
    {
      const glm::dvec3 p = contours.positions[n];
      const glm::dvec3 next = contours.positions[(n + 1) % count];
      EXPECT_GT(glm::dot(glm::dvec3(contours.normals[n]), Ball.gradient(p)), 0.999);
      EXPECT_NEAR(glm::length(contours.normals[n]), 1.0, 1e-6);
      EXPECT_NEAR(contours.radialCurvature[n], 1.0, 0.03);
      if (n > 0)
      {
        EXPECT_EQ(
          contours.arcLength[n], contours.arcLength[n - 1] + glm::distance(p, contours.positions[n - 1]));
      }
      // The cell of the segment to the next point.
      const int cells = 64;
      const auto element = static_cast<int>(contours.elements[n]);
      const glm::dvec3 cell(element % cells, element / cells % cells, element / (cells * cells));
      const glm::dvec3 in = volume.geometry.toIndex(0.5 * (p + next)) - cell - 0.5;
      EXPECT_LE(std::max({ std::abs(in.x), std::abs(in.y), std::abs(in.z) }), 0.5 + 1e-9);
    }
    EXPECT_EQ(contours.arcLength[0], 0.0);
    const double around =
      contours.arcLength.back() + glm::distance(contours.positions[0], contours.positions.back());
    EXPECT_NEAR(around, 2.0 * pi * Circle::of(Ball, eye).radius, 0.05);

    const Contours bare = GridContours<double>(volume.field(), 0.0).find(eye);
    EXPECT_TRUE(bare.normals.empty() && bare.radialCurvature.empty() && bare.arcLength.empty() &&
      bare.elements.empty());
    EXPECT_EQ(bare.positions, contours.positions);
  }
}

TEST(GridContours, RadialCurvatureTellsWhatHidesItself)
{
  // From far above its axis a torus has an outer circle, and an inner one: both are seen. From the side the
  // inner one of each tube end lies in a saddle.
  const Torus torus{ 1.0, 0.4 };
  const auto volume = sampled<float>(cube(65, 3.2), torus);
  const Contours above = GridContours<float>(volume.field(), 0.0).find(Eye::along({ 0.0, 0.0, -1.0 }), all);
  ASSERT_EQ(above.chains.size(), 2u);
  for (const float curvature : above.radialCurvature)
  {
    EXPECT_NEAR(curvature, 1.0 / torus.minor, 0.1 / torus.minor);
  }
  const Eye eye = Eye::along({ 1.0, 0.0, -0.3 });
  const Contours aside = GridContours<float>(volume.field(), 0.0).find(eye, all);
  int negative = 0;
  for (std::size_t n = 0; n < aside.positions.size(); ++n)
  {
    const double truth = -ink::radialCurvature(torus, eye, aside.positions[n]);
    EXPECT_NEAR(aside.radialCurvature[n], truth, 0.35);
    negative += truth < 0.0;
  }
  EXPECT_GT(negative, 10);
}

/// Seen from outside with the normal upwards, what faces the eye is on the left.
void expectFrontOnTheLeft(const Contours& contours, const Eye& eye)
{
  ASSERT_GT(contours.positions.size(), 10u);
  double left = 0.0;
  double length = 0.0;
  for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
  {
    for (std::size_t n = contours.chains.offsets[chain]; n + 1 < contours.chains.offsets[chain + 1]; ++n)
    {
      const glm::dvec3 along = contours.positions[n + 1] - contours.positions[n];
      const glm::dvec3 view = glm::normalize(eye.from(contours.positions[n]));
      left += glm::dot(glm::cross(glm::dvec3(contours.normals[n]), along), view);
      length += glm::length(along);
    }
  }
  EXPECT_GT(left, 0.9 * length);
}

TEST(GridContours, AnyGrid)
{
  const glm::dmat3 turned(glm::dvec3(0.0, 0.8, 0.6), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.6, -0.8));
  const glm::dmat3 sheared(glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.3, 1.0, 0.0), glm::dvec3(0.0, -0.2, 1.0));
  for (const glm::dmat3& direction : { glm::dmat3(1.0), turned, sheared })
  {
    for (const glm::dvec3& spacing :
      { glm::dvec3(0.1, 0.1, 0.1), glm::dvec3(0.05, -0.1, 0.15), glm::dvec3(-0.08, -0.04, -0.1) })
    {
      const glm::ivec3 first(-7, 3, 100);
      const glm::ivec3 n(glm::ceil(3.4 / glm::abs(spacing)));
      const glm::dvec3 middle = glm::dvec3(first) + 0.5 * glm::dvec3(n - 1);
      const GridGeometry grid(n, Ball.center - direction * (spacing * middle), spacing, direction, first);
      const auto volume = sampled<float>(grid, Ball);
      for (const Eye& eye : BallEyes)
      {
        const Contours contours = GridContours<float>(volume.field(), 0.0).find(eye, all);
        ASSERT_EQ(contours.chains.size(), 1u);
        EXPECT_TRUE(contours.chains.closed[0]);
        EXPECT_LT(greatestDistance(Circle::of(Ball, eye), contours), 0.02);
        expectFrontOnTheLeft(contours, eye);
      }
    }
  }
}

TEST(GridContours, NeitherUnitNorOriginMatters)
{
  const auto plain = sampled<float>(cube(33, 2.5), Ball);
  const Contours expected = GridContours<float>(plain.field(), 0.0).find(BallEyes[0]);
  for (const double unit : { 1e-9, 1e9 })
  {
    Volume<float> scaled(GridGeometry(glm::ivec3(33), glm::dvec3(-1.25 * unit), glm::dvec3(2.5 / 32 * unit)));
    scaled.values = plain.values;
    const Contours contours =
      GridContours<float>(scaled.field(), 0.0).find(Eye::at(unit * BallEyes[0].position));
    ASSERT_EQ(contours.chains.offsets, expected.chains.offsets);
    for (std::size_t n = 0; n < expected.positions.size(); ++n)
    {
      EXPECT_LT(glm::distance(contours.positions[n] / unit, expected.positions[n]), 1e-9);
    }
  }
  const glm::dvec3 far(1e7, -1e7, 1e7);
  Volume<float> moved(GridGeometry(glm::ivec3(33), far + plain.geometry.origin(), plain.geometry.spacing()));
  moved.values = plain.values;
  const Contours contours = GridContours<float>(moved.field(), 0.0).find(Eye::at(far + BallEyes[0].position));
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_LT(
    greatestDistance(Circle::of({ far + Ball.center, 1.0 }, Eye::at(far + BallEyes[0].position)), contours),
    0.02);
}

TEST(GridContours, AThousandTimesAsThickAsWide)
{
  // A ball in steps of the grid: an ellipsoid, whose contour is what the projection says.
  const GridGeometry grid({ 33, 33, 33 }, glm::dvec3(0.0), { 1.0, 1.0, 1000.0 });
  const auto volume = Volume<double>::from(grid,
    [](const glm::dvec3& p)
    { return 12.0 - glm::distance(p / glm::dvec3(1.0, 1.0, 1000.0), glm::dvec3(16.1)); });
  const Eye eye = Eye::at({ 100.0, 120.0, 40000.0 });
  const Contours contours = GridContours<double>(volume.field(), 0.0).find(eye, all);
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_TRUE(contours.chains.closed[0]);
  for (const glm::dvec3& p : contours.positions)
  {
    // Straight lines stay straight lines: in steps of the grid the contour is a circle.
    const Circle circle = Circle::of({ glm::dvec3(16.1), 12.0 }, Eye::at(grid.toIndex(eye.position)));
    EXPECT_LT(circle.distance(grid.toIndex(p)), 0.15);
  }
}

template <class T>
void expectCircleOf(double inside, double scale)
{
  // Coarse enough that few values are equal to their neighbors'.
  const int samples = sizeof(T) == 1 ? 13 : 41;
  const double bound = sizeof(T) == 1 ? 0.2 : 0.03;
  const auto volume = sampled<T>(cube(samples, 2.5), Ball, scale, inside);
  for (const Eye& eye : BallEyes)
  {
    const Contours contours = GridContours<T>(volume.field(), inside + 0.25).find(eye);
    EXPECT_EQ(contours.chains.size(), 1u);
    EXPECT_LT(greatestDistance(Circle::of(Ball, eye), contours), bound);
  }
}

TEST(GridContours, AnyScalarType)
{
  expectCircleOf<char>(20.0, 50.0);
  expectCircleOf<signed char>(-20.0, 60.0);
  expectCircleOf<unsigned char>(150.0, 90.0);
  expectCircleOf<short>(-3000.0, 10000.0);
  expectCircleOf<unsigned short>(40000.0, 15000.0);
  expectCircleOf<int>(1e9, 1e8);
  expectCircleOf<unsigned int>(3e9, 1e8);
  expectCircleOf<long>(1e18, 1e17);
  expectCircleOf<unsigned long>(1e19, 1e18);
  expectCircleOf<long long>(-1e18, 1e17);
  expectCircleOf<unsigned long long>(1e19, 1e18);
  expectCircleOf<float>(0.0, 1e30);
  expectCircleOf<double>(0.0, 1e250);
}

TEST(GridContours, SearchesFewBricks)
{
  const auto volume = sampled<float>(cube(129, 2.5), Ball);
  const GridContours<float> finder(volume.field(), 0.0);
  for (const Eye& eye : BallEyes)
  {
    EXPECT_LT(finder.searchedBrickCount(eye), finder.brickCount() / 8);
  }
}

TEST(GridContours, LeavesNoBrickOut)
{
  // From everywhere: far and near, inside, in parallel; and all chains of a torus are two closed ones.
  const Torus torus{ 1.0, 0.4 };
  const auto volume = sampled<float>(cube(45, 3.2), torus);
  const GridContours<float> finder(volume.field(), 0.0);
  GridContourOptions exhaustive;
  exhaustive.search = ink::SilhouetteSearch::Exhaustive;
  std::size_t searched = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed)
  {
    SCOPED_TRACE(seed);
    const glm::dvec3 direction = randomDirection(seed);
    const Eye eye = seed % 4 == 0 ? Eye::along(direction)
                                  : Eye::at(std::pow(10.0, 2.0 * hashUniform(seed, 9) - 0.5) * direction);
    searched += finder.searchedBrickCount(eye);
    const Contours contours = finder.find(eye);
    expectSame(contours, finder.find(eye, {}, exhaustive));
    EXPECT_EQ(std::count(contours.chains.closed.begin(), contours.chains.closed.end(), 0), 0);
    // Where two curves are about to meet, their number is that of the tetrahedra's surface. From inside there
    // is one.
    const double height = std::abs(eye.parallel ? 10.0 * direction.z : eye.position.z);
    if (!(torus.distance(eye.position) < 0.2) && std::abs(height - torus.minor) > 0.15 && height > 0.15)
    {
      EXPECT_EQ(contours.chains.size(), 2u);
    }
    if (HasFailure())
    {
      return;
    }
  }
  EXPECT_LT(searched, 1000 * finder.brickCount() / 2);
}

/// The number of faces of all tetrahedra that the contour passes.
template <class T>
std::size_t countNodes(const ink::GridField<T>& field, double isoValue, const Eye& eye)
{
  const glm::ivec3 n = field.geometry().dimensions();
  const auto corner = [](int c) { return glm::ivec3(c & 1, c >> 1 & 1, c >> 2); };
  struct End
  {
    double offset;
    double facing;
  };
  const auto endOf = [&](const glm::ivec3& sample)
  {
    return End{ field.at(sample) - isoValue,
      -glm::dot(field.geometry().gradientToWorld(field.gradientAt(sample)),
        eye.from(field.geometry().toWorld(sample))) };
  };
  std::size_t count = 0;
  for (int k = 0; k < n.z; ++k)
  {
    for (int j = 0; j < n.y; ++j)
    {
      for (int i = 0; i < n.x; ++i)
      {
        for (int middle = 1; middle < 7; ++middle)
        {
          for (int last = middle + 1; last < 8; ++last)
          {
            const glm::ivec3 a(i, j, k);
            const glm::ivec3 b = a + corner(middle);
            const glm::ivec3 c = a + corner(last);
            if ((middle & last) != middle || c.x >= n.x || c.y >= n.y || c.z >= n.z)
            {
              continue;
            }
            const std::array<End, 3> ends{ endOf(a), endOf(b), endOf(c) };
            std::vector<bool> front;
            for (int e = 0; e < 3; ++e)
            {
              const End& p = ends[e];
              const End& q = ends[(e + 1) % 3];
              if ((p.offset < 0.0) != (q.offset < 0.0))
              {
                front.push_back((p.facing * q.offset - q.facing * p.offset) * (q.offset - p.offset) >= 0.0);
              }
            }
            count += front.size() == 2 && front[0] != front[1];
          }
        }
      }
    }
  }
  return count;
}

TEST(GridContours, FindsEveryFaceOfNoise)
{
  std::uint64_t index = 0;
  const GridGeometry grid({ 13, 11, 10 }, glm::dvec3(1.0), { 1.0, 0.5, 2.0 });
  const auto noise = Volume<float>::from(grid, [&](const glm::dvec3&) { return hashNormal(3, index++); });
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Eye eye = seed % 2 ? Eye::along(randomDirection(seed)) : Eye::at(20.0 * randomDirection(seed));
    const Contours contours = GridContours<float>(noise.field(), 0.3).find(eye, all);
    EXPECT_EQ(contours.positions.size(), countNodes(noise.field(), 0.3, eye));
    EXPECT_GT(contours.positions.size(), 2000u);
    for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
    {
      if (contours.chains.closed[chain])
      {
        continue;
      }
      // Ends lie on the grid's border.
      for (const std::size_t end : { contours.chains.offsets[chain], contours.chains.offsets[chain + 1] - 1 })
      {
        const glm::dvec3 p =
          glm::abs(2.0 * grid.toIndex(contours.positions[end]) / glm::dvec3(12, 10, 9) - 1.0);
        EXPECT_NEAR(std::max({ p.x, p.y, p.z }), 1.0, 1e-12);
      }
    }
    for (std::size_t n = 0; n < contours.positions.size(); ++n)
    {
      EXPECT_NEAR(glm::length(contours.normals[n]), 1.0, 1e-5);
      EXPECT_TRUE(std::isfinite(contours.radialCurvature[n]));
    }
  }
}

TEST(GridContours, SameForAnyNumberOfThreads)
{
  std::uint64_t index = 0;
  const Torus torus{ 1.0, 0.4 };
  const auto volume = Volume<float>::from(
    cube(65, 3.2), [&](const glm::dvec3& p) { return 0.02 * hashNormal(5, index++) - torus.distance(p); });
  GridContourOptions options;
  options.projectionSteps = 3;
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const Contours one = GridContours<float>(volume.field(), 0.0).find(BallEyes[0], all, options);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  const Contours two = GridContours<float>(volume.field(), 0.0).find(BallEyes[0], all, options);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_GT(one.chains.size(), 10u);
  expectSame(one, two);
}

TEST(GridContours, EndsWhereSamplesAreMissing)
{
  auto volume = sampled<float>(cube(33, 2.5), Ball);
  std::vector<std::uint8_t> marks(volume.values.size(), 0);
  for (std::size_t n = 0; n < marks.size(); ++n)
  {
    if (n % 33 < 16)
    {
      marks[n] = 1;
    }
  }
  const Contours hidden =
    GridContours<float>(volume.field({ marks, 1 }), 0.0).find(Eye::along({ 0.0, 0.0, 1.0 }), all);
  for (std::size_t n = 0; n < marks.size(); ++n)
  {
    if (marks[n])
    {
      volume.values[n] =
        n % 2 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    }
  }
  const Contours contours = GridContours<float>(volume.field(), 0.0).find(Eye::along({ 0.0, 0.0, 1.0 }), all);
  expectSame(contours, hidden);
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_FALSE(contours.chains.closed[0]);
  const double border = volume.geometry.toWorld({ 16, 0, 0 }).x;
  EXPECT_NEAR(contours.positions.front().x, border, 1e-12);
  EXPECT_NEAR(contours.positions.back().x, border, 1e-12);
  EXPECT_NEAR(contours.arcLength.back(), pi, 0.1);
  EXPECT_LT(greatestDistance(Circle::of(Ball, Eye::along({ 0.0, 0.0, 1.0 })), contours), 0.05);
  EXPECT_EQ(contours.elements[contours.elements.size() - 1], contours.elements[contours.elements.size() - 2]);
  // Projected, they stay where the field is defined.
  GridContourOptions projected;
  projected.projectionSteps = 4;
  for (const glm::dvec3& p :
    GridContours<float>(volume.field(), 0.0).find(Eye::along({ 0.0, 0.0, 1.0 }), all, projected).positions)
  {
    EXPECT_GE(p.x, border - 1e-12);
  }
}

TEST(GridContours, SelectedCells)
{
  const auto volume = sampled<float>(cube(33, 2.5), Ball);
  const Eye eye = Eye::along({ 0.0, 0.0, 1.0 });
  ink::CellSelection selection;
  selection.begin.x = 16;
  const Contours half = GridContours<float>(volume.field(), 0.0, selection).find(eye, all);
  ASSERT_EQ(half.chains.size(), 1u);
  EXPECT_FALSE(half.chains.closed[0]);
  EXPECT_NEAR(half.arcLength.back(), pi, 0.1);
}

TEST(GridContours, NothingToFind)
{
  const auto expectNone = [](const Contours& contours)
  {
    EXPECT_EQ(contours.chains.size(), 0u);
    EXPECT_TRUE(contours.positions.empty());
    EXPECT_TRUE(contours.elements.empty());
  };
  const auto volume = sampled<float>(cube(33, 2.5), Ball);
  for (const double isoValue : { 10.0, -10.0, nan, std::numeric_limits<double>::infinity() })
  {
    expectNone(GridContours<float>(volume.field(), isoValue).find(BallEyes[0], all));
  }
  // From inside, all of a ball is seen from behind.
  expectNone(GridContours<float>(volume.field(), 0.0).find(Eye::at(Ball.center), all));
  expectNone(GridContours<float>(volume.field(), 0.0).find(Eye::at({ 0.5, 0.3, -0.2 }), all));
  for (const glm::ivec3& n : { glm::ivec3(0), glm::ivec3(1), glm::ivec3(33, 33, 1), glm::ivec3(1, 33, 33) })
  {
    const auto flat = sampled<float>(GridGeometry(n, glm::dvec3(-1.2), glm::dvec3(0.08)), Ball);
    expectNone(GridContours<float>(flat.field(), 0.0).find(BallEyes[0], all));
  }
  const auto constant = Volume<float>(cube(9, 1.0), 3.0f);
  expectNone(GridContours<float>(constant.field(), 3.0).find(BallEyes[0], all));
  expectNone(GridContours<float>(volume.field(), 0.0, {}, nullptr,
    [](double) {
      return false;
    }).find(BallEyes[0], all));
}

TEST(GridContours, TwoSamplesThick)
{
  // A disk of cells: its contour is that of a cylinder, two lines if seen from the side.
  const GridGeometry grid({ 33, 33, 2 }, { -1.25, -1.25, 0.0 }, { 2.5 / 32, 2.5 / 32, 0.1 });
  const auto disk = Volume<float>::from(grid, [](const glm::dvec3& p) { return 1.0 - std::hypot(p.x, p.y); });
  const Contours contours = GridContours<float>(disk.field(), 0.0).find(Eye::along({ 1.0, 0.01, 0.0 }), all);
  ASSERT_EQ(contours.chains.size(), 2u);
  for (const std::size_t chain : { 0u, 1u })
  {
    EXPECT_FALSE(contours.chains.closed[chain]);
    EXPECT_NEAR(contours.arcLength[contours.chains.offsets[chain + 1] - 1], 0.1, 1e-3);
  }
}

TEST(GridContours, SurfaceThroughSamples)
{
  // Integers at an integer iso-value: many nodes at one sample become one point.
  const auto volume = Volume<unsigned char>::from(GridGeometry({ 33, 33, 33 }),
    [](const glm::dvec3& p)
    { return std::max(0.0, 200.0 - 8.0 * (std::abs(p.x - 16) + std::abs(p.y - 16) + std::abs(p.z - 16))); });
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Eye eye = Eye::along(randomDirection(seed));
    const Contours contours = GridContours<unsigned char>(volume.field(), 104.0).find(eye, all);
    EXPECT_GE(contours.chains.size(), 1u);
    for (std::size_t chain = 0; chain < contours.chains.size(); ++chain)
    {
      EXPECT_TRUE(contours.chains.closed[chain]);
      for (std::size_t n = contours.chains.offsets[chain] + 1; n < contours.chains.offsets[chain + 1]; ++n)
      {
        EXPECT_NE(contours.positions[n], contours.positions[n - 1]);
      }
    }
  }
}

TEST(GridContours, ProjectedPointsLieOnTheContour)
{
  const Torus torus{ 14.0, 6.0 };
  const GridGeometry grid({ 48, 48, 24 }, { -23.5, -23.5, -11.5 });
  const auto scan = Volume<short>::from(
    grid, [&](const glm::dvec3& p) { return 4000.0 * std::erfc(torus.distance(p) / std::sqrt(2.0)); });
  const GridContours<short> finder(scan.field(), 4000.5);
  const double diagonal = std::sqrt(3.0);
  std::size_t others = 0;
  std::size_t count = 0;
  GridContourOptions options;
  options.projectionSteps = 20;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const Eye eye = seed % 2 ? Eye::along(randomDirection(seed)) : Eye::at(60.0 * randomDirection(seed));
    const Contours before = finder.find(eye);
    const Contours after = finder.find(eye, {}, options);
    ASSERT_EQ(before.positions.size(), after.positions.size());
    for (std::size_t n = 0; n < after.positions.size(); ++n)
    {
      const ink::ContourResidual left = ink::contourResidual(scan.field(), 4000.5, eye, after.positions[n]);
      EXPECT_LE(glm::distance(before.positions[n], after.positions[n]), diagonal);
      if (std::abs(left.distance) > 1e-4 * diagonal || std::abs(left.sine) > 1e-4)
      {
        // Where the radial curvature all but vanishes; no farther away than before.
        const ink::ContourResidual was = ink::contourResidual(scan.field(), 4000.5, eye, before.positions[n]);
        EXPECT_LE(std::max(std::abs(left.distance) / diagonal, std::abs(left.sine)),
          std::max(std::abs(was.distance) / diagonal, std::abs(was.sine)));
        ++others;
      }
    }
    count += after.positions.size();
  }
  EXPECT_LT(others, count / 1000);
}

TEST(GridContours, RejectsEyes)
{
  const auto volume = sampled<float>(cube(9, 2.5), Ball);
  const GridContours<float> finder(volume.field(), 0.0);
  EXPECT_THROW(finder.find(Eye::at({ 0.0, nan, 0.0 })), std::invalid_argument);
  EXPECT_THROW(
    finder.find(Eye::along({ 0.0, 0.0, std::numeric_limits<double>::infinity() })), std::invalid_argument);
  try
  {
    finder.find(Eye::along(glm::dvec3(0.0)));
    FAIL() << "a direction of length 0";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()), "the eye's direction is zero, expected a vector into the scene");
  }
}

/// Dense inside.
template <class Shape>
struct Solid
{
  Shape shape;

  double value(const glm::dvec3& p) const { return -this->shape.value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return -this->shape.gradient(p); }
  glm::dmat3 hessian(const glm::dvec3& p) const { return -this->shape.hessian(p); }
};

TEST(FieldContours, LieOnTheFieldsOwnContour)
{
  const ink::FieldContours<Solid<Sphere>> ball({ Ball }, 0.0, cube(13, 2.5));
  for (const Eye& eye : BallEyes)
  {
    const Contours contours = ball.find(eye, all);
    ASSERT_EQ(contours.chains.size(), 1u);
    EXPECT_TRUE(contours.chains.closed[0]);
    EXPECT_LT(greatestDistance(Circle::of(Ball, eye), contours), 2e-4);
    for (const float curvature : contours.radialCurvature)
    {
      EXPECT_NEAR(curvature, 1.0, 1e-3);
    }
    expectFrontOnTheLeft(contours, eye);
  }
  const Torus torus{ 1.0, 0.4 };
  const ink::FieldContours<Solid<Torus>> ring({ torus }, 0.0, cube(33, 3.2));
  for (std::uint64_t seed = 0; seed < 30; ++seed)
  {
    const Eye eye = Eye::at(5.0 * randomDirection(seed));
    const Contours contours = ring.find(eye);
    for (const glm::dvec3& p : contours.positions)
    {
      const ink::ContourResidual left = ink::contourResidual(torus, 0.0, eye, p);
      EXPECT_LT(std::max(std::abs(left.distance), std::abs(left.sine)), 2e-4);
    }
  }
}

/// Not defined where x < 0.
struct HalfBall : Solid<Sphere>
{
  double value(const glm::dvec3& p) const { return p.x < 0.0 ? nan : Solid<Sphere>::value(p); }
};

TEST(FieldContours, EndWhereTheFieldDoes)
{
  const ink::FieldContours<HalfBall> half({ { Ball } }, 0.0, cube(25, 2.5));
  const Contours contours = half.find(Eye::along({ 0.0, 0.0, 1.0 }), all);
  ASSERT_EQ(contours.chains.size(), 1u);
  EXPECT_FALSE(contours.chains.closed[0]);
  EXPECT_NEAR(contours.arcLength.back(), pi, 0.2);
  for (const glm::dvec3& p : contours.positions)
  {
    EXPECT_GE(p.x, 0.0);
  }
}

} // namespace
