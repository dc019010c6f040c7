// SPDX-License-Identifier: BSD-3-Clause
// Fields of directions that follow what points prefer: against a harmonic map, and one family where there
// were two.

#include "Curves/Streamlines/AlignedLineField.h"

#include "Core/Hash.h"
#include "SampledMeshes.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// A cylinder around the z axis with directions around it and along it, by chance.
struct Mixed
{
  Mesh mesh;
  std::vector<glm::vec3> normals;
  std::vector<glm::dvec3> around;
  std::vector<glm::dvec3> directions;
  std::vector<float> preferences;

  explicit Mixed(std::uint32_t size = 30)
  {
    const std::uint32_t columns = 3 * size;
    for (std::uint32_t row = 0; row <= size; ++row)
    {
      for (std::uint32_t column = 0; column < columns; ++column)
      {
        const std::size_t i = this->mesh.points.size();
        const double angle = 2.0 * std::numbers::pi * column / columns;
        this->mesh.points.emplace_back(std::cos(angle), std::sin(angle), 2.0 * row / size);
        this->normals.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        this->around.emplace_back(-std::sin(angle), std::cos(angle), 0.0);
        this->directions.push_back(isMixed(i) ? glm::dvec3(0.0, 0.0, 1.0) : -this->around.back());
        const auto corner = static_cast<std::uint32_t>(i);
        const std::uint32_t next = row * columns + (column + 1) % columns;
        if (row < size)
        {
          this->mesh.triangles.push_back({ corner, next, next + columns });
          this->mesh.triangles.push_back({ corner, next + columns, corner + columns });
        }
      }
    }
    this->preferences.resize(this->mesh.points.size());
  }
  static bool isMixed(std::size_t i) { return (hash(3, i) & 1) != 0; }
  /// In favor of the one around, or of the other one.
  void prefer(std::size_t i, float preference)
  {
    this->preferences[i] = isMixed(i) ? -preference : preference;
  }
  /// How much a direction is the one around: from 1 to -1, where it is at right angles.
  double likeness(std::size_t i, const std::vector<glm::dvec3>& found) const
  {
    const double cosine = glm::dot(this->around[i], found[i]);
    return 2.0 * cosine * cosine - 1.0;
  }
  std::vector<glm::dvec3> align(double reach, const Progress& progress = {}) const
  {
    return alignedLineField(
      this->mesh.view(), this->normals, this->directions, this->preferences, reach, progress);
  }
};

} // namespace

/// Between two sides of a square that prefer different directions, u is a harmonic function: linear, on a
/// mesh of very different triangles, too.
TEST(AlignedLineField, IsHarmonicWhereNothingIsPreferred)
{
  constexpr int cells = 40;
  constexpr double turn = 60.0 * std::numbers::pi / 180.0;
  Mesh mesh;
  mesh.addPatch(cells, cells, [](double u, double v) { return glm::dvec3(u * u, v, 0.0); });
  const std::vector<glm::vec3> normals(mesh.points.size(), glm::vec3(0.0f, 0.0f, 1.0f));
  std::vector<glm::dvec3> directions(mesh.points.size(), glm::dvec3(1.0, 0.0, 0.0));
  std::vector<float> preferences(mesh.points.size(), 0.0f);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const bool atEnd = mesh.points[i].x == 1.0;
    directions[i] = atEnd ? glm::dvec3(std::cos(turn), std::sin(turn), 0.0) : directions[i];
    preferences[i] = atEnd || mesh.points[i].x == 0.0 ? 1.0f : 0.0f;
  }
  const std::vector<glm::dvec3> found =
    alignedLineField(mesh.view(), normals, directions, preferences, 0.003);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const double x = mesh.points[i].x;
    const double expected = 0.5 * std::arg(1.0 - x + x * std::polar(1.0, 2.0 * turn));
    const double difference = std::atan2(found[i].y, found[i].x) - expected;
    ASSERT_NEAR(std::remainder(difference, std::numbers::pi), 0.0, 0.04) << "x " << x;
    ASSERT_NEAR(glm::length(found[i]), 1.0, 1e-12);
  }
}

/// A preference p counts over reach / sqrt(p): the more, the less one at right angles beside it does.
TEST(AlignedLineField, WeighsPreferences)
{
  Mesh mesh = square(60);
  const std::vector<glm::vec3> normals(mesh.points.size(), glm::vec3(0.0f, 0.0f, 1.0f));
  const std::vector<glm::dvec3> directions(mesh.points.size(), glm::dvec3(1.0, 0.0, 0.0));
  // Where u = 0 lies between halves: screened by their preferences, amplitudes fall off on both sides, and
  // they balance in the middle of equal ones.
  const auto middle = [&](float right)
  {
    std::vector<float> preferences;
    for (const glm::dvec3& p : mesh.points)
    {
      preferences.push_back(p.x < 0.5 ? 0.1f : -right);
    }
    const std::vector<glm::dvec3> found =
      alignedLineField(mesh.view(), normals, directions, preferences, 0.05);
    double along = 0.0;
    for (const glm::dvec3& direction : found)
    {
      along += std::abs(direction.x) > std::numbers::sqrt2 / 2.0 ? 1.0 : 0.0;
    }
    return along / static_cast<double>(found.size());
  };
  EXPECT_NEAR(middle(0.1f), 0.5, 0.02);
  // With k = sqrt(p) / reach on either side: the zero is log((1 + r) / 2) / k_left away, r = k_right /
  // k_left.
  const double expected = 0.5 - std::log(2.0 * 3.0 / (1.0 + 3.0)) / (std::sqrt(0.1) / 0.05);
  EXPECT_NEAR(middle(0.9f), expected, 0.025);
}

/// What one point prefers goes on over all that prefer nothing; either family can be the one.
TEST(AlignedLineField, OneFamilyWhereNothingIsPreferred)
{
  for (const float preference : { 1.0f, -1.0f })
  {
    Mixed cylinder;
    cylinder.prefer(17, preference);
    const std::vector<glm::dvec3> found = cylinder.align(5.0);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_GT(static_cast<double>(preference) * cylinder.likeness(i, found), 0.9) << "point " << i;
    }
  }
}

/// Multigrid: what one point prefers gets to all the others in about as many iterations, each of which tells
/// progress, for any number of points.
TEST(AlignedLineField, FewIterationsForAnySize)
{
  for (const std::uint32_t size : { 30u, 60u, 120u, 240u })
  {
    Mixed cylinder(size);
    cylinder.prefer(17, -1.0f);
    int iterations = 0;
    const std::vector<glm::dvec3> found = cylinder.align(5.0,
      [&](double)
      {
        ++iterations;
        return true;
      });
    EXPECT_LE(iterations, 25) << "size " << size;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_LT(cylinder.likeness(i, found), -0.9) << "size " << size << ", point " << i;
    }
  }
}

/// Halves that are sure of different families keep them, if reach is short; a few that differ do not.
TEST(AlignedLineField, SurePointsKeepTheirs)
{
  Mixed cylinder;
  for (std::size_t i = 0; i < cylinder.directions.size(); ++i)
  {
    const bool noise = hash(4, i) % 20 == 0;
    cylinder.prefer(i, (cylinder.mesh.points[i].x > 0.0) != noise ? 1.0f : -1.0f);
  }
  const std::vector<glm::dvec3> found = cylinder.align(0.2);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const double x = cylinder.mesh.points[i].x;
    ASSERT_TRUE(std::abs(x) < 0.5 || cylinder.likeness(i, found) * x > 0.9 * std::abs(x))
      << "point " << i << ", x " << x;
  }
}

TEST(AlignedLineField, UndefinedPointsAndNothingAtAll)
{
  Mixed cylinder;
  cylinder.prefer(17, 1.0f);
  cylinder.normals[50] = glm::vec3(0.0f);
  const glm::dvec3 given = cylinder.directions[50];
  for (std::size_t i = 100; i < 200; ++i)
  {
    cylinder.directions[i] = glm::dvec3(0.0);
    cylinder.preferences[i] = std::numeric_limits<float>::quiet_NaN();
  }
  const std::vector<glm::dvec3> found = cylinder.align(5.0);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_TRUE(i == 50 || cylinder.likeness(i, found) > 0.9) << "point " << i;
  }
  EXPECT_EQ(found[50], given) << "without a normal";
  EXPECT_TRUE(alignedLineField({}, {}, {}, {}, 1.0).empty());
  EXPECT_TRUE(Mixed().align(5.0) == Mixed().directions) << "no preference";
}

/// A mesh in other units has the same directions, also where squares of them underflow.
TEST(AlignedLineField, DoesNotDependOnUnits)
{
  Mixed cylinder;
  for (std::size_t i = 0; i < cylinder.directions.size(); ++i)
  {
    cylinder.prefer(i, 2.0f * static_cast<float>(unitDouble(hash(5, i))) - 1.0f);
  }
  const std::vector<glm::dvec3> found = cylinder.align(0.5);
  for (const double unit : { 0x1p-200, 0x1p200 })
  {
    Mixed scaled = cylinder;
    for (glm::dvec3& point : scaled.mesh.points)
    {
      point *= unit;
    }
    EXPECT_TRUE(scaled.align(0.5 * unit) == found) << unit;
  }
}

/// Points closer than the reach by far are put together: the field is that of a coarser mesh, and smooth.
TEST(AlignedLineField, OfFineMeshesAsOfCoarseOnes)
{
  const auto field = [](std::uint32_t size)
  {
    Mixed cylinder(size);
    for (std::size_t i = 0; i < cylinder.preferences.size(); ++i)
    {
      const double wanted = 0.3 * std::sin(2.0 * cylinder.mesh.points[i].z) + 0.5 * cylinder.mesh.points[i].x;
      cylinder.directions[i] =
        glm::normalize(std::cos(wanted) * cylinder.around[i] + std::sin(wanted) * glm::dvec3(0.0, 0.0, 1.0));
      cylinder.preferences[i] = 0.5f;
    }
    return std::pair(cylinder, cylinder.align(0.3));
  };
  constexpr std::uint32_t share = 8;
  const auto [coarse, expected] = field(30);
  const auto [fine, found] = field(30 * share);
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const std::size_t same = i / 90 * share * 90 * share + i % 90 * share;
    largest = std::max(largest, std::acos(std::min(std::abs(glm::dot(expected[i], found[same])), 1.0)));
  }
  EXPECT_LT(largest, 0.08); // measured: 0.061
  double step = 0.0;
  for (std::size_t i = 0; i + 1 < found.size(); ++i)
  {
    if (glm::distance(fine.mesh.points[i], fine.mesh.points[i + 1]) < 0.02)
    {
      step = std::max(step, std::acos(std::min(std::abs(glm::dot(found[i], found[i + 1])), 1.0)));
    }
  }
  EXPECT_LT(step, 0.02);
}

TEST(AlignedLineField, TellsProgressAndStops)
{
  constexpr double reach = 0.3; // so short that each point is an unknown
  Mixed cylinder;
  cylinder.prefer(17, -1.0f);
  std::vector<double> told;
  const auto align = [&](std::size_t most)
  {
    told.clear();
    return cylinder.align(reach,
      [&](double done)
      {
        told.push_back(done);
        return told.size() < most;
      });
  };
  EXPECT_TRUE(align(1000) == cylinder.align(reach));
  EXPECT_GT(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
  EXPECT_TRUE(cylinder.align(reach) != cylinder.directions);
  EXPECT_TRUE(align(2) == cylinder.directions);
  EXPECT_EQ(told.size(), 2u);
}

TEST(AlignedLineField, Errors)
{
  const Mixed cylinder;
  const std::vector<float> few(3);
  EXPECT_THROW(alignedLineField(cylinder.mesh.view(), cylinder.normals, cylinder.directions, few, 1.0),
    std::invalid_argument);
}
