// SPDX-License-Identifier: BSD-3-Clause
#include "SampledVolume.h"

#include "AnalyticFields.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{

using ink::testing::Volume;
const double nan = std::numeric_limits<double>::quiet_NaN();

double quadratic(const glm::dvec3& p)
{
  return 1.0 + 2.0 * p.x - p.y + 0.5 * p.z + p.x * p.x - 0.5 * p.y * p.y + 0.25 * p.z * p.z +
    0.75 * p.x * p.y - 0.5 * p.y * p.z + 1.5 * p.x * p.z;
}
glm::dvec3 quadraticGradient(const glm::dvec3& p)
{
  return { 2.0 + 2.0 * p.x + 0.75 * p.y + 1.5 * p.z, -1.0 - p.y + 0.75 * p.x - 0.5 * p.z,
    0.5 + 0.5 * p.z - 0.5 * p.y + 1.5 * p.x };
}
const glm::dmat3 quadraticHessian(2.0, 0.75, 1.5, 0.75, -1.0, -0.5, 1.5, -0.5, 0.5);

void expectNear(const glm::dmat3& a, const glm::dmat3& b, double tolerance)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LT(glm::distance(a[axis], b[axis]), tolerance) << "column " << axis;
  }
}

TEST(GridField, IsExactForQuadratics)
{
  // Central differences of a quadratic are exact inside, and so is the interpolation of its linear gradient.
  const ink::GridGeometry g({ 9, 8, 7 }, { -2, 1, 3 }, { 0.5, 0.25, 2.0 });
  const auto volume = Volume<double>::from(g, quadratic);
  const auto field = volume.field();
  for (const glm::dvec3& index :
    { glm::dvec3(1, 1, 1), glm::dvec3(3.25, 4.5, 2.75), glm::dvec3(6.9, 5.9, 4.9) })
  {
    const glm::dvec3 p = g.toWorld(index);
    EXPECT_LT(glm::distance(field.gradient(p), quadraticGradient(p)), 1e-11);
    expectNear(field.hessian(p), quadraticHessian, 1e-11);
  }
  const glm::dvec3 sample = g.toWorld({ 4, 3, 2 });
  EXPECT_NEAR(field.value(sample), quadratic(sample), 1e-12);
  const glm::dvec3 next = g.toWorld({ 5, 3, 2 });
  EXPECT_NEAR(field.value(0.5 * (sample + next)), 0.5 * (quadratic(sample) + quadratic(next)), 1e-12);
}

TEST(GridField, IsOneSidedAtTheBorder)
{
  const ink::GridGeometry g({ 5, 5, 5 });
  const auto plane = Volume<double>::from(g, [](const glm::dvec3& p) { return 3 * p.x - 2 * p.y + p.z; });
  for (const glm::dvec3& p : { glm::dvec3(0, 0, 0), glm::dvec3(4, 4, 4), glm::dvec3(0, 2, 4) })
  {
    EXPECT_LT(glm::distance(plane.field().gradient(p), glm::dvec3(3, -2, 1)), 1e-12);
  }
  const auto volume = Volume<double>::from(g, quadratic);
  expectNear(volume.field().hessian({ 0, 0, 0 }), quadraticHessian, 1e-11);
  expectNear(volume.field().hessian({ 4, 4, 4 }), quadraticHessian, 1e-11);
}

TEST(GridField, TakesTheNearestPointOutside)
{
  const ink::GridGeometry g({ 3, 3, 3 });
  const auto volume = Volume<float>::from(g, [](const glm::dvec3& p) { return p.x; });
  EXPECT_EQ(volume.field().value({ -5, 1, 1 }), 0.0);
  EXPECT_EQ(volume.field().value({ 9, 9, 9 }), 2.0);
}

TEST(GridField, MissingSamplesSpreadNoFurtherThanTheirCells)
{
  const ink::GridGeometry g({ 6, 6, 6 });
  auto volume = Volume<double>::from(g, [](const glm::dvec3& p) { return 2 * p.x + p.y; });
  volume.at({ 3, 3, 3 }) = nan;
  volume.at({ 1, 1, 1 }) = std::numeric_limits<double>::infinity();
  const auto field = volume.field();
  EXPECT_TRUE(std::isnan(field.value({ 2.5, 2.5, 2.5 })));
  EXPECT_TRUE(std::isnan(field.gradient({ 2.5, 2.5, 2.5 }).x));
  EXPECT_TRUE(std::isnan(field.hessian({ 2.5, 2.5, 2.5 })[0][1]));
  EXPECT_TRUE(std::isnan(field.value({ 1, 1, 1 })));
  EXPECT_TRUE(std::isnan(field.value({ nan, 0, 0 })));
  // Beside it the difference is one-sided, and on the face of a broken cell nothing broken is needed.
  EXPECT_LT(glm::distance(field.gradient({ 4, 3, 3 }), glm::dvec3(2, 1, 0)), 1e-12);
  EXPECT_NEAR(field.value({ 2, 2.5, 2.5 }), 2 * 2 + 2.5, 1e-12);
}

TEST(GridField, HiddenSamplesAreMissing)
{
  const ink::GridGeometry g({ 5, 1, 1 });
  auto volume = Volume<int>::from(g, [](const glm::dvec3& p) { return p.x; });
  volume.at({ 2, 0, 0 }) = 1000;
  const std::vector<std::uint8_t> marks{ 0, 0, 2, 1, 0 };
  const auto field = volume.field({ marks, 2 });
  EXPECT_TRUE(std::isnan(field.value({ 2, 0, 0 })));
  EXPECT_EQ(field.value({ 3, 0, 0 }), 3.0);
  EXPECT_EQ(field.gradient({ 1, 0, 0 }), glm::dvec3(1, 0, 0));
}

TEST(GridField, IsFlatAcrossOneSlice)
{
  const ink::GridGeometry g({ 5, 5, 1 });
  const auto field = Volume<double>::from(g, [](const glm::dvec3& p) { return p.x * p.x + p.y; }).values;
  const ink::GridField<double> slice(g, std::span<const double>(field));
  EXPECT_LT(glm::distance(slice.gradient({ 2, 2, 0 }), glm::dvec3(4, 1, 0)), 1e-12);
  expectNear(slice.hessian({ 2, 2, 0 }), glm::dmat3(2, 0, 0, 0, 0, 0, 0, 0, 0), 1e-12);
}

TEST(GridField, ReadsInterleavedComponents)
{
  const std::vector<short> values{ 0, 10, 1, 20, 2, 30 };
  const ink::GridField<short> field({ { 3, 1, 1 } }, std::span<const short>(values).subspan(1), 2);
  EXPECT_EQ(field.value({ 0.5, 0, 0 }), 15.0);
  EXPECT_EQ(field.gradient({ 1, 0, 0 }), glm::dvec3(10, 0, 0));
}

template <class T>
void expectSlopeAtTheLimits()
{
  using Limits = std::numeric_limits<T>;
  const ink::GridGeometry g({ 3, 1, 1 });
  // From the lowest value to the highest: the step itself is not a T.
  const std::vector<T> whole{ Limits::lowest(), T(0), Limits::max() };
  const ink::GridField<T> wide(g, std::span<const T>(whole));
  const double half = 0.5 * static_cast<double>(Limits::max()) - 0.5 * static_cast<double>(Limits::lowest());
  EXPECT_NEAR(wide.gradient({ 1, 0, 0 }).x / half, 1.0, 1e-6);
  if constexpr (Limits::is_integer)
  {
    // One apart at the upper end, where a 64-bit value is no double.
    const std::vector<T> fine{ T(Limits::max() - 2), T(Limits::max() - 1), Limits::max() };
    const ink::GridField<T> close(g, std::span<const T>(fine));
    EXPECT_EQ(close.gradient({ 1, 0, 0 }).x, 1.0);
    EXPECT_EQ(close.gradient({ 0, 0, 0 }).x, 1.0);
  }
}

TEST(GridField, HoldsAtTheLimitsOfEveryType){
#define EXPECT_FOR(T)                                                                                        \
  {                                                                                                          \
    SCOPED_TRACE(#T);                                                                                        \
    expectSlopeAtTheLimits<T>();                                                                             \
  }
  INK_FOR_EACH_SCALAR(EXPECT_FOR)
#undef EXPECT_FOR
}

TEST(GridField, RejectsShortSpans)
{
  const ink::GridGeometry g({ 2, 2, 2 });
  const std::vector<float> seven(7);
  EXPECT_THROW(ink::GridField<float>(g, std::span<const float>(seven)), std::invalid_argument);
  const std::vector<float> eight(8);
  EXPECT_THROW(ink::GridField<float>(g, std::span<const float>(eight), 0), std::invalid_argument);
  EXPECT_THROW(ink::GridField<float>(g, std::span<const float>(eight), 2), std::invalid_argument);
  const std::vector<std::uint8_t> marks(7);
  EXPECT_THROW(
    ink::GridField<float>(g, std::span<const float>(eight), 1, { marks, 1 }), std::invalid_argument);
  EXPECT_TRUE(std::isnan(ink::GridField<float>({ { 0, 2, 2 } }, {}).value({ 0, 0, 0 })));
}

template <class F>
void expectDerivatives(const F& field, const glm::dvec3& p)
{
  constexpr double h = 1e-4;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 step(0.0);
    step[axis] = h;
    EXPECT_NEAR(field.gradient(p)[axis], (field.value(p + step) - field.value(p - step)) / (2 * h), 1e-7);
    EXPECT_LT(
      glm::distance(field.hessian(p)[axis], (field.gradient(p + step) - field.gradient(p - step)) / (2 * h)),
      1e-7);
  }
}

TEST(AnalyticFields, HaveTheirOwnDerivatives)
{
  const glm::dvec3 p(1.3, -0.4, 0.6);
  expectDerivatives(ink::testing::Plane{ { 1, 2, 3 }, { 0.5, -1, 2 } }, p);
  expectDerivatives(ink::testing::Sphere{ { 0.1, 0.2, 0.3 }, 1.0 }, p);
  expectDerivatives(ink::testing::Torus{ 1.0, 0.3 }, p);
}

} // namespace
