// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "Curves/Contours/FacingPlanes.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <utility>
#include <vector>

namespace
{

using Plane = std::pair<glm::dvec3, glm::dvec3>; // normal, position

glm::dvec3 randomVector(std::uint64_t seed, std::uint64_t id)
{
  return { 2.0 * ink::unitDouble(ink::hash(seed, id, 0)) - 1.0,
    2.0 * ink::unitDouble(ink::hash(seed, id, 1)) - 1.0, 2.0 * ink::unitDouble(ink::hash(seed, id, 2)) - 1.0 };
}

/// Of any directions, anywhere in a ball.
std::vector<Plane> randomPlanes(std::size_t count, const ink::UnitBall& ball)
{
  std::vector<Plane> planes;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    planes.emplace_back(glm::dvec3(glm::vec3(glm::normalize(randomVector(1, i)))),
      ball.center + ball.radius / 1.8 * randomVector(2, i));
  }
  return planes;
}

ink::FacingPlanes facingPlanes(const std::vector<Plane>& planes, const ink::UnitBall& ball)
{
  return { planes.size(), ball, [&](std::uint32_t i) { return planes[i]; } };
}

constexpr std::size_t atOnce = ink::FacingPlanes::atOnce;

/// How many planes have a side; fails where that is not the one in double.
int knownSides(const std::vector<Plane>& planes, const ink::FacingPlanes& facing, const ink::Eye& eye)
{
  const ink::FacingPlanes::View view(facing, eye);
  int known = 0;
  for (std::uint32_t begin = 0; begin + atOnce <= planes.size(); begin += atOnce)
  {
    std::uint32_t ids[atOnce];
    std::iota(std::begin(ids), std::end(ids), begin);
    const ink::FacingPlanes::Sides sides = view.sides(ids);
    EXPECT_EQ(sides.front & sides.back, 0u);
    known += std::popcount(sides.front | sides.back);
    for (std::size_t i = 0; i < atOnce; ++i)
    {
      const auto& [normal, position] = planes[begin + i];
      const double exact = glm::dot(normal, eye.from(position));
      EXPECT_FALSE((sides.front >> i & 1) != 0 && !(exact > 0.0)) << begin + i << ": " << exact;
      EXPECT_FALSE((sides.back >> i & 1) != 0 && !(exact < 0.0)) << begin + i << ": " << exact;
    }
  }
  return known;
}

} // namespace

TEST(FacingPlanes, SidesAreThoseInDoubleAndFewAreMissing)
{
  // Wherever the surface is and whatever its size.
  for (const ink::UnitBall& ball : { ink::UnitBall{ glm::dvec3(0.0), 1.0 },
         ink::UnitBall{ glm::dvec3(1e7, -2e7, 3e6), 1e-2 }, ink::UnitBall{ glm::dvec3(5.0), 1e9 } })
  {
    const std::vector<Plane> planes = randomPlanes(80'000, ball);
    const ink::FacingPlanes facing = facingPlanes(planes, ball);
    for (const glm::dvec3& eye : { glm::dvec3(2, 1, 3), glm::dvec3(0.1, -0.2, 0.3), glm::dvec3(1e4, 2e4, -1e4) })
    {
      EXPECT_GT(knownSides(planes, facing, ink::Eye::at(ball.center + ball.radius * eye)), 79'980);
      EXPECT_GT(knownSides(planes, facing, ink::Eye::along(1e-3 * eye)), 79'980);
    }
  }
}

TEST(FacingPlanes, ClaimNothingOfPlanesThroughTheEye)
{
  const ink::UnitBall ball;
  std::vector<Plane> planes = randomPlanes(8'000, ball);
  const glm::dvec3 eye(2, 1, 3);
  for (Plane& plane : planes)
  {
    plane.first = glm::dvec3(glm::vec3(glm::normalize(glm::cross(eye - plane.second, plane.first))));
  }
  // n.v is 0 but for the rounding of n.
  EXPECT_EQ(knownSides(planes, facingPlanes(planes, ball), ink::Eye::at(eye)), 0);
}

TEST(FacingPlanes, ClaimNothingWithoutNormalsAndBeyondFloat)
{
  const ink::UnitBall ball;
  std::vector<Plane> planes = randomPlanes(atOnce, ball);
  EXPECT_EQ(knownSides(planes, facingPlanes(planes, ball), ink::Eye::at({ 1e200, 1e300, -1e300 })), 0);
  for (Plane& plane : planes)
  {
    plane.first = glm::dvec3(0.0);
  }
  EXPECT_EQ(knownSides(planes, facingPlanes(planes, ball), ink::Eye::at({ 2, 1, 3 })), 0);
}
