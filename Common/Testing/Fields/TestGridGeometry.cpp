// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/Grid/GridGeometry.h"

#include "Fields/SampleBox.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

const glm::dmat3 rotation(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, -2.0, 0.5)));
const glm::dmat3 mirror(-1, 0, 0, 0, 1, 0, 0, 0, 1);
const glm::dmat3 shear(1, 0, 0, 0.4, 1, 0, 0, 0.2, 1);

TEST(GridGeometry, FollowsTheImageConvention)
{
  const ink::GridGeometry g({ 4, 5, 6 }, { 10, 20, 30 }, { 1, 2, 4 }, rotation, { 3, -2, 1 });
  const glm::dvec3 expected =
    glm::dvec3(10, 20, 30) + rotation * glm::dvec3((3 + 1) * 1, (-2 + 2) * 2, (1 + 3) * 4);
  EXPECT_LT(glm::distance(g.toWorld({ 1, 2, 3 }), expected), 1e-12);
  EXPECT_EQ(g.offset({ 1, 2, 3 }), 1u + 4 * (2 + 5 * 3));
  EXPECT_EQ(g.sampleCount(), 120u);
}

TEST(GridGeometry, TakesPointsAndDerivativesThere)
{
  // f(p) = c . p + p . A p / 2, whose derivatives per sample step follow from those of the map to the world.
  const glm::dvec3 c(0.3, -1.1, 2.0);
  const glm::dmat3 a(2, 0.5, -1, 0.5, 1, 0.25, -1, 0.25, 3);
  for (const glm::dmat3& direction : { glm::dmat3(1.0), rotation, rotation * mirror, shear * rotation })
  {
    for (const glm::dvec3& spacing :
      { glm::dvec3(1), glm::dvec3(1, 1, 1000), glm::dvec3(0.5, -2, 3), glm::dvec3(1e-9), glm::dvec3(1e9) })
    {
      const ink::GridGeometry g({ 3, 3, 3 }, { 1, 2, 3 }, spacing, direction);
      const glm::dvec3 index(0.25, 1.5, 2.0);
      EXPECT_LT(glm::distance(g.toIndex(g.toWorld(index)), index), 1e-4);

      const glm::dmat3 map = g.stepToWorld();
      const glm::dvec3 gradient = g.gradientToWorld(glm::transpose(map) * c);
      EXPECT_LT(glm::distance(gradient, c), 1e-12);
      const glm::dmat3 hessian = g.hessianToWorld(glm::transpose(map) * a * map);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_LT(glm::distance(hessian[axis], a[axis]), 1e-11);
      }
      const glm::dvec3 along = g.gradientDirection() * (glm::transpose(map) * c);
      EXPECT_LT(glm::distance(glm::normalize(along), glm::normalize(c)), 1e-12);
    }
  }
}

TEST(GridGeometry, ContainsWhatLiesBetweenItsSamples)
{
  const ink::GridGeometry g(
    glm::ivec3(3, 4, 5), glm::dvec3(1.0), glm::dvec3(0.5, -2.0, 4.0), glm::dmat3(1.0), glm::ivec3(2, 0, 0));
  EXPECT_EQ(g.smallestSpacing(), 0.5);
  EXPECT_TRUE(g.contains(g.toWorld(glm::dvec3(0.0))));
  EXPECT_TRUE(g.contains(g.toWorld(glm::dvec3(2.0, 3.0, 4.0))));
  EXPECT_FALSE(g.contains(g.toWorld(glm::dvec3(-0.01, 1.0, 1.0))));
  EXPECT_FALSE(g.contains(g.toWorld(glm::dvec3(1.0, 3.01, 1.0))));
  EXPECT_FALSE(g.contains(glm::dvec3(NAN)));
}

TEST(SampleBox, IsEmptyWithoutExtentAlongAnyAxis)
{
  const glm::ivec3 begin(-3, 2, 5);
  const ink::SampleBox box{ begin, begin + glm::ivec3(3, 4, 5) };
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.count(), 60u);
  EXPECT_EQ((ink::SampleBox{ begin, begin + 1 }).count(), 1u);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int extent : { 0, -2 })
    {
      ink::SampleBox none = box;
      none.end[axis] = begin[axis] + extent;
      EXPECT_TRUE(none.empty()) << axis << ' ' << extent;
      EXPECT_EQ(none.count(), 0u) << axis << ' ' << extent;
    }
  }
}

TEST(GridGeometry, RejectsWhatHasNoInverse)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 zero(0);
  const glm::dvec3 one(1);
  const glm::dmat3 flat(1, 0, 0, 0, 1, 0, 1, 1, 0);
  EXPECT_THROW(ink::GridGeometry({ -1, 2, 2 }), std::invalid_argument);
  EXPECT_THROW(ink::GridGeometry({ 2, 2, 2 }, { nan, 0, 0 }), std::invalid_argument);
  EXPECT_THROW(ink::GridGeometry({ 2, 2, 2 }, zero, { 1, 0, 1 }), std::invalid_argument);
  EXPECT_THROW(ink::GridGeometry({ 2, 2, 2 }, zero, { 1, nan, 1 }), std::invalid_argument);
  EXPECT_THROW(ink::GridGeometry({ 2, 2, 2 }, zero, one, flat), std::invalid_argument);
  EXPECT_THROW(ink::GridGeometry({ 2, 2, 2 }, zero, one, glm::dmat3(nan)), std::invalid_argument);
}

} // namespace
