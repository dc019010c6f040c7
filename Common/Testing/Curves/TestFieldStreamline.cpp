// SPDX-License-Identifier: BSD-3-Clause
// Lines of curvature on iso-surfaces of fields, without a mesh, against the circles of a torus.

#include "Curves/Streamlines/FieldStreamline.h"

#include "AnalyticFields.h"
#include "StreamlineShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace
{

using namespace ink;

/// A torus that is denser inside, so that curvature is positive around its tube.
struct SolidTorus
{
  ink::testing::Torus torus{ 2.0, 0.7 };

  double value(const glm::dvec3& p) const { return -this->torus.value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return -this->torus.gradient(p); }
  glm::dmat3 hessian(const glm::dvec3& p) const { return -this->torus.hessian(p); }
};

const SolidTorus Tube;
const ink::test::TorusShape Known{ 2.0, 0.7 };

bool anywhere(const glm::dvec3& p)
{
  return std::isfinite(glm::dot(p, p));
}

double deviation(const FieldStreamline& line, bool maximum)
{
  double worst = 0.0;
  for (const glm::dvec3& p : line.positions)
  {
    worst = std::max(worst, Known.deviation(p, line.positions.front(), maximum));
  }
  return worst;
}

} // namespace

TEST(FieldStreamline, LinesOfATorusAreItsCircles)
{
  for (const bool maximum : { true, false })
  {
    FieldTraceOptions options;
    options.maximum = maximum;
    options.step = 0.1;
    options.closeDistance = 0.1;
    // Off the surface: the seed is projected.
    const FieldStreamline line = traceOnField(Tube, { 1.7, 1.5, 0.45 }, options, anywhere);
    EXPECT_TRUE(line.closed);
    ASSERT_GT(line.positions.size(), 40u);
    for (std::size_t i = 0; i < line.positions.size(); ++i)
    {
      EXPECT_LE(std::abs(Tube.value(line.positions[i])), 1e-6 * options.step);
      EXPECT_NEAR(glm::dot(line.normals[i], Tube.gradient(line.positions[i])), -1.0, 1e-12);
    }
    EXPECT_LT(deviation(line, maximum), 1e-3);
    const double around =
      maximum ? 0.7 : std::hypot(line.positions.front().x, line.positions.front().y); // radius of the circle
    const double whole = line.arcLength.back() + glm::distance(line.positions.back(), line.positions.front());
    EXPECT_NEAR(whole, 2.0 * std::numbers::pi * around, 0.02);
  }
}

TEST(FieldStreamline, DeviationFallsWithTheFourthPowerOfTheStep)
{
  // Circles around the axis; those around the tube stay in their plane with any step.
  FieldTraceOptions options;
  options.maximum = false;
  const auto run = [&](double step)
  {
    options.step = step;
    options.tolerance = 1e-10;
    options.maximumLength = 8.0 / step;
    return deviation(traceOnField(Tube, { 2.0, 0.0, 0.7 * 0.999 }, options, anywhere), false);
  };
  const double coarse = run(0.4);
  const double fine = run(0.2);
  EXPECT_GT(coarse, 1e-9);
  EXPECT_LT(fine, coarse / 12.0);
}

TEST(FieldStreamline, LinesEndWhereTheyShould)
{
  FieldTraceOptions options;
  options.step = 0.05;
  options.maximum = false;
  const glm::dvec3 seed(2.7, 0.0, 0.0);
  options.maximumLength = 20.0;
  const FieldStreamline cut = traceOnField(Tube, seed, options, anywhere);
  EXPECT_EQ(cut.positions.size(), 21u);
  EXPECT_EQ(cut.ends[0], LineEnd::Length);

  options.maximumLength = 1000.0;
  const FieldStreamline bounded =
    traceOnField(Tube, seed, options, [](const glm::dvec3& p) { return anywhere(p) && p.x > 1.0; });
  EXPECT_EQ(bounded.ends[0], LineEnd::Border);
  EXPECT_EQ(bounded.ends[1], LineEnd::Border);
  for (const glm::dvec3& p : bounded.positions)
  {
    EXPECT_GT(p.x, 1.0);
  }

  // Nothing but umbilics; nothing at all.
  const ink::testing::Sphere sphere{ glm::dvec3(0.0), 1.0 };
  const FieldStreamline none = traceOnField(sphere, { 1.0, 0.0, 0.0 }, options, anywhere);
  EXPECT_TRUE(none.positions.empty());
  EXPECT_EQ(none.ends[0], LineEnd::Umbilic);
  const ink::testing::Plane plane{ glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0) };
  EXPECT_TRUE(traceOnField(plane, { 0.0, 0.0, 0.0 }, options, anywhere).positions.empty());
  EXPECT_TRUE(traceOnField(sphere, { 0.0, 0.0, 0.0 }, options, anywhere).positions.empty());
}
