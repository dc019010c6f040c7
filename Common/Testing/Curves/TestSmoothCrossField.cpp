// SPDX-License-Identifier: BSD-3-Clause
// Smoothed directions: those that are defined stay, the others follow them, signs and names do not matter.

#include "Curves/Streamlines/SmoothCrossField.h"

#include "StreamlineShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace
{

using namespace ink;
using namespace ink::test;

/// The angle between the crosses of two directions, in degrees, up to 45.
double crossAngle(const glm::dvec3& a, const glm::dvec3& b)
{
  const double angle = std::acos(std::clamp(std::abs(glm::dot(a, b)), 0.0, 1.0)) * 180.0 / std::numbers::pi;
  return std::min(angle, 90.0 - angle);
}

/// A torus whose directions are wrong in a band, where they have random angles and are said to be umbilic.
struct Disturbed
{
  Shape shape = TorusShape().sample(90, 30);
  std::vector<glm::dvec3> directions = shape.maximum;
  std::vector<float> umbilics = std::vector<float>(shape.mesh.points.size(), 0.0f);

  Disturbed()
  {
    for (std::size_t i = 0; i < this->directions.size(); ++i)
    {
      if (this->isInBand(i))
      {
        const double angle = 2.0 * std::numbers::pi * unitDouble(hash(5, i));
        this->directions[i] =
          std::cos(angle) * this->shape.maximum[i] + std::sin(angle) * this->shape.minimum[i];
        this->umbilics[i] = 1.0f;
      }
      else if (hash(6, i) & 1)
      {
        this->directions[i] *= -1.0;
      }
    }
  }
  bool isInBand(std::size_t i) const { return this->shape.mesh.points[i].x > 1.9; }
  /// The largest angle between the crosses of smoothed and true directions, in the band.
  double worst(const std::vector<glm::dvec3>& smooth) const
  {
    double result = 0.0;
    for (std::size_t i = 0; i < smooth.size(); ++i)
    {
      result = this->isInBand(i) ? std::max(result, crossAngle(smooth[i], this->shape.maximum[i])) : result;
    }
    return result;
  }
  std::vector<glm::dvec3> smooth(const std::vector<glm::dvec3>& from, int iterations = 1000) const
  {
    return smoothCrossField(this->shape.mesh.view(), this->shape.normals, from, this->umbilics, iterations);
  }
};

} // namespace

TEST(SmoothCrossField, FollowsWhatIsDefinedAround)
{
  const Disturbed torus;
  EXPECT_GT(torus.worst(torus.directions), 40.0);
  const std::vector<glm::dvec3> smooth = torus.smooth(torus.directions);
  // Not 0: across the band, lines of curvature are not the straightest ones.
  EXPECT_LT(torus.worst(smooth), 20.0);
  for (std::size_t i = 0; i < smooth.size(); ++i)
  {
    EXPECT_NEAR(glm::length(smooth[i]), 1.0, 1e-9);
    EXPECT_NEAR(glm::dot(smooth[i], glm::dvec3(torus.shape.normals[i])), 0.0, 1e-6);
    if (!torus.isInBand(i))
    {
      EXPECT_EQ(smooth[i], torus.directions[i]);
    }
  }
}

TEST(SmoothCrossField, NamesAndSignsDoNotMatter)
{
  const Disturbed torus;
  std::vector<glm::dvec3> renamed = torus.directions;
  for (std::size_t i = 0; i < renamed.size(); ++i)
  {
    const std::uint64_t random = hash(9, i);
    if (random & 1)
    {
      renamed[i] = glm::cross(glm::dvec3(torus.shape.normals[i]), renamed[i]);
    }
    renamed[i] *= random & 2 ? -1.0 : 1.0;
  }
  const std::vector<glm::dvec3> first = torus.smooth(torus.directions, 100);
  const std::vector<glm::dvec3> second = torus.smooth(renamed, 100);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_LT(crossAngle(first[i], second[i]), 0.5) << i;
    // Each keeps its name: it is the closest of four.
    EXPECT_GT(glm::dot(second[i], renamed[i]), 0.7) << i;
  }
}

TEST(SmoothCrossField, UndefinedDirectionsGetOne)
{
  Disturbed torus;
  for (std::size_t i = 0; i < torus.directions.size(); ++i)
  {
    torus.directions[i] = torus.isInBand(i) ? glm::dvec3(0.0) : torus.directions[i];
  }
  EXPECT_LT(torus.worst(torus.smooth(torus.directions)), 20.0);
  const std::vector<glm::dvec3> none(torus.directions.size(), glm::dvec3(0.0));
  EXPECT_EQ(torus.smooth(none, 10), none);
}

TEST(SmoothCrossField, TheSameForAnyNumberOfThreads)
{
  const Disturbed torus;
  const auto run = [&] { return torus.smooth(torus.directions, 20); };
  EXPECT_EQ(onThreads(1, run), onThreads(2, run));
}

TEST(SmoothCrossField, SizesHaveToAgree)
{
  const Disturbed torus;
  EXPECT_THROW(smoothCrossField(torus.shape.mesh.view(), {}, torus.directions, torus.umbilics, 1),
    std::invalid_argument);
}
