// SPDX-License-Identifier: BSD-3-Clause
#include "ContourTesting.h"

#include "Curves/Contours/GridContours.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace
{

using namespace ink::testing;

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

} // namespace
