// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/LengthPriority.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace
{

/// Straight chains along x from the origin, of these lengths, or closed squares of this circumference.
ink::Contours makeChains(const std::vector<double>& lengths, bool closed = false)
{
  ink::Contours contours;
  for (const double length : lengths)
  {
    const double side = length / 4.0;
    const std::vector<glm::dvec3> points = closed
      ? std::vector<glm::dvec3>{ { 0, 0, 0 }, { side, 0, 0 }, { side, side, 0 }, { 0, side, 0 } }
      : std::vector<glm::dvec3>{ { 0, 0, 0 }, { length / 3.0, 0, 0 }, { length, 0, 0 } };
    const std::vector<double> arcs = closed ? std::vector<double>{ 0.0, side, 2.0 * side, 3.0 * side }
                                            : std::vector<double>{ 0.0, length / 3.0, length };
    contours.positions.insert(contours.positions.end(), points.begin(), points.end());
    contours.arcLength.insert(contours.arcLength.end(), arcs.begin(), arcs.end());
    contours.chains.offsets.push_back(contours.positions.size());
    contours.chains.closed.push_back(closed);
    contours.kinds.push_back(ink::ContourKind::Silhouette);
  }
  return contours;
}

} // namespace

TEST(ContoursLengthPriority, IsTheShareOfLongerChains)
{
  for (const bool closed : { false, true })
  {
    const std::vector<float> found = ink::lengthPriorities(makeChains({ 1, 4, 3, 2 }, closed));
    const std::vector<float> expected{ 0.9f, 0.0f, 0.4f, 0.7f };
    for (std::size_t chain = 0; chain < expected.size(); ++chain)
    {
      EXPECT_FLOAT_EQ(found[chain], expected[chain]) << chain;
    }
  }
}

TEST(ContoursLengthPriority, EqualChainsAreInTheirOrder)
{
  EXPECT_EQ(
    ink::lengthPriorities(makeChains({ 2, 2, 2, 2 })), (std::vector<float>{ 0.0f, 0.25f, 0.5f, 0.75f }));
}

TEST(ContoursLengthPriority, IsLessThanOneAlsoOfChainsWithoutALength)
{
  EXPECT_TRUE(ink::lengthPriorities({}).empty());
  EXPECT_EQ(ink::lengthPriorities(makeChains({ 0, 0 })), (std::vector<float>{ 0.0f, 0.0f }));
  for (const float priority : ink::lengthPriorities(makeChains({ 1e-30, 0, 1, 1e9 })))
  {
    EXPECT_LT(priority, 1.0f);
  }
}
