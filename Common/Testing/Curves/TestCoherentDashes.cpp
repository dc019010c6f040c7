// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/CoherentDashes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace
{

/// Closed circles about the z axis, which begin at an angle, with arc length.
ink::Contours circles(const std::vector<double>& radii, double beginsAt, const glm::dvec3& center = {})
{
  constexpr int points = 400;
  ink::Contours contours;
  for (const double radius : radii)
  {
    for (int i = 0; i < points; ++i)
    {
      const double angle = beginsAt + 2.0 * std::numbers::pi * i / points;
      contours.positions.push_back(center + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
      contours.arcLength.push_back(i == 0 ? 0.0
                                          : contours.arcLength.back() +
            glm::distance(contours.positions.back(), contours.positions[contours.positions.size() - 2]));
    }
    contours.chains.offsets.push_back(contours.positions.size());
    contours.chains.closed.push_back(1);
    contours.kinds.push_back(ink::ContourKind::Silhouette);
  }
  return contours;
}

/// Of a circle with a whole number of dashes, by how much of a period the dash at an angle has moved.
double slideAt(const ink::Contours& contours, std::size_t chain, double angle, double radius, double period)
{
  const std::size_t begin = contours.chains.offsets[chain];
  const glm::dvec3& first = contours.positions[begin];
  const double away = angle - std::atan2(first.y, first.x);
  const double circumference = 800.0 * radius * std::sin(std::numbers::pi / 400.0);
  const double fitted = circumference / std::round(circumference / period);
  const double phase = (contours.arcLength[begin] + circumference * away / (2.0 * std::numbers::pi)) / fitted;
  return std::abs(phase - std::round(phase));
}

} // namespace

TEST(CoherentDashes, StayWhereverAChainBegins)
{
  const double period = 0.1;
  for (const glm::dvec3& center : { glm::dvec3(0.0), glm::dvec3(1e7, -1e7, 1e7) })
  {
    ink::CoherentDashes dashes;
    ink::Contours contours = circles({ 1.0, 0.5 }, 0.0, center);
    const std::vector<double> before = contours.arcLength;
    dashes.align(contours, period, 0.05);
    EXPECT_EQ(contours.arcLength, before); // there is no frame before
    for (const double beginsAt : { 0.03, 0.5, 2.0, 2.01 })
    {
      contours = circles({ 1.0, 0.5 }, beginsAt, center);
      const std::vector<double> own = contours.arcLength;
      dashes.align(contours, period, 0.05);
      if (center == glm::dvec3(0.0))
      {
        // A dash begins at angle 0 for ever.
        EXPECT_LT(slideAt(contours, 0, 0.0, 1.0, period), 0.1) << beginsAt;
        EXPECT_LT(slideAt(contours, 1, 0.0, 0.5, period), 0.1) << beginsAt;
      }
      // Each chain as a whole, by a period at most.
      for (std::size_t i = 1; i < 400; ++i)
      {
        EXPECT_NEAR(contours.arcLength[i] - own[i], contours.arcLength[0] - own[0], 1e-12);
      }
      EXPECT_LE(std::abs(contours.arcLength[0] - own[0]), 0.51 * period);
    }
  }
}

TEST(CoherentDashes, OnlyFollowWhatIsNear)
{
  ink::CoherentDashes dashes;
  ink::Contours contours = circles({ 1.0 }, 0.0);
  dashes.align(contours, 0.1, 0.05);
  contours = circles({ 1.2 }, 0.03);
  const std::vector<double> own = contours.arcLength;
  dashes.align(contours, 0.1, 0.05);
  EXPECT_EQ(contours.arcLength, own);
  // And not what has been forgotten.
  contours = circles({ 1.2 }, 0.06);
  dashes.reset();
  dashes.align(contours, 0.1, 0.05);
  EXPECT_EQ(contours.arcLength, circles({ 1.2 }, 0.06).arcLength);
  ink::Contours none;
  dashes.align(none, 0.1, 0.05);
  dashes.align(none, 0.1, 0.05);
  EXPECT_TRUE(none.arcLength.empty());
}

TEST(CoherentDashes, OfOpenLinesStayWhereTheseGrow)
{
  const auto line = [](double from)
  {
    ink::Contours contours;
    for (int i = 0; i <= 200; ++i)
    {
      contours.positions.emplace_back(from + 0.005 * i, 0.0, 0.0);
      contours.arcLength.push_back(0.005 * i);
    }
    contours.chains.offsets.push_back(201);
    contours.chains.closed.push_back(0);
    contours.kinds.push_back(ink::ContourKind::Silhouette);
    return contours;
  };
  const double period = 0.13;
  ink::CoherentDashes dashes;
  ink::Contours contours = line(0.0);
  dashes.align(contours, period, 0.02);
  for (const double from : { 0.035, 0.11, -0.2 })
  {
    contours = line(from);
    dashes.align(contours, period, 0.02);
    // A dash begins at 0 still, but for what is beyond the line before, whose nearest point is its end
    // (measured .003 of a period).
    const double phase = (contours.arcLength[0] - from) / period;
    EXPECT_NEAR(phase, std::round(phase), 0.01) << from;
  }
  // Creases do not move, and stay as they are.
  contours = line(0.05);
  contours.kinds[0] = ink::ContourKind::Crease;
  const std::vector<double> own = contours.arcLength;
  dashes.align(contours, period, 0.02);
  EXPECT_EQ(contours.arcLength, own);
}
