// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hash.h"
#include "Curves/Contours/NormalClusters.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using Items = std::vector<ink::NormalCone::Item>;

/// Points of a unit sphere along a spiral from pole to pole, whose turns are as far apart as its points.
Items spiral(std::size_t count, double noise = 0.0)
{
  Items items;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double z = 1.0 - 2.0 * (double(i) + 0.5) / double(count);
    const double angle = std::sqrt(double(count) * glm::pi<double>()) * std::asin(z);
    const double width = std::sqrt(1.0 - z * z);
    const glm::dvec3 p(width * std::cos(angle), width * std::sin(angle), z);
    const glm::dvec3 random(
      ink::unitDouble(ink::hash(1, i)), ink::unitDouble(ink::hash(2, i)), ink::unitDouble(ink::hash(3, i)));
    items.push_back({ p, glm::dvec3(glm::vec3(glm::normalize(p + noise * (random - 0.5)))) });
  }
  return items;
}

ink::NormalClusters clustersOf(const Items& all)
{
  return { all.size(),
    [&](std::size_t begin, std::size_t end, Items& items)
    {
      items.insert(items.end(), all.begin() + static_cast<std::ptrdiff_t>(begin),
        all.begin() + static_cast<std::ptrdiff_t>(end));
    } };
}

/// Slow and obvious.
std::vector<std::uint32_t> straddling(const Items& items, const ink::Eye& eye)
{
  std::vector<std::uint32_t> found;
  constexpr std::size_t size = ink::NormalClusters::clusterSize;
  for (std::size_t begin = 0; begin < items.size(); begin += size)
  {
    bool front = false;
    bool back = false;
    for (std::size_t i = begin; i < std::min(begin + size, items.size()); ++i)
    {
      const bool isFront = glm::dot(items[i].normal, eye.from(items[i].position)) >= 0.0;
      (isFront ? front : back) = true;
    }
    if (front && back)
    {
      found.push_back(static_cast<std::uint32_t>(begin / size));
    }
  }
  return found;
}

} // namespace

TEST(NormalClusters, NamesAllThatStraddleAndFewOthers)
{
  const Items items = spiral(40000);
  const ink::NormalClusters clusters = clustersOf(items);
  ASSERT_EQ(clusters.size(), 40000 / ink::NormalClusters::clusterSize);
  for (const ink::Eye& eye : { ink::Eye::at({ 2, 1, 3 }), ink::Eye::at({ 0.5, 0.7, 0.6 }),
         ink::Eye::at({ 1e5, 2e5, -1e5 }), ink::Eye::along({ 1, -2, 0.5 }) })
  {
    const std::vector<std::uint32_t> found = clusters.straddling(eye);
    const std::vector<std::uint32_t> wanted = straddling(items, eye);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()));
    EXPECT_GT(wanted.size(), 20u);
    EXPECT_LT(found.size(), 3 * wanted.size());
  }
  EXPECT_TRUE(clusters.straddling(ink::Eye::at({ 0.1, 0.2, 0.3 })).empty()); // all are seen from behind
}

TEST(NormalClusters, NamesAllThatStraddleOfNoise)
{
  for (const double noise : { 0.1, 1.0, 10.0 })
  {
    const Items items = spiral(5000, noise);
    const ink::NormalClusters clusters = clustersOf(items);
    for (std::uint64_t id = 0; id < 300; ++id)
    {
      const glm::dvec3 point = 6.0 *
          glm::dvec3(ink::unitDouble(ink::hash(4, id)), ink::unitDouble(ink::hash(5, id)),
            ink::unitDouble(ink::hash(6, id))) -
        3.0;
      const ink::Eye eye = id % 3 == 0 ? ink::Eye::along(point) : ink::Eye::at(point);
      const std::vector<std::uint32_t> found = clusters.straddling(eye);
      const std::vector<std::uint32_t> wanted = straddling(items, eye);
      ASSERT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()))
        << noise << ' ' << id;
    }
  }
}

TEST(NormalClusters, NeverLeavesOutANormalOfZero)
{
  Items items = spiral(100 * ink::NormalClusters::clusterSize);
  for (std::size_t i = 0; i < items.size(); i += ink::NormalClusters::clusterSize)
  {
    items[i].normal = glm::dvec3(0.0);
  }
  EXPECT_EQ(clustersOf(items).straddling(ink::Eye::at({ 2, 1, 3 })).size(), 100u);
}

TEST(NormalClusters, TakesNoneAndOne)
{
  EXPECT_TRUE(ink::NormalClusters().straddling(ink::Eye::at({ 1, 0, 0 })).empty());
  EXPECT_TRUE(clustersOf({}).straddling(ink::Eye::at({ 1, 0, 0 })).empty());
  const Items one = { { glm::dvec3(5.0), glm::dvec3(0, 0, 1) } };
  EXPECT_LE(clustersOf(one).straddling(ink::Eye::along({ 1, 0, -1 })).size(), 1u);
}
