// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "Curves/Contours/ClusterPlanes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace
{

using Items = std::vector<ink::NormalCone::Item>;

constexpr std::size_t clusterSize = ink::NormalClusters::clusterSize;
constexpr std::size_t perElement = 2;

glm::dvec3 randomVector(std::uint64_t seed, std::uint64_t id)
{
  return { 2.0 * ink::unitDouble(ink::hash(seed, id, 0)) - 1.0,
    2.0 * ink::unitDouble(ink::hash(seed, id, 1)) - 1.0,
    2.0 * ink::unitDouble(ink::hash(seed, id, 2)) - 1.0 };
}

glm::dvec3 direction(const glm::dvec3& vector)
{
  return glm::dvec3(glm::vec3(glm::normalize(vector)));
}

/// Two planes an element, as if of a surface: in each cluster close to each other, by `spread`.
Items randomPlanes(std::size_t elements, const ink::UnitBall& ball, double spread)
{
  Items items;
  for (std::uint64_t i = 0; i < perElement * elements; ++i)
  {
    const std::uint64_t cluster = i / (perElement * clusterSize);
    const glm::dvec3 position = randomVector(2, cluster) + spread * randomVector(4, i);
    items.push_back({ ball.center + ball.radius / (1.8 * (1.0 + spread)) * position,
      direction(randomVector(1, cluster) + spread * randomVector(3, i)) });
  }
  return items;
}

ink::ClusterPlanes clusterPlanes(const Items& all, std::size_t itemsPerElement, const ink::UnitBall& ball)
{
  return { all.size() / itemsPerElement, itemsPerElement, ball,
    [&all, itemsPerElement](std::size_t begin, std::size_t end, Items& items)
    {
      items.insert(items.end(), all.begin() + static_cast<std::ptrdiff_t>(begin * itemsPerElement),
        all.begin() + static_cast<std::ptrdiff_t>(end * itemsPerElement));
    } };
}

struct Counts
{
  std::size_t straddling = 0;
  std::size_t found = 0;
};

/// Fails where an element straddles in double and is not found.
Counts countStraddling(
  const Items& all, const ink::UnitBall& ball, const ink::Eye& eye, std::size_t itemsPerElement = perElement)
{
  const ink::ClusterPlanes planes = clusterPlanes(all, itemsPerElement, ball);
  const ink::ClusterPlanes::View view(planes, eye);
  Counts counts;
  const std::size_t elements = all.size() / itemsPerElement;
  for (std::size_t element = 0; element < elements; ++element)
  {
    const bool found = (view.straddling(element / clusterSize) >> element % clusterSize & 1) != 0;
    bool sides[2] = { false, false };
    for (std::size_t i = 0; i < itemsPerElement; ++i)
    {
      const auto& [position, normal] = all[element * itemsPerElement + i];
      sides[glm::dot(normal, eye.from(position)) >= 0.0] = true;
    }
    const bool straddles = sides[0] && sides[1];
    EXPECT_TRUE(found || !straddles) << element;
    counts.straddling += straddles;
    counts.found += found;
  }
  return counts;
}

} // namespace

TEST(ClusterPlanes, FindAllElementsThatStraddleAndFewOthers)
{
  // Wherever the surface is and whatever its size.
  for (const ink::UnitBall& ball : { ink::UnitBall{ glm::dvec3(0.0), 1.0 },
         ink::UnitBall{ glm::dvec3(1e7, -2e7, 3e6), 1e-2 }, ink::UnitBall{ glm::dvec3(5.0), 1e9 } })
  {
    for (const double spread : { 0.01, 0.1, 1.0 })
    {
      const Items items = randomPlanes(40'000, ball, spread);
      for (const glm::dvec3& eye :
        { glm::dvec3(2, 1, 3), glm::dvec3(0.1, -0.2, 0.3), glm::dvec3(1e4, 2e4, -1e4) })
      {
        for (const ink::Eye& from :
          { ink::Eye::at(ball.center + ball.radius * eye), ink::Eye::along(1e-3 * eye) })
        {
          const Counts counts = countStraddling(items, ball, from);
          EXPECT_GT(counts.straddling, 50u) << spread;
          EXPECT_LT(static_cast<double>(counts.found), 1.1 * static_cast<double>(counts.straddling) + 20.0)
            << spread;
        }
      }
    }
  }
}

TEST(ClusterPlanes, RuleOutNoPlanesThroughTheEye)
{
  const ink::UnitBall ball;
  const glm::dvec3 eye(2, 1, 3);
  Items items = randomPlanes(8'000, ball, 0.1);
  for (auto& [position, normal] : items)
  {
    normal = direction(glm::cross(eye - position, normal));
  }
  // n.v is 0 but for the rounding of n.
  EXPECT_EQ(countStraddling(items, ball, ink::Eye::at(eye)).found, 8'000u);
}

TEST(ClusterPlanes, RuleOutNothingWithoutNormalsBeyondFloatAndOfManyPlanes)
{
  const ink::UnitBall ball;
  Items items = randomPlanes(3 * clusterSize, ball, 0.1);
  ASSERT_EQ(clusterSize, 8u);
  EXPECT_EQ(countStraddling(items, ball, ink::Eye::at({ 1e200, 1e300, -1e300 })).found, 3 * clusterSize);
  // As of faces that share no points. Beyond the last element there is none.
  items.resize(3 * (clusterSize + 6));
  EXPECT_EQ(countStraddling(items, ball, ink::Eye::at({ 2, 1, 3 }), 3).found, clusterSize + 6);
  const ink::ClusterPlanes planes = clusterPlanes(items, 3, ball);
  EXPECT_EQ(ink::ClusterPlanes::View(planes, ink::Eye::at({ 2, 1, 3 })).straddling(1), 0x3fu);
  for (auto& [position, normal] : items)
  {
    normal = glm::dvec3(0.0);
  }
  EXPECT_EQ(countStraddling(items, ball, ink::Eye::at({ 2, 1, 3 })).found, items.size() / perElement);
}

TEST(ClusterPlanes, ShareEqualPlanesAndTakeFewElements)
{
  // Three items an element, of which all elements of a cluster share two: 10 planes in all.
  const ink::UnitBall ball;
  Items items;
  for (std::uint64_t element = 0; element < 2 * clusterSize + 3; ++element)
  {
    items.push_back({ glm::dvec3(0, 0, 0.1), glm::dvec3(0, 0, 1) });
    items.push_back({ glm::dvec3(0, 0.1, 0), glm::dvec3(0, 1, 0) });
    items.push_back(
      { 0.2 * randomVector(5, element), direction(glm::dvec3(0, 1, 1) + 0.1 * randomVector(6, element)) });
  }
  EXPECT_EQ(countStraddling(items, ball, ink::Eye::at({ 0, 5, 5 }), 3).found, 0u);
  EXPECT_EQ(countStraddling(items, ball, ink::Eye::at({ 0, -5, 5 }), 3).found, items.size() / 3);
}
