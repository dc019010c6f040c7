// SPDX-License-Identifier: BSD-3-Clause
// Combed directions: neighbors have the same one of two, but where points are sure of theirs.

#include "Curves/Streamlines/CombCrossField.h"

#include "StreamlineShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// A torus with directions of which every other one, by chance, is the one at right angles.
struct Mixed
{
  Shape shape;
  std::vector<glm::dvec3> directions = shape.maximum;
  std::vector<float> preferences = std::vector<float>(shape.mesh.points.size(), 0.0f);

  explicit Mixed(int size = 30)
    : shape(TorusShape().sample(3 * size, size))
  {
    for (std::size_t i = 0; i < this->directions.size(); ++i)
    {
      this->directions[i] = this->isMixed(i) ? this->shape.minimum[i] : this->shape.maximum[i];
    }
  }
  bool isMixed(std::size_t i) const { return (hash(3, i) & 1) != 0; }
  /// In favor of the maximum's direction, or of the other one.
  void prefer(std::size_t i, float preference)
  {
    this->preferences[i] = this->isMixed(i) ? -preference : preference;
  }
  /// Whether a combed direction is the maximum's.
  bool isMaximum(std::size_t i, const std::vector<unsigned char>& exchanged) const
  {
    return this->isMixed(i) == (exchanged[i] != 0);
  }
  std::vector<unsigned char> comb(double reach, const Progress& progress = {}) const
  {
    return combCrossField(
      this->shape.mesh.view(), this->shape.normals, this->directions, this->preferences, reach, progress);
  }
};

} // namespace

/// What one point prefers goes on over all that prefer nothing; either family can be the one.
TEST(CombCrossField, OneFamilyWhereNothingIsPreferred)
{
  for (const float preference : { 1.0f, -1.0f })
  {
    Mixed torus;
    torus.prefer(17, preference);
    const std::vector<unsigned char> exchanged = torus.comb(5.0);
    for (std::size_t i = 0; i < exchanged.size(); ++i)
    {
      ASSERT_EQ(torus.isMaximum(i, exchanged), preference > 0.0f) << "point " << i;
    }
  }
}

/// Multigrid: what one point prefers gets to all the others in about as many iterations, each of which tells
/// progress, for any number of points.
TEST(CombCrossField, FewIterationsForAnySize)
{
  for (const int size : { 30, 60, 120, 240 })
  {
    Mixed torus(size);
    torus.prefer(17, -1.0f);
    int iterations = 0;
    const std::vector<unsigned char> exchanged = torus.comb(5.0,
      [&](double)
      {
        ++iterations;
        return true;
      });
    EXPECT_LE(iterations, 12) << "size " << size;
    for (std::size_t i = 0; i < exchanged.size(); ++i)
    {
      ASSERT_FALSE(torus.isMaximum(i, exchanged)) << "size " << size << ", point " << i;
    }
  }
}

/// Halves that are sure of different families keep them, if reach is short; a few that differ do not.
TEST(CombCrossField, SurePointsKeepTheirs)
{
  Mixed torus;
  for (std::size_t i = 0; i < torus.directions.size(); ++i)
  {
    const bool noise = hash(4, i) % 20 == 0;
    torus.prefer(i, (torus.shape.mesh.points[i].x > 0.0) != noise ? 1.0f : -1.0f);
  }
  const std::vector<unsigned char> exchanged = torus.comb(0.3);
  for (std::size_t i = 0; i < exchanged.size(); ++i)
  {
    const double x = torus.shape.mesh.points[i].x;
    ASSERT_TRUE(std::abs(x) < 0.3 || torus.isMaximum(i, exchanged) == (x > 0.0))
      << "point " << i << ", x " << x;
  }
}

TEST(CombCrossField, UndefinedPointsAndNothingAtAll)
{
  Mixed torus;
  torus.prefer(17, 1.0f);
  for (std::size_t i = 100; i < 200; ++i)
  {
    torus.directions[i] = glm::dvec3(0.0);
    torus.preferences[i] = std::numeric_limits<float>::quiet_NaN();
  }
  const std::vector<unsigned char> exchanged = torus.comb(5.0);
  for (std::size_t i = 0; i < exchanged.size(); ++i)
  {
    ASSERT_TRUE((i >= 100 && i < 200) || torus.isMaximum(i, exchanged)) << "point " << i;
  }
  EXPECT_TRUE(combCrossField({}, {}, {}, {}, 1.0).empty());
  EXPECT_EQ(Mixed().comb(5.0), std::vector<unsigned char>(torus.directions.size(), 0)) << "no preference";
}

TEST(CombCrossField, TellsProgressAndStops)
{
  Mixed torus;
  torus.prefer(17, -1.0f);
  const std::vector<unsigned char> none(torus.directions.size());
  std::vector<double> told;
  const auto comb = [&](std::size_t most)
  {
    told.clear();
    return torus.comb(5.0,
      [&](double done)
      {
        told.push_back(done);
        return told.size() < most;
      });
  };
  EXPECT_EQ(comb(1000), torus.comb(5.0));
  EXPECT_GT(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
  EXPECT_NE(torus.comb(5.0), none);
  EXPECT_EQ(comb(2), none);
  EXPECT_EQ(told.size(), 2u);
}

TEST(CombCrossField, Errors)
{
  const Mixed torus;
  const std::vector<float> few(3);
  EXPECT_THROW(combCrossField(torus.shape.mesh.view(), torus.shape.normals, torus.directions, few, 1.0),
    std::invalid_argument);
}
