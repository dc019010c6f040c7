// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/CoherentDashes.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
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

/// Of a circle about the z axis, by how much of a period the dash at an angle has moved from there.
double slideAt(const ink::Contours& contours, std::size_t chain, double angle, double period)
{
  const std::size_t begin = contours.chains.offsets[chain];
  double least = 10.0;
  double phase = 0.0;
  for (std::size_t i = begin; i < contours.chains.offsets[chain + 1]; ++i)
  {
    const double away = std::remainder(
      std::atan2(contours.positions[i].y, contours.positions[i].x) - angle, 2.0 * std::numbers::pi);
    if (std::abs(away) < std::abs(least))
    {
      least = away;
      const double radius = glm::length(glm::dvec2(contours.positions[i]));
      phase = (contours.arcLength[i] - radius * away) / period;
    }
  }
  return std::abs(phase - std::round(phase));
}

/// A line along x of 200 segments.
ink::Contours line(double from, double length = 1.0)
{
  ink::Contours contours;
  for (int i = 0; i <= 200; ++i)
  {
    contours.positions.emplace_back(from + length * i / 200.0, 0.0, 0.0);
    contours.arcLength.push_back(length * i / 200.0);
  }
  contours.chains.offsets.push_back(201);
  contours.chains.closed.push_back(0);
  contours.kinds.push_back(ink::ContourKind::Silhouette);
  return contours;
}

/// The greatest deviation of the dashes' lengths from the period, relative.
double unevenness(const ink::Contours& contours)
{
  double worst = 0.0;
  for (std::size_t i = 1; i < contours.positions.size(); ++i)
  {
    const double step = glm::distance(contours.positions[i], contours.positions[i - 1]);
    worst = std::max(worst, std::abs((contours.arcLength[i] - contours.arcLength[i - 1]) / step - 1.0));
  }
  return worst;
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
      dashes.align(contours, period, 0.05);
      for (const std::size_t chain : { 0, 1 })
      {
        const std::size_t begin = contours.chains.offsets[chain];
        const std::size_t last = contours.chains.offsets[chain + 1] - 1;
        const double whole = contours.arcLength[last] - contours.arcLength[begin] +
          glm::distance(contours.positions[begin], contours.positions[last]);
        EXPECT_NEAR(whole / period, chain == 0 ? 63.0 : 31.0, 1e-4) << "a whole number of dashes";
        if (center == glm::dvec3(0.0))
        {
          // A dash begins at angle 0 for ever, and so do others where they were.
          EXPECT_LT(slideAt(contours, chain, 0.0, period), 0.1) << beginsAt;
          for (int dash = 1; dash < 30; ++dash)
          {
            const double angle = 2.0 * std::numbers::pi * dash / std::round(whole / period);
            EXPECT_LT(slideAt(contours, chain, angle, period), 0.1) << beginsAt << ", dash " << dash;
          }
        }
      }
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
  const double period = 0.13;
  ink::CoherentDashes dashes;
  ink::Contours contours = line(0.0);
  dashes.align(contours, period, 0.02);
  for (const double from : { 0.035, 0.11, -0.2 })
  {
    contours = line(from);
    dashes.align(contours, period, 0.02);
    // A dash begins at 0 still, but for what is beyond the line before, whose nearest point is its end
    // (measured .012 of a period).
    const double phase = (contours.arcLength[0] - from) / period;
    EXPECT_NEAR(phase, std::round(phase), 0.02) << from;
  }
  // Creases do not move, and stay as they are.
  contours = line(0.05);
  contours.kinds[0] = ink::ContourKind::Crease;
  const std::vector<double> own = contours.arcLength;
  dashes.align(contours, period, 0.02);
  EXPECT_EQ(contours.arcLength, own);
}

/// What is stretched: dashes stay at their points, but for a slip where that takes none longer or shorter
/// than by a part, and become even again where all rests.
TEST(CoherentDashes, GiveWayToStretching)
{
  const double period = 0.1;
  ink::CoherentDashes dashes;
  ink::Contours contours = line(0.0);
  dashes.align(contours, period, 0.2);
  contours = line(0.0, 1.03);
  dashes.align(contours, period, 0.2);
  // Ten dashes would end .3 of a period too early: that is shared out.
  EXPECT_LT(std::abs(contours.arcLength[0]) / period, 0.1);
  EXPECT_GT(unevenness(contours), 0.0);
  EXPECT_LT(unevenness(contours), 0.1);
  const double uneven = unevenness(contours);
  for (int frame = 0; frame < 50; ++frame)
  {
    contours = line(0.0, 1.03);
    dashes.align(contours, period, 0.2);
  }
  EXPECT_LT(unevenness(contours), 0.5 * uneven);
}

/// Parts of a chain that were others keep their dashes each; between them, dashes give way.
TEST(CoherentDashes, OfLinesThatJoinStayInBoth)
{
  const double period = 0.1;
  ink::CoherentDashes dashes;
  ink::Contours contours = line(0.0);
  ink::appendContours(contours, line(1.04), { false, false, true, false });
  dashes.align(contours, period, 0.05);
  ink::Contours joined = line(0.0, 2.04);
  dashes.align(joined, period, 0.05);
  const auto phaseAt = [&](double x)
  { return joined.arcLength[static_cast<std::size_t>(x / 2.04 * 200.0)] / period - x / period; };
  EXPECT_NEAR(phaseAt(0.0), std::round(phaseAt(0.0)), 0.05);
  EXPECT_NEAR(phaseAt(0.5), std::round(phaseAt(0.5)), 0.05);
  const double second = phaseAt(1.5) + 1.04 / period;
  EXPECT_NEAR(second, std::round(second), 0.05) << "as of the line that began at 1.04";
  EXPECT_LT(unevenness(joined), 0.3);
}

/// Dashes of another length, as the eye comes nearer, are shifted only as a whole.
TEST(CoherentDashes, OfAnotherPeriodKeepTheirLengths)
{
  ink::CoherentDashes dashes;
  ink::Contours contours = line(0.0);
  dashes.align(contours, 0.1, 0.2);
  contours = line(0.013);
  dashes.align(contours, 0.105, 0.2);
  EXPECT_NE(contours.arcLength[0], 0.0);
  EXPECT_LT(unevenness(contours), 1e-9);
}
