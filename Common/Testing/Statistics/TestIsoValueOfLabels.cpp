// SPDX-License-Identifier: BSD-3-Clause
// Segmentations and masks, and what is none.
#include "IsoValueVolumes.h"
#include "Statistics/IsoValue.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace
{

using namespace ink::testing::iso;
using Boundary = ink::IsoSuggestion::Boundary;

/// Sectors of a ball, each with a number of its own.
double label(const glm::ivec3& p, double radius)
{
  const glm::dvec3 d = glm::dvec3(p) - 0.5 * (size - 1);
  const int sector = static_cast<int>((std::atan2(d.y, d.x) + 3.2) * 3.0) + 20 * (d.z > 0.0 ? 1 : 0);
  return glm::length(d) < radius ? 7.0 + 3.0 * sector : 0.0;
}

TEST(IsoValueOfLabels, IsTheEdgeOfAll)
{
  std::vector<unsigned char> labels;
  std::size_t inside = 0;
  unsigned char least = 255;
  for (int i = 0; i < size * size * size; ++i)
  {
    labels.push_back(static_cast<unsigned char>(label({ i % size, i / size % size, i / size / size }, 16.0)));
    inside += labels.back() > 0 ? 1 : 0;
    least = labels.back() > 0 ? std::min(least, labels.back()) : least;
  }
  const auto all = suggestAll(labels);
  ASSERT_EQ(all.size(), 1U) << "between labels there is none";
  EXPECT_EQ(all[0].boundary, Boundary::Labels);
  EXPECT_DOUBLE_EQ(all[0].keptShare, static_cast<double>(inside) / static_cast<double>(labels.size()));
  EXPECT_DOUBLE_EQ(all[0].value, 0.5 * least);
  const std::set<unsigned char> different(labels.begin(), labels.end());
  EXPECT_EQ(all[0].labels, static_cast<std::int64_t>(different.size()) - 1) << "but the background";
}

TEST(IsoValueOfLabels, AMaskIsOneLabel)
{
  const auto all = suggestAll(volume<float>([](double d, std::size_t) { return d < 14 ? 3.0 : -1.0; }));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].boundary, Boundary::Labels);
  EXPECT_EQ(all[0].value, 1.0);
  EXPECT_EQ(all[0].labels, 1);
}

TEST(IsoValueOfLabels, ManyLabelsAreCounted)
{
  // Blocks of 2 x 2 x 2 voxels, behind four of them of background.
  constexpr int side = 96;
  constexpr int blocks = side / 2;
  std::vector<int> labels;
  for (int i = 0; i < side * side * side; ++i)
  {
    const int block = (i / side / side / 2 * blocks + i / side % side / 2) * blocks + i % side / 2;
    labels.push_back(i % side < 8 ? 0 : 1 + block * 7919 % (blocks * blocks * blocks));
  }
  const auto all = ink::suggestIsoValues<int>(labels, { side, side, side });
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].labels, blocks * blocks * (blocks - 4));
}

TEST(IsoValueOfLabels, IsTheEdgeOfAllAlsoWhereTheyLieFarApart)
{
  // As the ids of an atlas: the range has fewer bins than there are numbers between the first two labels.
  std::vector<unsigned int> labels;
  std::size_t inside = 0;
  for (int i = 0; i < size * size * size; ++i)
  {
    const double number = label({ i % size, i / size % size, i / size / size }, 16.0);
    labels.push_back(number == 0.0 ? 0U : 15000U + 90000U * static_cast<unsigned int>(number * number));
    labels.back() = labels.back() > 120000000U ? 15000U : labels.back();
    inside += labels.back() > 0 ? 1 : 0;
  }
  const auto suggestion = suggest(labels);
  ASSERT_TRUE(suggestion);
  EXPECT_EQ(suggestion->boundary, Boundary::Labels);
  EXPECT_DOUBLE_EQ(suggestion->keptShare, static_cast<double>(inside) / static_cast<double>(labels.size()));
  EXPECT_DOUBLE_EQ(suggestion->value,
    0.5 *
      *std::min_element(labels.begin(), labels.end(),
        [](unsigned int a, unsigned int b) { return b == 0 ? a != 0 : a != 0 && a < b; }));
}

TEST(IsoValueOfLabels, FewGrayLevelsAreNoLabels)
{
  // Of 24 levels, with hardly any noise in the one of the background.
  const auto values = volume<float>([](double d, std::size_t i)
    { return std::max(std::round(22 * blurredSphere(d, 16) + 0.45 * noise(i)), 0.0) / 32.0; });
  expectBetween(suggest(values), Boundary::Outermost, 8.0 / 32.0, 14.0 / 32.0);
}

TEST(IsoValueOfLabels, AScanBehindAMaskHasNoLabels)
{
  const auto values = volume<short>(
    [](double d, std::size_t i) { return d < 18 ? 300 + 700 * blurredSphere(d, 12) + 10 * noise(i) : 0.0; });
  for (const ink::IsoSuggestion& suggestion : suggestAll(values))
  {
    EXPECT_NE(suggestion.boundary, Boundary::Labels);
    EXPECT_EQ(suggestion.labels, 0);
  }
}

} // namespace
